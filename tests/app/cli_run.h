// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTest>

#include "tests/app/cli_process.h"

/// A few iterations are enough where not the result but the files matter.
inline const QStringList kQuick{"--set", "levelset.maxIterations=150", "--set",
                                "levelset.checkEvery=50"};

inline std::string nativePath(const QString& path) { return path.toStdString(); }

/// Whether `object` has the key a.b.c.
inline bool hasKey(QJsonObject object, const QString& dotted) {
  const QStringList parts = dotted.split('.');
  for (qsizetype i = 0; i + 1 < parts.size(); ++i) {
    if (!object.value(parts[i]).isObject()) return false;
    object = object.value(parts[i]).toObject();
  }
  return object.contains(parts.back()) && !object.value(parts.back()).isNull();
}

/// A folder in which a small bifurcation was run, for tests to look into.
struct CliRun : CliFolder {
  /// A phantom in p and its run in out.
  void makeRun() {
    QVERIFY(dir.isValid());
    const CliResult made = cli(
        {"phantom", "bifurcation", "--size", "40", "--radius", "3", "--noise", "10", "-o", "p"});
    QCOMPARE(made.errors, QByteArray());
    QCOMPARE(made.code, 0);
    QCOMPARE(filesIn(at("p")), QStringList({"image.mha", "truth.json", "truth.mha"}));
    const CliResult run =
        cli(QStringList{"run", "p/image.mha", "--truth", "p/truth.mha", "-o", "out"});
    QVERIFY2(run.code == 0, run.errors.constData());
    QVERIFY(run.output.contains("marching cubes"));
  }
};
