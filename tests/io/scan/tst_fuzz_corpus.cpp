// SPDX-License-Identifier: BSD-3-Clause
#include <QElapsedTimer>
#include <QTest>
#include <algorithm>
#include <vector>

#include "fuzz/fuzz_case.h"
#include "fuzz/fuzz_labels.h"
#include "fuzz/fuzz_parameters.h"
#include "fuzz/fuzz_readers.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

/// What the fuzzers start from and what they found once: none of it may break a reader again.
class TestFuzzCorpus : public QObject {
  Q_OBJECT

  using Reader = void (*)(const std::uint8_t* data, std::size_t size);

  static void goThrough(const char* target, Reader read) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fs::path(ANGIOMESH_FUZZ_CORPUS) / target))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    QVERIFY(files.size() > 20);
    for (const fs::path& file : files) {
      const std::string bytes = bytesOf(file);
      const std::string name = file.filename().string();
      const double before = peakMb();
      QElapsedTimer clock;
      clock.start();
      std::string fault;
      TerminalCapture terminal;
      try {
        read(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      } catch (const std::exception& error) {
        fault = error.what();
      }
      const QString said = terminal.text();
      QVERIFY2(fault.empty(), (name + ": " + fault).c_str());
      QVERIFY2(said.isEmpty(), (name + ": " + said.toStdString()).c_str());
      QVERIFY2(clock.elapsed() < 5000, (name + " takes long").c_str());
      QVERIFY2(peakMb() < before + 500.0, (name + " takes much memory").c_str());
    }
  }

 private Q_SLOTS:
  void dicom() { goThrough("fuzz_dicom", fuzz::readDicomInput); }
  void images() { goThrough("fuzz_image", fuzz::readImageInput); }
  void meshes() { goThrough("fuzz_mesh", fuzz::readMeshInput); }
  void labels() { goThrough("fuzz_labels", fuzz::readLabelsInput); }
  void cases() { goThrough("fuzz_case", fuzz::readCaseInput); }
  void parameters() { goThrough("fuzz_parameters", fuzz::readParametersInput); }
};

QTEST_APPLESS_MAIN(TestFuzzCorpus)
#include "tst_fuzz_corpus.moc"
