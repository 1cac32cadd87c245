// SPDX-License-Identifier: BSD-3-Clause
#include <QAction>
#include <QMessageBox>

#include "io/scan/mask_file.h"
#include "tests/gui/window_case.h"
#include "tests/io/dicom_writer.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// A series of a patient whose name is written in another character set.
struct Series {
  Series() {
    saveSeries(folder.path(), [](Slice& slice) {
      slice.edit = [](DcmDataset& data) {
        putText(data, DCM_SpecificCharacterSet, "ISO_IR 100");
        putText(data, DCM_PatientName, "M\xfcller^J\xf6rg^Karl=Mueller^Joerg");
        putText(data, DCM_PatientID, "P <77>");
        putText(data, DCM_PatientBirthDate, "19511203");
        putText(data, DCM_StudyDate, "20200131");
        putText(data, DCM_StudyDescription, "head\x1b with contrast");
      };
      return true;
    });
  }
  [[nodiscard]] QString path() const { return QString::fromStdString(folder.path().string()); }
  const Folder folder;
};

}  // namespace

class TestIdentity : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theHeaderIsReadAsTheScreenNeedsIt() {
    const Series series;
    const DicomIdentityTexts found = readIdentity({series.folder.path(), {}, {}});
    QCOMPARE(QString::fromStdString(found.name), QString::fromUtf8("Müller, Jörg Karl"));
    QCOMPARE(found.id, std::string("P <77>"));
    QCOMPARE(found.birthDate, std::string("1951-12-03"));
    QCOMPARE(found.studyDate, std::string("2020-01-31"));
    QCOMPARE(found.studyDescription.find('\x1b'), std::string::npos);
  }

  void itIsShownWhenAskedForOnly() {
    const Series series;
    WindowCase c;
    auto* action = c.window->findChild<QAction*>("showIdentity");
    QVERIFY(!action->isEnabled());
    QStringList said;
    connect(&c.models().log, &MessageLog::message, this,
            [&said](Severity, const QString& text) { said << text; });
    c.window->open(series.path());
    QTRY_VERIFY(c.models().document.hasCase());
    QVERIFY(!c.find<QMessageBox>("identityBox"));
    QVERIFY(action->isEnabled());
    action->trigger();
    QTRY_VERIFY(c.find<QMessageBox>("identityBox"));
    const QString text = c.find<QMessageBox>("identityBox")->text();
    QVERIFY2(text.contains(QString::fromUtf8("Müller, Jörg Karl")), qPrintable(text));
    QVERIFY2(text.contains("P &lt;77&gt;"), qPrintable(text));
    QVERIFY(!c.window->windowTitle().contains(QString::fromUtf8("Müller")));
    QVERIFY(!said.join(' ').contains(QString::fromUtf8("Müller")));
  }

  void filesThatAreGoneAreSaid() {
    const Series series;
    WindowCase c;
    c.window->open(series.path());
    QTRY_VERIFY(c.models().document.hasCase());
    std::filesystem::remove_all(series.folder.path());
    c.window->findChild<QAction*>("showIdentity")->trigger();
    QTRY_VERIFY(c.find<QMessageBox>("identityBox"));
    const QString text = c.find<QMessageBox>("identityBox")->text();
    QVERIFY2(text.startsWith("Cannot read"), qPrintable(text));
  }
};

int main(int argc, char** argv) { return runWindowTests<TestIdentity>(argc, argv); }
#include "tst_identity.moc"
