// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "io/mesh_number.h"
#include "io/polygon_mesh.h"
#include "io/quiet_terminal.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

/// Takes VTK's messages and remembers that there was one: some failures show in no other way.
class MessageCatcher : public vtkOutputWindow {
 public:
  static MessageCatcher* New() {
    auto* catcher = new MessageCatcher;
    catcher->InitializeObjectBase();
    return catcher;
  }
  void DisplayText(const char*) override { caught_ = true; }
  void DisplayErrorText(const char*) override { caught_ = true; }
  void DisplayWarningText(const char*) override { caught_ = true; }
  void DisplayGenericWarningText(const char*) override { caught_ = true; }
  void DisplayDebugText(const char*) override {}
  [[nodiscard]] bool caught() const { return caught_; }

 private:
  bool caught_ = false;
};

/// Calls `work` with VTK silent. False when VTK had something to say or threw.
template <class Work>
bool succeeds(const Work& work) {
  const QuietTerminal quiet;
  const vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  const vtkNew<MessageCatcher> messages;
  vtkOutputWindow::SetInstance(messages.Get());
  bool fine = true;
  try {
    fine = work();
  } catch (const std::exception&) {
    fine = false;
  }
  vtkOutputWindow::SetInstance(before);
  return fine && !messages->caught();
}

std::string fieldText(vtkPolyData* data, const char* name) {
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  return array != nullptr && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : "";
}

void addField(vtkPolyData* data, const char* name, const std::string& text) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  data->GetFieldData()->AddArray(array);
}

vtkSmartPointer<vtkPoints> toVtk(const std::vector<Eigen::Vector3d>& from) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(from.size()));
  for (std::size_t i = 0; i < from.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), from[i].data());
  return points;
}

vtkSmartPointer<vtkFloatArray> namedArray(const char* name, int components, std::size_t tuples) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

template <class Polygon>
void addPolygon(vtkCellArray* cells, const Polygon& polygon) {
  cells->InsertNextCell(static_cast<int>(polygon.size()));
  for (const std::uint32_t corner : polygon) cells->InsertCellPoint(static_cast<vtkIdType>(corner));
}

std::uint32_t pointNumber(vtkIdType id) {
  // What does not fit is out of range of any mesh that is read, and refused there.
  const auto largest = std::numeric_limits<std::uint32_t>::max();
  return id < 0 || id > static_cast<vtkIdType>(largest) ? largest : static_cast<std::uint32_t>(id);
}

void appendCells(vtkCellArray* cells, PolygonMesh& mesh) {
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    cells->GetCellAtId(c, ids);
    std::vector<std::uint32_t> polygon;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      polygon.push_back(pointNumber(ids->GetId(i)));
    if (polygon.size() >= 3) mesh.polygons.push_back(std::move(polygon));
  }
}

PolygonMesh fromVtk(vtkPolyData* data) {
  PolygonMesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
    Eigen::Vector3d p;
    data->GetPoint(i, p.data());
    mesh.points.push_back(p);
  }
  appendCells(data->GetPolys(), mesh);
  if (data->GetNumberOfStrips() > 0) {
    vtkNew<vtkCellArray> triangles;
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < data->GetNumberOfStrips(); ++c) {
      data->GetStrips()->GetCellAtId(c, ids);
      for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); ++i) {
        const vtkIdType odd = i % 2;
        addPolygon(triangles, std::array<std::uint32_t, 3>{pointNumber(ids->GetId(i)),
                                                           pointNumber(ids->GetId(i + 1 + odd)),
                                                           pointNumber(ids->GetId(i + 2 - odd))});
      }
    }
    appendCells(triangles, mesh);
  }
  for (const char* name : {"SPACE", "UNIT", "KEY"})
    mesh.header.read(std::string(name) + "=" + fieldText(data, name));
  mesh.hasNormals = data->GetPointData()->GetNormals() != nullptr;
  mesh.hasQuality = data->GetCellData()->HasArray("quality") != 0 ||
                    data->GetPointData()->HasArray("quality") != 0;
  return mesh;
}

/// The list of the cells' beginnings comes from the file too.
void checkCells(vtkPolyData* data, const fs::path& path) {
  if (!data->GetPolys()->IsValid() || !data->GetStrips()->IsValid()) throwTruncated(path);
}

/// Whether the file can hold as many points and cells as its pieces announce: VTK reserves memory
/// for them first. zlib packs no more than 1032 bytes into one.
bool countsAreCredible(const std::string& xml) {
  const bool packed = xml.substr(0, 1000).find("compressor=") != std::string::npos;
  const double most = static_cast<double>(xml.size()) * (packed ? 1032.0 : 1.0);
  for (std::size_t at = xml.find("NumberOf"); at != std::string::npos;
       at = xml.find("NumberOf", at)) {
    at = xml.find_first_of("=>", at);
    if (at == std::string::npos || xml[at] == '>' || at + 2 >= xml.size()) continue;
    double count = 0.0;
    const std::size_t end = std::min(xml.find(xml[at + 1], at + 2), xml.size());
    TextScanner number(std::string_view(xml).substr(at + 2, end - at - 2));
    if (!number.number(count) || !(count >= 0.0) || count > most) return false;
  }
  return true;
}

/// VTK's reader crashes on an array of a type that it does not know.
bool arrayTypesAreKnown(const std::string& xml) {
  static const std::set<std::string> types = {"String", "Bit",    "Int8",    "UInt8",
                                              "Int16",  "UInt16", "Int32",   "UInt32",
                                              "Int64",  "UInt64", "Float32", "Float64"};
  for (std::size_t at = xml.find("Array "); at != std::string::npos; at = xml.find("Array ", at)) {
    const std::size_t end = xml.find('>', at);
    const std::string tag = xml.substr(at, end == std::string::npos ? end : end - at);
    const std::size_t type = tag.find(" type=");
    if (type == std::string::npos || type + 7 >= tag.size()) return false;
    const std::size_t close = tag.find(tag[type + 6], type + 7);
    if (close == std::string::npos || types.count(tag.substr(type + 7, close - type - 7)) == 0)
      return false;
    at += tag.size();
  }
  return true;
}

PolygonMesh readXml(const std::string& bytes, const fs::path& path) {
  if (bytes.substr(0, 1000).find("PolyData") == std::string::npos)
    throw InputError("the VTK file does not hold a surface", path.string(),
                     "give a .vtp file (PolyData)");
  if (bytes.rfind("</VTKFile>") == std::string::npos || !arrayTypesAreKnown(bytes) ||
      !countsAreCredible(bytes))
    throwTruncated(path);
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!succeeds([&] {
        reader->ReadFromInputStringOn();
        reader->SetInputString(bytes);
        reader->Update();
        return reader->GetErrorCode() == 0 && reader->GetOutput() != nullptr;
      }))
    throwTruncated(path);
  checkCells(reader->GetOutput(), path);
  return fromVtk(reader->GetOutput());
}

}  // namespace

PolygonMesh readVtkPolyData(const std::string& bytes, const fs::path& path) {
  if (bytes.starts_with("# vtk DataFile")) return readLegacyVtk(bytes, path);
  if (bytes.substr(0, 1000).find("<VTKFile") != std::string::npos) return readXml(bytes, path);
  throw InputError("not a VTK file", path.string(), "give .ply, .stl, .obj, .vtp or .vtk");
}

std::vector<std::array<std::uint32_t, 3>> triangulate(const PolygonMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  vtkNew<vtkPolygon> cell;
  vtkNew<vtkIdList> cut;
  for (const std::vector<std::uint32_t>& polygon : mesh.polygons) {
    if (polygon.size() == 3) {
      triangles.push_back({polygon[0], polygon[1], polygon[2]});
      continue;
    }
    const auto corners = static_cast<vtkIdType>(polygon.size());
    cell->Points->SetNumberOfPoints(corners);
    cell->PointIds->SetNumberOfIds(corners);
    for (vtkIdType c = 0; c < corners; ++c) {
      cell->Points->SetPoint(c, mesh.points[polygon[static_cast<std::size_t>(c)]].data());
      cell->PointIds->SetId(c, c);
    }
    cut->Reset();
    const bool fine = cell->Triangulate(cut) != 0 && cut->GetNumberOfIds() == 3 * (corners - 2);
    for (vtkIdType t = 0; t + 2 < corners; ++t) {
      // A polygon too degenerate to be cut by ears becomes a fan: the surface stays closed.
      const auto corner = [&](vtkIdType i) {
        const vtkIdType at = fine ? cut->GetId(3 * t + i) : (i == 0 ? 0 : t + i);
        return polygon[static_cast<std::size_t>(at)];
      };
      triangles.push_back({corner(0), corner(1), corner(2)});
    }
  }
  return triangles;
}

void writeVtp(const WritableMesh& mesh, const fs::path& path) {
  const MeshWriteOptions& options = mesh.options;
  vtkNew<vtkPolyData> data;
  data->SetPoints(toVtk(mesh.mesh.points));
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : mesh.mesh.triangles) addPolygon(cells, triangle);
  data->SetPolys(cells);
  if (!mesh.normals.empty()) {
    const vtkSmartPointer<vtkFloatArray> normals = namedArray("Normals", 3, mesh.normals.size());
    for (std::size_t v = 0; v < mesh.normals.size(); ++v)
      normals->SetTuple(static_cast<vtkIdType>(v), mesh.normals[v].data());
    data->GetPointData()->SetNormals(normals);
  }
  if (!mesh.quality.empty()) {
    const vtkSmartPointer<vtkFloatArray> quality = namedArray("quality", 1, mesh.quality.size());
    for (std::size_t t = 0; t < mesh.quality.size(); ++t)
      quality->SetTuple(static_cast<vtkIdType>(t), &mesh.quality[t]);
    data->GetCellData()->SetScalars(quality);
  }
  addField(data, "SPACE", frameWord(options.frame));
  addField(data, "UNIT", unitWord(options.unit));
  if (const std::string key = cleanKey(options.key); !key.empty()) addField(data, "KEY", key);
  vtkNew<vtkXMLPolyDataWriter> writer;
  if (!succeeds([&] {
        writer->SetInputData(data);
        writer->SetFileName(path.c_str());
        return writer->Write() != 0 && writer->GetErrorCode() == 0;
      }))
    throw IoError("cannot write the mesh", path.string(), "check the folder and the free space");
}

}  // namespace angiomesh
