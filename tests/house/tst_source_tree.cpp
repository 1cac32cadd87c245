// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct SourceFile {
  std::string path;  ///< from the root of the project
  std::vector<std::string> lines;

  [[nodiscard]] bool isHeader() const { return path.ends_with(".h"); }
  [[nodiscard]] bool isCpp() const { return isHeader() || path.ends_with(".cpp"); }
  [[nodiscard]] std::string layer() const { return path.substr(0, path.find('/')); }
  [[nodiscard]] bool in(const std::string& folder) const { return path.starts_with(folder + "/"); }
};

struct Include {
  const SourceFile* file;
  std::string name;
  bool quoted;
};

const std::vector<std::string> kFolders{"app",   "include", "core", "gui",   "io",        "render",
                                        "tests", "bench",   "fuzz", "cmake", "packaging", ".ci"};

std::vector<SourceFile> readTree() {
  std::vector<SourceFile> files;
  const fs::path root = ANGIOMESH_SOURCE_DIR;
  const auto add = [&](const fs::path& path) {
    const std::string name = path.filename().string();
    const std::string extension = path.extension().string();
    if (extension != ".h" && extension != ".cpp" && extension != ".sh" && extension != ".cmake" &&
        name != "CMakeLists.txt" && path.parent_path().filename() != ".ci")
      return;
    SourceFile file{fs::relative(path, root).generic_string(), {}};
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) file.lines.push_back(line);
    files.push_back(std::move(file));
  };
  add(root / "CMakeLists.txt");
  for (const std::string& folder : kFolders) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file()) add(entry.path());
  }
  return files;
}

std::vector<Include> includesOf(const std::vector<SourceFile>& files) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const SourceFile& file : files) {
    if (!file.isCpp()) continue;
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (std::regex_search(line, match, pattern))
        includes.push_back({&file, match[2], match[1] == "\""});
    }
  }
  return includes;
}

bool matches(const std::string& text, const char* pattern) {
  return std::regex_search(text, std::regex(pattern));
}

/// Which rooms of its own layer a room may include, beside itself. docs/architecture.md has the
/// same table with what lives there.
const std::map<std::string, std::string> kMayInclude{
    {"core/base", ""},
    {"core/image", "base"},
    {"core/mesh", "base"},
    {"core/field", "base image"},
    {"core/preprocess", "base image field"},
    {"core/vesselness", "base image"},
    {"core/phantom", "base image mesh"},
    {"core/levelset", "base image vesselness"},
    {"core/topology", "base image field"},
    {"core/distance", "base image field"},
    {"core/lumen", "base image field distance vesselness topology"},
    {"core/centreline", "base image field"},
    {"core/openings", "base image field mesh distance centreline"},
    {"core/measure", "base image field mesh centreline openings"},
    {"core/sizing", "base field openings"},
    {"core/contour", "base image field mesh openings"},
    {"core/cuts", "base image field mesh distance centreline openings contour"},
    {"core/front", "base field mesh openings sizing contour"},
    {"core/remesh", "base field mesh openings sizing contour"},
    {"core/smooth", "base field mesh openings contour remesh"},
    {"core/surface", "base field mesh openings sizing contour cuts front remesh"},
    {"core/quality", "base image field mesh sizing phantom"},
    {"core/corrections", "base image field vesselness distance topology centreline"},
    {"core/parameters",
     "base preprocess vesselness levelset topology lumen sizing contour cuts smooth surface "
     "corrections"},
    {"core/pipeline",
     "base image field mesh preprocess vesselness phantom levelset topology distance lumen "
     "centreline openings sizing contour cuts front remesh smooth surface quality measure "
     "corrections parameters"},
    {"core/preview", "base image preprocess pipeline"},
    {"core/sensitivity", "base image field mesh centreline contour parameters pipeline"},
    {"io/file", ""},
    {"io/volume", "file"},
    {"io/dicom", "file volume"},
    {"io/scan", "file volume dicom"},
    {"io/mesh", "file"},
    {"io/vessel", "file mesh"},
    {"io/case", "file volume scan"},
    {"io/recipe", "file"},
    {"render/stage", ""},
    {"render/marks", "stage"},
    {"render/slice", "stage marks"},
    {"render/surface", "stage marks slice"},
    {"render/picture", "stage surface"},
    {"gui/job", ""},
    {"gui/model", "job"},
    {"gui/findings", "job model"},
    {"gui/view", "model"},
    {"gui/pane", "job model findings view"},
    {"gui/panel", "job model findings view pane"},
    {"gui/inspector", "job model findings view panel"},
    {"gui/dialog", "job model findings view pane panel"},
    {"gui/report", "job model findings view pane panel inspector"},
    {"gui/menu", "job model findings view pane panel dialog"},
    {"gui", "job model findings view pane panel inspector report dialog menu"},
    {"app/session", ""},
    {"app/study", "session"},
    {"app/cli", "session study"},
    {"app/angiomesh", ""},
    {"app/display", ""},
};

/// "core/mesh" of "core/mesh/tri_mesh.h", "gui" of "gui/main_window.h".
std::string roomOf(const std::string& path) { return path.substr(0, path.rfind('/')); }

/// Of the classes whose member functions a file defines, outside its unnamed namespaces.
std::set<std::string> classesDefinedIn(const SourceFile& file) {
  static const std::regex member(
      R"(^(?:[A-Za-z][\w:<>,&*\[\] ]*?[ &*])?([A-Z]\w*(?:::[A-Z]\w*)*)::~?\w+\()");
  std::set<std::string> classes;
  bool unnamed = false;
  for (const std::string& line : file.lines) {
    if (line == "namespace {") unnamed = true;
    if (line == "}  // namespace") unnamed = false;
    std::smatch match;
    if (!unnamed && std::regex_search(line, match, member) &&
        line.find('=') > line.find(match.str(1)))
      classes.insert(match[1]);
  }
  return classes;
}

}  // namespace

// The rules of CONTRIBUTING.md that a text search can check.
class TestSourceTree : public QObject {
  Q_OBJECT

 private:
  std::vector<SourceFile> files_;
  std::vector<Include> includes_;

  /// Fails with the list of the includes for which `broken` holds.
  template <class Rule>
  void verifyIncludes(const char* rule, Rule broken) {
    std::string list;
    for (const Include& include : includes_)
      if (broken(include)) list += "\n  " + include.file->path + " includes " + include.name;
    QVERIFY2(list.empty(), (rule + list).c_str());
  }

  template <class Rule>
  void verifyFiles(const char* rule, Rule broken) {
    std::string list;
    for (const SourceFile& file : files_)
      if (broken(file)) list += "\n  " + file.path;
    QVERIFY2(list.empty(), (rule + list).c_str());
  }

 private Q_SLOTS:
  void initTestCase() {
    files_ = readTree();
    includes_ = includesOf(files_);
    QVERIFY(files_.size() > 50);
    QVERIFY(includes_.size() > 200);
  }

  void layersIncludeDownwardsOnly() {
    const std::map<std::string, std::string> allowed{
        {"core", "^core/"},
        {"io", "^(io|core)/"},
        {"render", "^(render|core)/"},
        {"gui", "^(gui|render|io|core)/"},
        {"app", "^(app|gui|render|io|core)/"},
    };
    verifyIncludes("a layer includes its own files and those below it, by their path from the root",
                   [&](const Include& include) {
                     const auto layer = allowed.find(include.file->layer());
                     return include.quoted && layer != allowed.end() &&
                            !matches(include.name, layer->second.c_str());
                   });
  }

  void roomsIncludeWhatTheirRowsName() {
    verifyFiles("every folder with sources of the product has its row", [](const SourceFile& file) {
      return file.isCpp() && matches(file.path, "^(core|io|render|gui|app)/") &&
             kMayInclude.count(roomOf(file.path)) == 0;
    });
    verifyIncludes("a room includes itself and the rooms of its row", [](const Include& include) {
      const auto row = kMayInclude.find(roomOf(include.file->path));
      const std::string layer = include.file->layer();
      if (row == kMayInclude.end() || !include.quoted || !include.name.starts_with(layer + "/"))
        return false;
      const std::string room = roomOf(include.name);
      if (room == row->first) return false;
      const std::string within = room == layer ? room : room.substr(layer.size() + 1);
      return (" " + row->second + " ").find(" " + within + " ") == std::string::npos;
    });
    for (const auto& [room, row] : kMayInclude) {
      const bool there = std::any_of(files_.begin(), files_.end(), [&](const SourceFile& file) {
        return file.isCpp() && roomOf(file.path) == room;
      });
      QVERIFY2(there, ("there is no room " + room).c_str());
    }
  }

  void roomsGoOneWay() {
    // With what each row names struck off that includes nothing that is left, none may stay.
    std::map<std::string, std::string> left = kMayInclude;
    const auto hasNone = [&](const auto& entry) {
      const auto& [room, row] = entry;
      std::istringstream words(row);
      const std::string layer = room.substr(0, room.find('/'));
      for (std::string word; words >> word;)
        if (left.count(word == layer ? layer : layer + "/" + word) != 0) return false;
      return true;
    };
    while (!left.empty()) {
      const auto next = std::find_if(left.begin(), left.end(), hasNone);
      QVERIFY2(next != left.end(), ("rooms in a circle with " + left.begin()->first).c_str());
      left.erase(next);
    }
  }

  void roomsAreOfReadableSize() {
    std::map<std::string, std::set<std::string>> units;
    std::map<std::string, std::size_t> lines;
    std::size_t core = 0;
    for (const SourceFile& file : files_) {
      if (!file.isCpp()) continue;
      units[roomOf(file.path)].insert(fs::path(file.path).stem().string());
      if (!file.in("core")) continue;
      lines[roomOf(file.path)] += file.lines.size();
      core += file.lines.size();
    }
    for (const auto& [room, names] : units)
      QVERIFY2(names.size() <= 20, (room + " has more than 20 units").c_str());
    for (const auto& [room, count] : lines)
      QVERIFY2(count * 100 < core * 12, (room + " has 12 % of core's lines or more").c_str());
  }

  void classesStandInOneFile() {
    std::map<std::string, std::set<std::string>> places;
    for (const SourceFile& file : files_)
      if (file.path.ends_with(".cpp") && matches(file.path, "^(core|io|render|gui|app)/"))
        for (const std::string& name : classesDefinedIn(file)) places[name].insert(file.path);
    std::string list;
    for (const auto& [name, paths] : places) {
      if (paths.size() < 2) continue;
      list += "\n  " + name + " in";
      for (const std::string& path : paths) list += " " + path;
    }
    QVERIFY2(list.empty(), ("a class has one .cpp" + list).c_str());
  }

  void qtStaysInGuiAndApp() {
    verifyIncludes("core, io and render have no Qt", [](const Include& include) {
      return matches(include.file->path, "^(core|io|render)/") &&
             matches(include.name, "^Q[A-Za-z]");
    });
    verifyFiles("core, io and render do not link Qt", [](const SourceFile& file) {
      if (!matches(file.path, "^(core|io|render)/.*CMakeLists.txt$")) return false;
      for (const std::string& line : file.lines)
        if (line.find("Qt6::") != std::string::npos) return true;
      return false;
    });
    verifyIncludes("whole Qt modules are not included", [](const Include& include) {
      return matches(include.name, "^Qt(Widgets|Gui|Core|OpenGL|Charts)(/Qt[A-Z]\\w*)?$");
    });
  }

  void vtkStaysBehindItsLayers() {
    verifyIncludes("VTK belongs to render, gui/view and .cpp files of core and io",
                   [](const Include& include) {
                     if (!matches(include.name, "^vtk")) return false;
                     const SourceFile& file = *include.file;
                     const bool mayShow = file.in("render") || file.in("gui/view") ||
                                          file.in("tests") || file.in("bench") || file.in("fuzz");
                     return !mayShow && !(matches(file.path, "^(core|io)/") && !file.isHeader());
                   });
    verifyIncludes("vtkSMPTools.h does not compile as C++20 with GCC 12",
                   [](const Include& include) { return include.name == "vtkSMPTools.h"; });
  }

  void librariesStayInsideSourceFiles() {
    verifyIncludes(
        "ITK, OpenMesh, TBB, DCMTK and JSON appear in .cpp files of core and io alone (JSON and "
        "option parsing in app too)",
        [](const Include& include) {
          const SourceFile& file = *include.file;
          if (file.in("tests") || file.in("bench") || file.in("fuzz")) return false;
          const bool inside = matches(file.path, "^(core|io)/") && !file.isHeader();
          if (matches(include.name, "^(nlohmann/|CLI/)")) return !inside && !file.in("app");
          return matches(include.name,
                         "^(itk|gdcm|OpenMesh/|tbb/|oneapi/|dcmtk/|nanoflann|xxhash)") &&
                 !inside;
        });
    verifyIncludes("headers of core show the standard library and Eigen alone",
                   [](const Include& include) {
                     return include.file->in("core") && include.file->isHeader() &&
                            !include.quoted && !matches(include.name, "^(Eigen/.*|[a-z_]+)$");
                   });
    verifyIncludes("code under the GPL is for tests and benchmarks alone",
                   [](const Include& include) {
                     return !matches(include.file->path, "^(tests|bench)/") &&
                            matches(include.name, "^(CGAL/|fftw|itk.*FFT|QtCharts)");
                   });
  }

  void resultsDoNotDependOnTheProcessor() {
    // The C library takes these by processor, and what they give differs: see
    // core/base/exact_math.h. Here only the words of a message depend on them, or a file of
    // settings.
    std::set<std::string> excepted{"io/dicom/dicom_geometry.cpp", "io/mesh/mesh_io.cpp",
                                   "io/vessel/openfoam_case.cpp", "io/volume/geometry_check.cpp",
                                   "io/volume/nifti_header.cpp"};
    static const std::regex call(
        R"(\b(a?(sin|cos|tan)h?|atan2|exp(2|m1)?|log(2|10|1p)?|pow|cbrt|hypot|erfc?|[tl]gamma)[fl]?\s*\(|)"
        R"(AngleAxis|eulerAngles|slerp|computeDirect|std::(polar|arg|\w+_distribution))");
    static const std::regex words("\"(\\\\.|[^\"\\\\])*\"|//.*");
    verifyFiles(
        "results depend on a function that depends on the processor", [&](const SourceFile& file) {
          return file.isCpp() && (file.in("core") || file.in("io")) &&
                 std::any_of(file.lines.begin(), file.lines.end(),
                             [](const std::string& line) {
                               return std::regex_search(std::regex_replace(line, words, ""), call);
                             }) &&
                 excepted.erase(file.path) == 0;
        });
    for (const std::string& path : excepted)
      QVERIFY2(false, (path + " is excepted for nothing").c_str());
    // What is compiled for more than one processor has a build without, to compare with.
    const auto plain = std::find_if(files_.begin(), files_.end(), [](const SourceFile& file) {
      return file.path == "tests/app/CMakeLists.txt";
    });
    QVERIFY(plain != files_.end());
    verifyIncludes("not built for angiomesh-cli-plain", [&](const Include& include) {
      return include.name == "core/base/simd.h" &&
             std::none_of(plain->lines.begin(), plain->lines.end(), [&](const std::string& line) {
               return line.find(include.file->path) != std::string::npos;
             });
    });
  }

  void filesAreOfReadableLength() {
    verifyFiles("a file has at most 600 lines",
                [](const SourceFile& file) { return file.lines.size() > 600; });
  }

  void filesNameTheirLicence() {
    verifyFiles(
        "the first line (the second of a script) is the SPDX line", [](const SourceFile& file) {
          const std::size_t at = !file.lines.empty() && file.lines[0].starts_with("#!") ? 1 : 0;
          return file.lines.size() <= at ||
                 !matches(file.lines[at], "^(//|#) SPDX-License-Identifier: BSD-3-Clause$");
        });
  }

  void headersAreIncludedOnceAndFirstByTheirOwnFile() {
    verifyFiles("a header has #pragma once", [](const SourceFile& file) {
      return file.isHeader() &&
             std::find(file.lines.begin(), file.lines.end(), "#pragma once") == file.lines.end();
    });
    verifyFiles("a file's own header comes first", [this](const SourceFile& file) {
      if (!file.path.ends_with(".cpp")) return false;
      const std::string own = file.path.substr(0, file.path.size() - 4) + ".h";
      const bool exists = std::any_of(files_.begin(), files_.end(),
                                      [&](const SourceFile& f) { return f.path == own; });
      if (!exists) return false;
      const auto first = std::find_if(includes_.begin(), includes_.end(),
                                      [&](const Include& i) { return i.file->path == file.path; });
      return first == includes_.end() || first->name != own;
    });
  }

  void filesAreNamedAsAgreed() {
    verifyFiles("file names are lower_snake, and none is a manager, utils or helper",
                [](const SourceFile& file) {
                  if (!file.isCpp()) return false;
                  const std::string name = fs::path(file.path).stem().string();
                  return !matches(name, "^[a-z0-9_]+$") ||
                         matches(name, "(^|_)(manager|utils?|helpers?)(_|$)");
                });
  }
};

QTEST_GUILESS_MAIN(TestSourceTree)
#include "tst_source_tree.moc"
