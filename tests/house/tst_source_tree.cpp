// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
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

const std::vector<std::string> kFolders{"app",   "core", "gui",   "io",        "render", "tests",
                                        "bench", "fuzz", "cmake", "packaging", ".ci"};

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
