// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QStandardPaths>
#include <QString>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "core/base/formatted.h"
#include "core/base/parallel.h"
#include "core/pipeline/report.h"
#include "gui/language.h"
#include "gui/main_window.h"
#include "gui/theme.h"
#include "gui/view/open_gl.h"
#include "io/volume/image_format.h"

namespace angiomesh {
namespace {

int start(int argc, char** argv) {
  CLI::App cli("The vessel surface of an angiography volume.", "angiomesh");
  std::string input;
  bool sample = false;
  bool run = false;
  int threadCount = 0;
  std::string language;
  cli.add_option(
      "INPUT", input,
      "a volume (" + joined(imageEndings(false)) + "), a folder with a series, or a case");
  cli.add_flag("--sample", sample, "open the built-in sample, a noisy vascular tree");
  cli.add_flag("--run", run, "run the pipeline once the input is loaded");
  std::vector<std::string> codes;
  for (const Language& known : languages()) codes.push_back(known.code.toStdString());
  cli.add_option("--language", language,
                 "of the window: " + joined(codes) +
                     "; by default the one chosen in it, else the "
                     "system's")
      ->check(CLI::IsMember(codes));
  cli.add_option("--threads", threadCount, "number of threads; 0: all cores")
      ->check(CLI::Range(0, 1024));
  cli.set_version_flag("--version", versionText());
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& wrong) {
    return cli.exit(wrong) == 0 ? 0 : 2;
  }
  prepareOpenGl();
  QApplication application(argc, argv);
  QApplication::setOrganizationName("Angiomesh");
  QApplication::setApplicationName("Angiomesh");
  QApplication::setApplicationVersion(versionText());
  QApplication::setDesktopFileName("angiomesh");

  applyLanguage(language.empty() ? rememberedLanguage() : QString::fromStdString(language));
  applyTheme(rememberedTheme());

  setThreads(threadCount);

  MainWindowOptions options;
  options.recovery =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString() + "/recovery";
  MainWindow window(options);
  window.show();
  if (window.offerRestore()) return QApplication::exec();
  if (!input.empty())
    window.open(QString::fromStdString(input), run);
  else if (sample || run)
    window.openSample(run);
  return QApplication::exec();
}

}  // namespace
}  // namespace angiomesh

int main(int argc, char** argv) {
  try {
    return angiomesh::start(argc, argv);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "angiomesh: %s\n", failure.what());
    return 1;
  }
}
