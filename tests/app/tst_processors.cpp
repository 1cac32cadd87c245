// SPDX-License-Identifier: BSD-3-Clause
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "tests/app/cli_process.h"

namespace {

// What the C library may choose its functions by, as glibc calls it.
const QString kTunables = QStringLiteral("GLIBC_TUNABLES");
const QString kNoExtensions =
    QStringLiteral("glibc.cpu.hwcaps=-SSE4_1,-AVX,-AVX2,-FMA,-FMA4,-AVX512F,-AVX512VL,-AVX512DQ");

/// Runs a program in `folder` as it is, or as if the processor had no extensions and the C library
/// other functions.
CliResult runProgram(const QString& program, const QStringList& arguments, const QString& folder,
                     bool extensions) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.remove(kTunables);
  if (!extensions) {
    environment.insert(kTunables, kNoExtensions);
    environment.insert("LD_PRELOAD", ANGIOMESH_OTHER_LIBM);
  }
  QProcess process;
  process.setProcessEnvironment(environment);
  process.setWorkingDirectory(folder);
  process.start(program, arguments);
  return finish(process);
}

/// The bits of many values of functions of the C library.
int printValues() {
  for (int i = 1; i < 4000; ++i) {
    const double x = 1e-3 * i;
    for (const double y : {std::sin(x), std::tan(x), std::exp(x), std::log(x), std::atan2(x, 0.7)})
      std::printf("%a\n", y);
  }
  return 0;
}

/// Of a file, and of a PLY file what comes after its header.
QByteArray sha256(const QString& path) {
  const QByteArray bytes = readBytes(path);
  const QByteArray end = "end_header\n";
  const qsizetype at = path.endsWith(".ply") ? bytes.indexOf(end) + end.size() : 0;
  return bytes.size() > at
             ? QCryptographicHash::hash(bytes.mid(at), QCryptographicHash::Sha256).toHex()
             : QByteArray();
}

}  // namespace

// Results are the same bits whatever the processor can do.
class TestProcessors : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void meshesAreTheSameBitsWithoutExtensions_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("front, cut") << QStringList{"--cut-borders"};
    QTest::newRow("remesh") << QStringList{"--set", "surface.method=remesh"};
  }
  void meshesAreTheSameBitsWithoutExtensions() {
    QFETCH(QStringList, options);
    const QString self = QCoreApplication::applicationFilePath();
    const QTemporaryDir dir;
    const CliResult with = runProgram(self, {"--values"}, dir.path(), true);
    const CliResult without = runProgram(self, {"--values"}, dir.path(), false);
    QCOMPARE(with.code, 0);
    QCOMPARE(without.code, 0);
    if (with.output == without.output)
      QSKIP("the C library takes the same functions here, whatever the processor can do");

    for (const bool extensions : {true, false}) {
      const QString program = extensions ? ANGIOMESH_CLI : ANGIOMESH_CLI_PLAIN;
      const QString name = extensions ? "with" : "without";
      for (const QStringList& arguments :
           {QStringList{"phantom", "bifurcation", "--size", "40", "--radius", "3", "--noise", "10",
                        "--axis", "0.2,-1,0.9", "-o", name},
            QStringList{"run", name + "/image.mha", "-o", name + "-run"} + options}) {
        const CliResult result = runProgram(program, arguments, dir.path(), extensions);
        QVERIFY2(result.code == 0, result.errors.constData());
      }
    }
    for (const char* file : {"/image.mha", "/truth.mha", "-run/phi.nrrd", "-run/mask.nrrd",
                             "-run/vessels.ply", "-run/marching-cubes.ply"}) {
      const QByteArray expected = sha256(dir.filePath(QString("with") + file));
      QVERIFY2(!expected.isEmpty(), file);
      QVERIFY2(sha256(dir.filePath(QString("without") + file)) == expected,
               qPrintable(QString("%1 differs").arg(file)));
    }
  }
};

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--values") == 0) return printValues();
  const QCoreApplication application(argc, argv);
  TestProcessors test;
  return QTest::qExec(&test, argc, argv);
}
#include "tst_processors.moc"
