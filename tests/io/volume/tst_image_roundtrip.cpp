// SPDX-License-Identifier: BSD-3-Clause
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Dense>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <random>
#include <thread>

#include "core/base/error.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

const std::vector<const char*> kExtensions{".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz"};

/// Any grid: small sides, spacings of three orders, any rotation or reflection.
Geometry anyGeometry(std::mt19937& random) {
  std::uniform_int_distribution<int> side(2, 9);
  std::uniform_real_distribution<double> real(-1.0, 1.0);
  Geometry g;
  for (std::size_t a = 0; a < 3; ++a) {
    g.size[a] = side(random);
    g.spacing[static_cast<Eigen::Index>(a)] = std::pow(10.0, 1.5 * real(random));
    g.origin[static_cast<Eigen::Index>(a)] = 300.0 * real(random);
  }
  Eigen::Quaterniond q(real(random), real(random), real(random), real(random));
  g.direction = q.normalized().toRotationMatrix();
  if (real(random) < 0.0) g.direction.col(1) *= -1.0;
  return g;
}

/// Any bits; floats stay numbers of ordinary size.
template <class T>
Volume<T> anyVolume(const Geometry& g, std::mt19937& random) {
  Volume<T> volume(g);
  std::uniform_real_distribution<double> real(-1.0, 1.0);
  for (T& voxel : volume.voxels)
    if constexpr (std::is_floating_point_v<T>)
      voxel = static_cast<T>(real(random) * std::pow(10.0, 12.0 * real(random)));
    else
      voxel = static_cast<T>((static_cast<std::uint64_t>(random()) << 32U) | random());
  return volume;
}

double cornerDistance(const Geometry& a, const Geometry& b) {
  double largest = 0.0;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d index((n & 1) * a.size[0], (n >> 1 & 1) * a.size[1],
                                (n >> 2) * a.size[2]);
    largest = std::max(largest, (a.toPhysical(index) - b.toPhysical(index)).norm());
  }
  return largest;
}

/// What float32 makes of positions: its relative precision of the largest number that plays a part.
double niftiTolerance(const Geometry& g) {
  const Eigen::Vector3d sides =
      g.spacing.cwiseProduct(Eigen::Vector3d(g.size[0], g.size[1], g.size[2]));
  return 4.0 * 6e-8 * (g.origin.norm() + sides.norm());
}

/// The geometries here are of any size and angle.
bool onlyOfGeometry(const std::vector<std::string>& warnings) {
  return std::all_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("none of a scan of vessels") != std::string::npos ||
           warning.find("right angles") != std::string::npos;
  });
}

template <class T>
void verifyRoundTrips(std::mt19937& random) {
  const Folder folder;
  for (const char* extension : kExtensions) {
    const AnyVolume before = anyVolume<T>(anyGeometry(random), random);
    const fs::path path = folder / (std::string("v") + extension);
    writeVolume(before, path);
    const NativeImage after = readNative(path);
    QCOMPARE(after.info.pixelType, voxelTypeName(voxelTypeOf(before)));
    QVERIFY2(onlyOfGeometry(after.info.warnings), extension);
    QVERIFY2(std::get<Volume<T>>(after.volume).voxels == std::get<Volume<T>>(before).voxels,
             extension);
    const Geometry &g = geometryOf(before), &h = geometryOf(after.volume);
    QCOMPARE(h.size, g.size);
    const double tolerance = std::strstr(extension, ".nii") != nullptr
                                 ? niftiTolerance(g)
                                 : 1e-12 * (300.0 + g.origin.norm());
    QVERIFY2(cornerDistance(g, h) <= tolerance, extension);
    if (std::strstr(extension, ".mh") != nullptr) {
      QCOMPARE(h.origin, g.origin);
      QCOMPARE(h.spacing, g.spacing);
      QCOMPARE(h.direction, g.direction);
    }
  }
}

Volume<std::int16_t> ramp(const Geometry& g, int shift = 0) {
  Volume<std::int16_t> volume(g);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i)
    volume.voxels[i] = static_cast<std::int16_t>(static_cast<int>(i) - 20 + shift);
  return volume;
}

Geometry plainGrid() {
  Geometry g;
  g.size = {5, 4, 3};
  return g;
}

}  // namespace

class TestImageRoundTrip : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyTypeAndGeometryComesBack() {
    std::mt19937 random(7);
    for (int n = 0; n < 4; ++n) {
      verifyRoundTrips<std::int8_t>(random);
      verifyRoundTrips<std::uint8_t>(random);
      verifyRoundTrips<std::int16_t>(random);
      verifyRoundTrips<std::uint16_t>(random);
      verifyRoundTrips<std::int32_t>(random);
      verifyRoundTrips<std::uint32_t>(random);
      verifyRoundTrips<std::int64_t>(random);
      verifyRoundTrips<std::uint64_t>(random);
      verifyRoundTrips<float>(random);
      verifyRoundTrips<double>(random);
    }
  }

  void halfTurnsKeepTheirPrecisionInNifti() {
    // The quaternion alone would lose half the digits here: a is near 0.
    const Folder folder;
    Geometry g = plainGrid();
    g.size = {200, 3, 200};
    g.spacing = {0.4, 0.4, 0.7};
    g.direction = Eigen::AngleAxisd(EIGEN_PI - 2e-4, Eigen::Vector3d(3, 1, 2).normalized())
                      .toRotationMatrix();
    writeVolume(AnyVolume(ramp(g)), folder / "v.nii");
    QVERIFY(cornerDistance(geometryOf(readNative(folder / "v.nii").volume), g) <=
            niftiTolerance(g));
  }

  void whatNiftiCannotHoldIsRefused() {
    const Folder folder;
    Geometry g = plainGrid();
    g.direction(0, 1) = 0.01;
    for (const char* name : {"v.nii", "v.nii.gz"})
      QVERIFY_THROWS_EXCEPTION(InputError, writeVolume(AnyVolume(ramp(g)), folder / name));
    for (const char* name : {"v.mha", "v.nrrd"}) {
      writeVolume(AnyVolume(ramp(g)), folder / name);
      QVERIFY(cornerDistance(geometryOf(readNative(folder / name).volume), g) < 1e-12);
    }
    g = plainGrid();
    g.size = {40000, 2, 2};
    QVERIFY_THROWS_EXCEPTION(InputError, writeVolume(AnyVolume(ramp(g)), folder / "v.nii"));
    QCOMPARE(entriesOf(folder.path()), 2);
  }

  void roundedValuesAreSaid() {
    const Folder folder;
    Volume<std::int32_t> whole(plainGrid());
    whole.voxels[1] = 1 << 24;
    writeVolume(AnyVolume(whole), folder / "v.nrrd");
    QVERIFY(readImage(folder / "v.nrrd").info.warnings.empty());
    whole.voxels[2] = (1 << 24) + 1;
    writeVolume(AnyVolume(whole), folder / "v.nrrd");
    QCOMPARE(readImage(folder / "v.nrrd").info.warnings.size(), std::size_t{1});
    Volume<std::uint64_t> large(plainGrid());
    large.voxels[1] = ~std::uint64_t{0};
    writeVolume(AnyVolume(large), folder / "v.nrrd");
    QCOMPARE(readImage(folder / "v.nrrd").info.warnings.size(), std::size_t{1});
    Volume<double> fraction(plainGrid());
    fraction.voxels[1] = 0.25;
    writeVolume(AnyVolume(fraction), folder / "v.nrrd");
    QVERIFY(readImage(folder / "v.nrrd").info.warnings.empty());
    fraction.voxels[1] = 0.1;
    writeVolume(AnyVolume(fraction), folder / "v.nrrd");
    QCOMPARE(readImage(folder / "v.nrrd").info.warnings.size(), std::size_t{1});
    fraction.voxels[1] = 1e300;
    writeVolume(AnyVolume(fraction), folder / "v.nrrd");
    QVERIFY_THROWS_EXCEPTION(InputError, readImage(folder / "v.nrrd"));
  }

  void pairsAreNeverHalfThere_data() {
    QTest::addColumn<QString>("header");
    QTest::addColumn<QString>("voxels");
    QTest::newRow("mhd") << "v.mhd"
                         << ".raw";
    QTest::newRow("nhdr") << "v.nhdr"
                          << ".raw.gz";
  }
  void pairsAreNeverHalfThere() {
    QFETCH(QString, header);
    QFETCH(QString, voxels);
    const Folder folder;
    const fs::path path = folder / header.toStdString();
    const auto voxelFile = [&](const std::string& stem) {
      return folder / (stem + voxels.toStdString());
    };
    const auto stored = [&] {
      return std::get<Volume<std::int16_t>>(readNative(path).volume).voxels;
    };
    const auto first = ramp(plainGrid()), second = ramp(plainGrid(), 100);
    writeVolume(AnyVolume(first), path);
    QVERIFY(fs::exists(voxelFile("v")));
    QCOMPARE(stored(), first.voxels);

    // A new image has voxels of its own until its header stands; the old ones go then.
    writeVolume(AnyVolume(second), path);
    QCOMPARE(stored(), second.voxels);
    QCOMPARE(entriesOf(folder.path()), 2);
    writeVolume(AnyVolume(first), path);
    QVERIFY(fs::exists(voxelFile("v")));
    QCOMPARE(entriesOf(folder.path()), 2);

    // A full disk leaves the old image.
    {
      const FullDisk full(rlim_t{10});
      QVERIFY_THROWS_EXCEPTION(IoError, writeVolume(AnyVolume(second), path));
    }
    QCOMPARE(stored(), first.voxels);
    QCOMPARE(entriesOf(folder.path()), 2);
  }

  void aKilledProgramLeavesOnePairAlone() {
    const Folder folder;
    const fs::path path = folder / "v.mhd";
    const auto first = ramp(plainGrid()), second = ramp(plainGrid(), 100);
    writeVolume(AnyVolume(first), path);
    std::mt19937 random(5);
    for (int round = 0; round < 25; ++round) {
      const pid_t child = ::fork();
      if (child == 0)
        for (;;) {
          writeVolume(AnyVolume(second), path);
          writeVolume(AnyVolume(first), path);
        }
      std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % 20000));
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
      const auto stored = std::get<Volume<std::int16_t>>(readNative(path).volume).voxels;
      QVERIFY(stored == first.voxels || stored == second.voxels);
      writeVolume(AnyVolume(first), path);
      QCOMPARE(entriesOf(folder.path()), 2);
    }
  }

  void voxelFilesOfOthersAreLeftAlone() {
    const Folder folder;
    save(folder / "v.raw", "somebody else's");
    writeVolume(AnyVolume(ramp(plainGrid())), folder / "v.mhd");
    QCOMPARE(bytesOf(folder / "v.raw"), std::string("somebody else's"));
    QCOMPARE(std::get<Volume<std::int16_t>>(readNative(folder / "v.mhd").volume).voxels,
             ramp(plainGrid()).voxels);
    // Two headers over one voxel file: writing one keeps it for the other.
    fs::copy_file(folder / "v.mhd", folder / "w.mhd");
    writeVolume(AnyVolume(ramp(plainGrid(), 7)), folder / "v.mhd");
    QCOMPARE(std::get<Volume<std::int16_t>>(readNative(folder / "w.mhd").volume).voxels,
             ramp(plainGrid()).voxels);
  }

  void anyNameCanBeReadAgain() {
    const Folder folder;
    for (const char* name : {"x 77 %.mhd", "v%03d 1 9 1.nhdr", "LIST.mhd", "list 2.nhdr",
                             "Local.mhd", " a .mhd", "b\tc\nd.nhdr", "\xc3\xa4 \"\xc3\xb6\".mhd"}) {
      writeVolume(AnyVolume(ramp(plainGrid())), folder / name);
      QVERIFY2(std::get<Volume<std::int16_t>>(readNative(folder / name).volume).voxels ==
                   ramp(plainGrid()).voxels,
               name);
    }
  }

  void scaledNiftiIsConvertedExactly() {
    const Folder folder;
    const auto scaled = [&](float slope, float intercept) {
      writeVolume(AnyVolume(ramp(plainGrid())), folder / "v.nii");
      std::string bytes = bytesOf(folder / "v.nii");
      put(bytes, 112, slope);
      put(bytes, 116, intercept);
      save(folder / "v.nii", bytes);
      return readNative(folder / "v.nii").volume;
    };
    const auto value = [](const AnyVolume& v, std::size_t i) {
      return std::visit([&](const auto& volume) { return static_cast<double>(volume.voxels[i]); },
                        v);
    };
    // slope, intercept, and the type that holds every value
    const std::tuple<float, float, VoxelType> cases[] = {{0.0F, 5.0F, VoxelType::Int16},
                                                         {2.0F, -1024.0F, VoxelType::Int16},
                                                         {1000.0F, 20000.0F, VoxelType::UInt16},
                                                         {0.5F, 0.25F, VoxelType::Float32},
                                                         {0.1F, 0.3F, VoxelType::Float64}};
    for (const auto& [slope, intercept, type] : cases) {
      const AnyVolume read = scaled(slope, intercept);
      QCOMPARE(voxelTypeName(voxelTypeOf(read)), voxelTypeName(type));
      const double factor = slope == 0.0F ? 1.0 : static_cast<double>(slope);
      const double added = slope == 0.0F ? 0.0 : static_cast<double>(intercept);
      for (std::size_t i = 0; i < 60; ++i)
        QCOMPARE(value(read, i), (static_cast<double>(i) - 20.0) * factor + added);
      QCOMPARE(readImage(folder / "v.nii").image.voxels[7], static_cast<float>(value(read, 7)));
    }
    QCOMPARE(voxelTypeName(voxelTypeOf(scaled(std::nanf(""), 3.0F))), "int16");  // no scaling
    QVERIFY_THROWS_EXCEPTION(InputError, scaled(1.0F, std::nanf("")));
  }
};

QTEST_APPLESS_MAIN(TestImageRoundTrip)
#include "tst_image_roundtrip.moc"
