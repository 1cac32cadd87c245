// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/image/projection.h"
#include "core/mesh/tri_mesh.h"
#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/report.h"
#include "core/quality/quality_table.h"
#include "tests/core/bytes.h"

using namespace angiomesh;
using analytic::Bytes;

namespace {

void addMeasures(Bytes& bytes, const MeshQuality& quality) {
  for (const QualityMeasure& measure : qualityMeasures())
    bytes.add(measure.value(quality).value_or(-1));
}

void addPorts(Bytes& bytes, const std::vector<Port>& ports) {
  for (const Port& port : ports) {
    bytes.add(port.name);
    bytes.add(port.areaMm2);
    bytes.add(port.centreLps);
    bytes.add(port.normalLps);
  }
}

std::string hashOf(Step step, const RunResult& run) {
  Bytes bytes;
  switch (step) {
    case Step::Load:
      bytes.add(*run.source.image);
      break;
    case Step::Preprocess:
      bytes.add(*run.preprocessed);
      break;
    case Step::Vesselness:
      if (run.vesselness) bytes.add(*run.vesselness->multiScale);
      break;
    case Step::Seeds:
      if (run.seeds)
        for (const Eigen::Vector3d& point : run.seeds->pointsLps) bytes.add(point);
      break;
    case Step::Evolve:
      bytes.add(*run.evolve->phi);
      bytes.add(run.evolve->iterations);
      break;
    case Step::Correct:
      bytes.add(*run.corrected->phi);
      for (const CorrectionOutcome& outcome : run.corrected->corrections) {
        bytes.add(outcome.text);
        bytes.add(outcome.added);
        bytes.add(outcome.removed);
        bytes.add(outcome.why);
      }
      break;
    case Step::Surface:
      bytes.add(*run.surface->phi);
      bytes.add(*run.surface->mesh);
      bytes.add(*run.surface->marchingCubes);
      addPorts(bytes, run.surface->ports);
      for (const SegmentComponent& part : run.surface->components) {
        bytes.add(part.volumeMm3);
        if (part.measure) bytes.add(part.measure->lengthMm);
      }
      break;
    case Step::Smooth:
      bytes.add(*run.smoothed);
      addPorts(bytes, run.ports);
      break;
    case Step::Quality:
      addMeasures(bytes, run.quality->mesh);
      addMeasures(bytes, run.quality->unsmoothed);
      addMeasures(bytes, run.quality->marchingCubes);
      break;
  }
  return bytes.hash();
}

/// Of preview.png and of all that report.json says, but what changes with machine and version.
std::string hashOfFiles(const RunResult& run) {
  nlohmann::json report = nlohmann::json::parse(runReportJson(run));
  for (const char* changes : {"version", "key", "mesh_hash", "threads", "total_seconds",
                              "cpu_seconds", "peak_rss_mb", "stages"})
    report.erase(changes);
  const Picture preview = previewPicture(*run.source.image, *run.evolve->phi);
  return textHash(report.dump() + std::string(preview.rgb.begin(), preview.rgb.end()));
}

struct Settings {
  const char* key;
  const char* value;
};

/// What a step of a version computes.
struct Row {
  int version;
  const char* hash;
};

/// A run that takes a path of its own through the steps.
struct Case {
  const char* name;
  PhantomKind kind;
  Index3 size;
  Eigen::Vector3d spacingMm;
  double radius, noise;
  const char* preset;
  std::vector<Settings> settings;
  bool mask;  ///< of the phantom, instead of its image
  Step until;
  std::vector<Row> steps;
  const char* files;  ///< report.json and preview.png
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"thick slices, cut",
       PhantomKind::Bifurcation,
       {44, 40, 28},
       {0.5, 0.6, 0.9},
       3.0,
       20.0,
       "angiomesh",
       {{"ports.cutEndsRadii", "1"}, {"ports.cutBorders", "true"}},
       false,
       Step::Quality,
       {{1, "08eebe39ac32dc36"},
        {2, "9a211ab574ca842a"},
        {2, "f46edb180c08fa9f"},
        {2, "d449928f3cf392fa"},
        {9, "d6289f3a10a0b90a"},
        {1, "3769f3cdf617c919"},
        {6, "120711098e46196e"},
        {5, "5dd957ba8a025700"},
        {4, "c93902e70e9196e5"}},
       "79622b21f3e96455"},
      {"inside the volume, ends cut",
       PhantomKind::CapsuleTree,
       {72, 68, 76},
       {0.8, 0.8, 0.8},
       3.0,
       8.0,
       "angiomesh",
       {{"ports.cutEndsRadii", "2"}, {"surface.edgesAround", "8"}, {"surface.rho", "0.3"}},
       false,
       Step::Quality,
       {{1, "9c139527ae6a31e8"},
        {2, "9c139527ae6a31e8"},
        {2, "55e96805a650ee27"},
        {2, "1edac1cdf1a72c79"},
        {9, "c0a221c8cefec68d"},
        {1, "38a6bc4dfa7b6fa0"},
        {6, "a7af57dcf6a15e40"},
        {5, "9d8a315762bb1d7d"},
        {4, "fb098288c4a056f7"}},
       "4aa15194704174ee"},
      {"as printed",
       PhantomKind::Helix,
       {48, 44, 52},
       {1.0, 1.0, 1.0},
       2.5,
       10.0,
       "thesis",
       {{"preprocess.sigmoid.enabled", "true"}, {"preprocess.curvatureFlow.enabled", "true"}},
       false,
       Step::Quality,
       {{1, "19e202e197b908b4"},
        {2, "22baa2a87c36c8cc"},
        {2, "c07d29c755f59949"},
        {2, "3fa908a31276b61f"},
        {9, "7ff37f8cb88ab095"},
        {1, "9303ffd785839e33"},
        {6, "c31d35188a8b0277"},
        {5, "25ba4db0ea299a05"},
        {4, "8e17654c061039f0"}},
       "d03c4357044f5c88"},
      {"bounds, remeshed",
       PhantomKind::NeckAneurysm,
       {52, 48, 44},
       {1.0, 1.0, 1.2},
       3.0,
       5.0,
       "ct",
       {{"surface.method", "remesh"}, {"surface.border", "open"}, {"surface.rho", "0.2"}},
       false,
       Step::Quality,
       {{1, "b7904c791de84c15"},
        {2, "297b426587194c0e"},
        {2, "d18a7c8625ec3be9"},
        {2, "fba3d904bd3848bb"},
        {9, "3bc4e534be102349"},
        {1, "9c32558313ba9d0f"},
        {6, "6cb6f3dfa6969bcf"},
        {5, "6bea2b3de8a6038c"},
        {4, "a12953312c5f0799"}},
       "72f098f0c6df8d4d"},
      {"mask, marching cubes",
       PhantomKind::Kissing,
       {40, 44, 48},
       {0.7, 0.7, 1.0},
       4.0,
       0.0,
       "angiomesh",
       {{"segmentation.method", "label"},
        {"segmentation.connectivity", "faces"},
        {"surface.method", "marching-cubes"},
        {"smooth.method", "taubin"}},
       true,
       Step::Quality,
       {{1, "21d1842019f02d07"},
        {2, "21d1842019f02d07"},
        {2, "2d06800538d394c2"},
        {2, "2d06800538d394c2"},
        {9, "8ea12ee3b1406f5a"},
        {1, "0004b79ed0f837b1"},
        {6, "14c3bd940b07bbf5"},
        {5, "d2ab9560f4da3310"},
        {4, "0300342f2d6f8464"}},
       "fa3e3b1bd65b321e"},
      {"dark, Frangi's measure",
       PhantomKind::Torus,
       {36, 44, 40},
       {1.0, 1.0, 1.0},
       3.0,
       8.0,
       "thesis",
       {{"vesselness.polarity", "dark"},
        {"vesselness.measure", "frangi"},
        {"levelset.start", "flood"},
        {"levelset.refine", "true"},
        {"surface.method", "remesh"},
        {"surface.cellVoxels", "1.5"},
        {"surface.spline", "catmull-rom"},
        {"smooth.method", "none"}},
       false,
       Step::Quality,
       {{1, "dce04157429bdde3"},
        {2, "dce04157429bdde3"},
        {2, "374b76417848ae71"},
        {2, "dd05b680f2e7edf4"},
        {9, "faacd1f7e529e159"},
        {1, "b5976e15c77f3b9e"},
        {6, "8358b1d68b419328"},
        {5, "e1e64009ec0d20cd"},
        {4, "6b6b38b55ab19584"}},
       "47e9be7afd3cdc43"},
      {"a tree in noise, cut at the borders",
       PhantomKind::Tree,
       {60, 56, 52},
       {0.5, 0.5, 0.7},
       3.0,
       30.0,
       "angiomesh",
       {{"ports.cutBorders", "true"}, {"surface.rho", "0.1"}},
       false,
       Step::Quality,
       {{1, "81d8a0d22d991f69"},
        {2, "52bca21fefba0bd1"},
        {2, "2b004feaa4e6e8e4"},
        {2, "a0e86992e21bebf3"},
        {9, "e9b402d98efa1226"},
        {1, "e8ab81811c169283"},
        {6, "435514a202c61d51"},
        {5, "9319c49ad79637d4"},
        {4, "4235677eb666cb19"}},
       "e0a2c23e1c78a7c9"},
      {"a tree, remeshed",
       PhantomKind::Tree,
       {68, 72, 76},
       {0.9, 0.8, 0.8},
       3.0,
       15.0,
       "ct",
       {{"surface.method", "remesh"},
        {"surface.rho", "0.3"},
        {"segmentation.keep", "largest"},
        {"vesselness.sigmaMaxMm", "1.6"},
        {"smooth.wallBoundVoxels", "0.2"}},
       false,
       Step::Quality,
       {{1, "554dc0f4abbf3290"},
        {2, "d29e9eec9f8efb15"},
        {2, "41f860de164787e3"},
        {2, "8028f6f85dd93344"},
        {9, "2713b161fd7a7373"},
        {1, "65484dcf31fcc650"},
        {6, "035a03e74f6bdc80"},
        {5, "616a27d5065b9c66"},
        {4, "72c8083988cf885b"}},
       "ef0f00a072890980"},
      {"bent vessels, marching cubes on the wall",
       PhantomKind::VesselTree,
       {72, 68, 64},
       {0.8, 0.8, 0.8},
       4.0,
       25.0,
       "angiomesh",
       {{"surface.method", "marching-cubes"}, {"surface.cellVoxels", "0.8"}},
       false,
       Step::Quality,
       {{1, "4ddfd706a572f814"},
        {2, "4ddfd706a572f814"},
        {2, "abf15b447cc2459c"},
        {2, "1bfeb16bee80047a"},
        {9, "106747ce37304e8f"},
        {1, "05403b361c17e44f"},
        {6, "39552cbf2af4ca39"},
        {5, "2536b94c1d4c5bf1"},
        {4, "879985fb9a32680d"}},
       "f92f291454a0a12c"},
      {"a rough mask with handles",
       PhantomKind::Tree,
       {52, 48, 56},
       {0.6, 0.6, 0.8},
       4.0,
       50.0,
       "angiomesh",
       {{"segmentation.method", "label"},
        {"segmentation.minLengthMm", "3"},
        {"surface.border", "open"}},
       true,
       Step::Quality,
       {{1, "85811d6d524e2e34"},
        {2, "85811d6d524e2e34"},
        {2, "2d06800538d394c2"},
        {2, "2d06800538d394c2"},
        {9, "e2e48213ceed94bc"},
        {1, "3c648f100c1726ab"},
        {6, "f09876777fce34c4"},
        {5, "db4ef6ed079973d4"},
        {4, "6e116f513ba507ca"}},
       "ef082db34531eec6"},
      {"corrected in every way",
       PhantomKind::Kissing,
       {44, 44, 44},
       {0.5, 0.5, 0.5},
       3.0,
       10.0,
       "angiomesh",
       {{"segmentation.corrections",
         "bridge 9.2,10.75,10.75 12.4,10.75,10.75;"
         "separate 9.2,10.75,10.75 12.4,10.75,10.75;"
         "bridge 9.2,10.75,8 12.4,10.75,8;"
         "add 0.8 9.2,10.75,10.75 9.5,10.75,14 12,10.75,14 12.4,10.75,10.75;"
         "open-loop 10.8,10.75,14;"
         "bridge 9.2,10.75,9.5 12.4,10.75,9.5;"
         "fill-hole 10.8,10.75,9;"
         "erase 0.8 13.6,7.5,1 14,8,4;"
         "add-to-edge 2 14,8,3;"
         "erase-to-edge 2.5 19.5,14,19;"
         "cut-off 2.2,7.9,1.2;"
         "cut-off 7.6,13.6,20 0,0,1"}},
       false,
       Step::Correct,
       {{1, "81ea4e38a17842f6"},
        {2, "81ea4e38a17842f6"},
        {2, "eda0afea55912bd2"},
        {2, "afdb6bff9e5e6625"},
        {9, "f43db1af1a79c978"},
        {1, "cfe01682cf6b1906"}},
       "a2ed4bd56dc93896"},
      {"geodesic active contour",
       PhantomKind::Stenosis,
       {30, 34, 40},
       {1.0, 1.0, 1.0},
       3.0,
       10.0,
       "angiomesh",
       {{"segmentation.method", "geodesic-active-contour"},
        {"comparison.gac.iterations", "60"},
        {"preprocess.isotropic", "off"}},
       false,
       Step::Evolve,
       {{1, "ff515eb2124d9edd"},
        {2, "ff515eb2124d9edd"},
        {2, "98c2c0a2b17bfa29"},
        {2, "6668a74556a84072"},
        {9, "79d5ee1ca5fd280c"}},
       "022ea433aa355f73"},
      {"confidence connected",
       PhantomKind::Cone,
       {30, 34, 40},
       {0.8, 1.0, 1.0},
       4.0,
       10.0,
       "angiomesh",
       {{"segmentation.method", "confidence-connected"}},
       false,
       Step::Evolve,
       {{1, "773623ea296d1d80"},
        {2, "920dac00d283a1c5"},
        {2, "9130a6f08c2fb2ef"},
        {2, "bebec23857d89f27"},
        {9, "dcf1b0b114027a8d"}},
       "ba14a66d4b64bb35"},
      {"threshold",
       PhantomKind::Aneurysm,
       {40, 44, 38},
       {1.0, 1.0, 1.0},
       3.0,
       12.0,
       "angiomesh",
       {{"segmentation.method", "threshold"}, {"wall.smooth", "false"}},
       false,
       Step::Evolve,
       {{1, "cac7f171daad1794"},
        {2, "cac7f171daad1794"},
        {2, "aec881ff76257037"},
        {2, "5527b1a96f0e4f80"},
        {9, "e3edec96ae28a168"}},
       "08fbfadbafcf66a6"},
  };
  return all;
}

RunResult runOf(const Case& c) {
  PhantomParams params;
  params.kind = c.kind;
  params.size = c.size;
  params.spacingMm = c.spacingMm;
  params.radius = c.radius;
  params.noiseSigma = c.noise;
  params.axis = Eigen::Vector3d(0.2, 0.3, 1.0);
  if (c.kind == PhantomKind::Tree) {
    params.radiusMin = 1.0;
    params.radiusMax = c.radius;
    params.volumePercent = 1.5;
  }
  const Phantom phantom = makePhantom(params);
  Volume<float> image = phantom.image;
  if (c.mask)
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      image.voxels[i] = (c.noise > 0.0 ? image.voxels[i] > 140.0F : phantom.truth.voxels[i] != 0);
  RunOptions options;
  options.until = c.until;
  Parameters run = preset(c.preset);
  for (const Settings& s : c.settings) setFieldFromText(run, s.key, s.value);
  if (run.vesselness.polarity == Polarity::Dark)
    for (float& value : image.voxels) value = 255.0F - value;
  return Pipeline(makeSource(std::move(image), c.name)).run(run, options);
}

}  // namespace

/// A step's key stands for its result, on every machine and in the caches of cases that were saved
/// long ago. So its version rises whenever it computes other bits from the same inputs; each
/// version's bits stand here, for runs that take different ways through the code.
class TestStepVersions : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bitsChangeWithTheVersionOnly_data() {
    QTest::addColumn<int>("number");
    for (std::size_t n = 0; n < cases().size(); ++n)
      QTest::newRow(cases()[n].name) << static_cast<int>(n);
  }
  void bitsChangeWithTheVersionOnly() {
    QFETCH(int, number);
    const auto n = static_cast<std::size_t>(number);
    const RunResult run = runOf(cases()[n]);
    const std::vector<Row>& known = cases()[n].steps;
    QString differs, now;
    for (std::size_t s = 0; s <= static_cast<std::size_t>(cases()[n].until); ++s) {
      const auto step = static_cast<Step>(s);
      const Row row{factsOf(step).version, nullptr};
      const std::string hash = hashOf(step, run);
      now += QString("{%1, \"%2\"}, ").arg(row.version).arg(hash.c_str());
      const bool same =
          s < known.size() && known[s].version == row.version && known[s].hash == hash;
      if (!same && differs.isEmpty()) differs = stepId(step);
    }
    const std::string files = hashOfFiles(run);
    QVERIFY2(differs.isEmpty(),
             qPrintable(differs +
                        " computes something else: raise its version in "
                        "core/parameters/step.h if it has not been raised, and write "
                        "here: " +
                        now));
    QVERIFY2(
        files == cases()[n].files,
        qPrintable(
            QString(
                "report.json or preview.png says something else: where it should, write here: ") +
            files.c_str()));
  }
};

QTEST_GUILESS_MAIN(TestStepVersions)
#include "tst_step_versions.moc"
