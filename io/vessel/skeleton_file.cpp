// SPDX-License-Identifier: BSD-3-Clause
#include "io/vessel/skeleton_file.h"

#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "io/file/files.h"
#include "io/file/mesh_text.h"
#include "io/mesh/mesh_io.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

bool isCsv(const fs::path& path) { return path.extension() == ".csv"; }

std::string csvText(const Skeleton& skeleton) {
  std::string text =
      "branch,component,from_node,to_node,from_kind,to_kind,length_mm,mean_radius_mm,"
      "min_radius_mm,max_radius_mm,from_x_lps_mm,from_y_lps_mm,from_z_lps_mm,to_x_lps_mm,"
      "to_y_lps_mm,to_z_lps_mm\n";
  for (std::size_t n = 0; n < skeleton.branches.size(); ++n) {
    const SkeletonBranch& branch = skeleton.branches[n];
    const auto kind = [&](int node) {
      return nodeKindName(skeleton.nodes[static_cast<std::size_t>(node)].kind);
    };
    text += std::to_string(n) + ',' + std::to_string(branch.component) + ',' +
            std::to_string(branch.from) + ',' + std::to_string(branch.to) + ',' +
            kind(branch.from) + ',' + kind(branch.to);
    const auto add = [&](double value) {
      text += ',';
      appendShortest(text, value);
    };
    for (const double value :
         {branch.lengthMm, branch.meanRadiusMm, branch.minRadiusMm, branch.maxRadiusMm})
      add(value);
    for (const SkeletonPoint* end : {&branch.points.front(), &branch.points.back()})
      for (int a = 0; a < 3; ++a) add(end->pointLps[a]);
    text += '\n';
  }
  return text;
}

/// Text of VTK's XML format, a value at a time.
class VtpText {
 public:
  void open(const std::string& tag) { text_ += '<' + tag + ">\n"; }
  void close(const std::string& name) { text_ += "</" + name + ">\n"; }

  /// An array of what visit(add) adds.
  template <class T, class Visit>
  void array(const std::string& attributes, Visit visit) {
    constexpr bool isReal = std::is_floating_point_v<T>;
    text_ += std::string("<DataArray type=\"") + (isReal ? "Float64" : "Int32") +
             "\" format=\"ascii\" " + attributes + ">\n";
    visit([this](T value) {
      appendShortest(text_, value);
      text_ += '\n';
    });
    close("DataArray");
  }

  /// A string of the whole data: its characters' codes and a 0.
  void word(const std::string& name, const std::string& value) {
    text_ +=
        "<Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"1\" format=\"ascii\">\n";
    for (const char c : value) text_ += std::to_string(static_cast<int>(c)) + ' ';
    text_ += "0\n</Array>\n";
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_ = "<?xml version=\"1.0\"?>\n";
};

template <class Value>
void addOfPoints(VtpText& vtp, const Skeleton& skeleton, const char* name, Value value) {
  vtp.array<double>(std::string("Name=\"") + name + '"', [&](auto add) {
    for (const SkeletonBranch& branch : skeleton.branches)
      for (const SkeletonPoint& point : branch.points) add(value(point));
  });
}

template <class T, class Value>
void addOfBranches(VtpText& vtp, const Skeleton& skeleton, const char* name, Value value) {
  vtp.array<T>(std::string("Name=\"") + name + '"', [&](auto add) {
    for (const SkeletonBranch& branch : skeleton.branches) add(value(branch));
  });
}

void addLines(VtpText& vtp, const Skeleton& skeleton, std::int32_t points) {
  vtp.open("Points");
  vtp.array<double>("Name=\"Points\" NumberOfComponents=\"3\"", [&](auto add) {
    for (const SkeletonBranch& branch : skeleton.branches)
      for (const SkeletonPoint& point : branch.points)
        for (int a = 0; a < 3; ++a) add(point.pointLps[a]);
  });
  vtp.close("Points");
  vtp.open("Lines");
  vtp.array<std::int32_t>("Name=\"connectivity\"", [&](auto add) {
    for (std::int32_t n = 0; n < points; ++n) add(n);
  });
  std::int32_t end = 0;
  addOfBranches<std::int32_t>(vtp, skeleton, "offsets", [&](const SkeletonBranch& branch) {
    return end += static_cast<std::int32_t>(branch.points.size());
  });
  vtp.close("Lines");
}

std::string vtpText(const Skeleton& skeleton) {
  std::int32_t points = 0;
  for (const SkeletonBranch& branch : skeleton.branches)
    points += static_cast<std::int32_t>(branch.points.size());
  VtpText vtp;
  vtp.open("VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"");
  vtp.open("PolyData");
  vtp.open("FieldData");
  vtp.word("SPACE", frameWord(Frame::Lps));
  vtp.word("UNIT", unitWord(LengthUnit::Millimetre));
  vtp.close("FieldData");
  vtp.open("Piece NumberOfPoints=\"" + std::to_string(points) +
           "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(skeleton.branches.size()) +
           "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\"");
  vtp.open("PointData Scalars=\"Radius\"");
  addOfPoints(vtp, skeleton, "Radius", [](const SkeletonPoint& p) { return p.radiusMm; });
  addOfPoints(vtp, skeleton, "MaximumInscribedSphereRadius",
              [](const SkeletonPoint& p) { return p.inscribedMm; });
  vtp.close("PointData");
  vtp.open("CellData Scalars=\"BranchId\"");
  for (const char* name : {"BranchId", "GroupIds"}) {
    std::int32_t number = 0;
    addOfBranches<std::int32_t>(vtp, skeleton, name,
                                [&](const SkeletonBranch&) { return number++; });
  }
  using Branch = const SkeletonBranch&;
  addOfBranches<std::int32_t>(vtp, skeleton, "ComponentId", [](Branch b) { return b.component; });
  addOfBranches<std::int32_t>(vtp, skeleton, "FromNode", [](Branch b) { return b.from; });
  addOfBranches<std::int32_t>(vtp, skeleton, "ToNode", [](Branch b) { return b.to; });
  addOfBranches<double>(vtp, skeleton, "Length", [](Branch b) { return b.lengthMm; });
  addOfBranches<double>(vtp, skeleton, "MeanRadius", [](Branch b) { return b.meanRadiusMm; });
  vtp.close("CellData");
  addLines(vtp, skeleton, points);
  for (const char* name : {"Piece", "PolyData", "VTKFile"}) vtp.close(name);
  return vtp.text();
}

}  // namespace

const char* nodeKindName(NodeKind kind) {
  switch (kind) {
    case NodeKind::Tip:
      return "tip";
    case NodeKind::Junction:
      return "junction";
    case NodeKind::Border:
      return "border";
    case NodeKind::Ring:
      break;
  }
  return "ring";
}

void checkSkeletonFile(const fs::path& path) {
  if (!isCsv(path) && path.extension() != ".vtp")
    throw InputError("centre lines cannot be written in this format", path.string(),
                     "give .csv or .vtp");
}

void writeSkeleton(const Skeleton& skeleton, const fs::path& path) {
  checkSkeletonFile(path);
  writeText(path, isCsv(path) ? csvText(skeleton) : vtpText(skeleton));
}

}  // namespace angiomesh
