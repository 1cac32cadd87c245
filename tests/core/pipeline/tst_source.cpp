// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <set>

#include "core/pipeline/source.h"
#include "tests/core/analytic.h"

using namespace angiomesh;

class TestSource : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Results are remembered by the hash: whatever makes another image makes another hash.
  void eachPartOfAnImageCounts() {
    Volume<float> image(analytic::oblique(3, 4, 5), 1.0F);
    const Volume<float> same = image;
    std::set<std::string> hashes{contentHash(image)};
    std::size_t count = 1;
    const auto differs = [&](const Volume<float>& other) {
      hashes.insert(contentHash(other));
      return hashes.size() == ++count;
    };
    for (std::size_t i = 0; i < image.voxels.size(); ++i) {
      Volume<float> other = image;
      other.voxels[i] = 2.0F;
      QVERIFY(differs(other));
    }
    for (int a = 0; a < 3; ++a) {
      Volume<float> spaced = image, moved = image, swapped = image;
      spaced.geometry.spacing[a] *= 1.5;
      moved.geometry.origin[a] += 1.0;
      std::swap(swapped.geometry.size[static_cast<std::size_t>(a)],
                swapped.geometry.size[static_cast<std::size_t>((a + 1) % 3)]);
      QVERIFY(differs(spaced) && differs(moved) && differs(swapped));
      for (int b = 0; b < 3; ++b) {
        Volume<float> turned = image;
        turned.geometry.direction(a, b) += 0.125;
        QVERIFY(differs(turned));
      }
    }
    QCOMPARE(contentHash(same), contentHash(image));
    const Source source = makeSource(image, "name");
    QCOMPARE(source.hash, contentHash(same));
    QCOMPARE(source.name, std::string("name"));
    QVERIFY(source.image->voxels == same.voxels);
  }

  void textsHaveSixteenDigits() {
    QCOMPARE(textHash("a").size(), std::size_t{16});
    QVERIFY(textHash("a") != textHash("b") && textHash("") != textHash("a"));
    QCOMPARE(textHash("a"), textHash("a"));
  }
};

QTEST_GUILESS_MAIN(TestSource)
#include "tst_source.moc"
