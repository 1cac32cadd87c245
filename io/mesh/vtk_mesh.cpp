// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataCompressor.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <exception>

#include "core/base/error.h"
#include "io/file/quiet_terminal.h"
#include "io/mesh/cut_polygon.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/polygon_mesh.h"
#include "io/mesh/vtp_data.h"

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

void addField(vtkPolyData* data, const char* name, const std::vector<std::string>& texts) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts) array->InsertNextValue(text);
  data->GetFieldData()->AddArray(array);
}

/// As SimVascular has them: its faces count from 1.
void addPatches(vtkPolyData* data, const WritableMesh& mesh) {
  vtkNew<vtkIntArray> faces;
  faces->SetName(kFaceId);
  for (const std::uint16_t patch : mesh.mesh.patch) faces->InsertNextValue(patch + 1);
  data->GetCellData()->AddArray(faces);
  addField(data, kFaceNames, mesh.patchNames);
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

/// Empty where VTK does not manage.
CornerTriangles cutWithVtk(const std::vector<Eigen::Vector3d>& corners, vtkPolygon* cell,
                           vtkIdList* list) {
  const auto count = static_cast<vtkIdType>(corners.size());
  cell->Points->SetNumberOfPoints(count);
  cell->PointIds->SetNumberOfIds(count);
  for (vtkIdType c = 0; c < count; ++c) {
    cell->Points->SetPoint(c, corners[static_cast<std::size_t>(c)].data());
    cell->PointIds->SetId(c, c);
  }
  list->Reset();
  CornerTriangles triangles;
  if (cell->Triangulate(list) == 0 || list->GetNumberOfIds() != 3 * (count - 2)) return triangles;
  const auto corner = [&](vtkIdType i) { return static_cast<std::uint32_t>(list->GetId(i)); };
  for (vtkIdType t = 0; t + 2 < count; ++t)
    triangles.push_back({corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)});
  return triangles;
}

}  // namespace

PolygonMesh readVtkPolyData(const std::string& bytes, const fs::path& path) {
  if (bytes.starts_with("# vtk DataFile")) return readLegacyVtk(bytes, path);
  if (bytes.substr(0, 1000).find("<VTKFile") != std::string::npos) return readVtp(bytes, path);
  throw InputError("not a VTK file", path.string(), "give " + meshEndings(false));
}

void appendStrip(const std::vector<std::uint32_t>& strip,
                 std::vector<std::vector<std::uint32_t>>& polygons) {
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    const std::size_t odd = i % 2;
    polygons.push_back({strip[i], strip[i + 1 + odd], strip[i + 2 - odd]});
  }
}

bool unpackWithVtk(const std::string& packer, std::string_view packed, std::size_t size,
                   std::string& bytes) {
  vtkSmartPointer<vtkDataCompressor> compressor;
  if (packer == "vtkLZ4DataCompressor") compressor = vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (packer == "vtkLZMADataCompressor") compressor = vtkSmartPointer<vtkLZMADataCompressor>::New();
  if (compressor == nullptr || size == 0 || packed.empty()) return false;
  bytes.resize(size);
  return succeeds([&] {
    return compressor->Uncompress(reinterpret_cast<const unsigned char*>(packed.data()),
                                  packed.size(), reinterpret_cast<unsigned char*>(bytes.data()),
                                  size) == size;
  });
}

CutPolygons triangulate(const PolygonMesh& mesh) {
  CutPolygons result;
  vtkNew<vtkPolygon> cell;
  vtkNew<vtkIdList> list;
  std::vector<Eigen::Vector3d> corners;
  for (const std::vector<std::uint32_t>& polygon : mesh.polygons) {
    if (polygon.size() == 3) {
      result.triangles.push_back({polygon[0], polygon[1], polygon[2]});
      continue;
    }
    corners.clear();
    for (const std::uint32_t corner : polygon) corners.push_back(mesh.points[corner]);
    CornerTriangles cut = cutWithVtk(corners, cell, list);
    // VTK stops at corners that lie at one place.
    if (cut.empty() || foldsOver(corners, cut)) {
      CornerTriangles ears = cutByEars(corners);
      if (!ears.empty()) cut = std::move(ears);
    }
    // A polygon that cannot be cut becomes a fan: the surface stays closed.
    for (std::uint32_t t = 1; cut.size() + 2 < corners.size(); ++t) cut.push_back({0, t, t + 1});
    if (foldsOver(corners, cut)) ++result.folded;
    for (const auto& [a, b, c] : cut)
      result.triangles.push_back({polygon[a], polygon[b], polygon[c]});
  }
  return result;
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
  for (const auto& [name, values] : options.pointValues) {
    const vtkSmartPointer<vtkFloatArray> array = namedArray(name.c_str(), 1, values.size());
    for (std::size_t v = 0; v < values.size(); ++v)
      array->SetValue(static_cast<vtkIdType>(v), values[v]);
    data->GetPointData()->AddArray(array);
  }
  if (!mesh.mesh.patch.empty()) addPatches(data, mesh);
  addField(data, "SPACE", {frameWord(options.frame)});
  addField(data, "UNIT", {unitWord(options.unit)});
  if (const std::string key = cleanKey(options.key); !key.empty()) addField(data, "KEY", {key});
  vtkNew<vtkXMLPolyDataWriter> writer;
  if (!succeeds([&] {
        writer->SetInputData(data);
        writer->SetFileName(path.c_str());
        return writer->Write() != 0 && writer->GetErrorCode() == 0;
      }))
    throw IoError("cannot write the mesh", path.string(), "check the folder and the free space");
}

}  // namespace angiomesh
