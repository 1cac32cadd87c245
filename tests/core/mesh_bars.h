// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTest>

#include "core/quality/mesh_quality.h"

namespace angiomesh {

inline void verifyAngles(const MeshQuality& q) {
  QVERIFY2(q.minAngleMin >= 30.0, qPrintable(QString::number(q.minAngleMin)));
  QVERIFY2(q.maxAngleMax <= 110.0, qPrintable(QString::number(q.maxAngleMax)));
}

/// The bars of a mesh as the front and remeshing make it.
inline void verifySoundShape(const MeshQuality& q) {
  QVERIFY(q.oriented);
  QCOMPARE(q.nonManifoldEdges + q.nonManifoldVertices, std::size_t{0});
  QCOMPARE(q.selfIntersections + q.degenerateTriangles, std::size_t{0});
  verifyAngles(q);
  QVERIFY2(q.radiusRatioMean >= 0.975, qPrintable(QString::number(q.radiusRatioMean)));
  QVERIFY2(q.radiusRatioMin >= 0.6, qPrintable(QString::number(q.radiusRatioMin)));
}

}  // namespace angiomesh
