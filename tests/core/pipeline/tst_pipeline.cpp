// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>
#include <thread>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/vesselness_step.h"
#include "core/quality/overlap.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

Phantom smallBifurcation() {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.kind = PhantomKind::Bifurcation;
  params.size = {40, 40, 40};
  params.radius = 3.0;
  params.noiseSigma = 10.0;
  return makePhantom(params);
}

Parameters smallParams() {
  Parameters params;
  params.vesselness.sigmaMaxMm = 4.0;
  return params;
}

/// Two separate tubes along z, the second thinner.
Volume<float> twoTubes() {
  return sampled(cube(36), [](const Eigen::Vector3d& x) {
    const double a = tube(x, {9.0, 18.0, 18.0}, {0, 0, 1}, 3.0);
    const double b = tube(x, {27.0, 18.0, 18.0}, {0, 0, 1}, 2.0);
    return 200.0 * std::clamp(0.5 - std::min(a, b), 0.0, 1.0);
  });
}

}  // namespace

class TestPipeline : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void runsFromImageToSurface() {
    const Phantom phantom = smallBifurcation();
    Pipeline pipeline(makeSource(phantom.image, "bifurcation"));
    const Progress progress;
    const RunResult run = pipeline.run(smallParams(), {}, progress);
    QCOMPARE(progress.fraction(), 1.0);
    QCOMPARE(run.stages.size(), static_cast<std::size_t>(kStepCount - 1));
    const OverlapMeasures overlap =
        compareMasks(maskOnGrid(*run.surface->phi, phantom.truth.geometry), phantom.truth);
    QVERIFY(isAbove(overlap.overlap, 85.0));
    const MeshQuality& mesh = run.quality->mesh;
    QVERIFY(mesh.closed && mesh.oriented);
    QCOMPARE(mesh.nonManifoldEdges + mesh.nonManifoldVertices + mesh.degenerateTriangles,
             std::size_t{0});
    QCOMPARE(mesh.components, static_cast<int>(run.surface->components.size()));
    QCOMPARE(run.surface->origin.method, SurfaceMethod::AdvancingFront);
    QCOMPARE(run.surface->origin.unverified(), std::size_t{0});
    QVERIFY(mesh.fromFrontPercent && *mesh.fromFrontPercent >= 95.0);
    QVERIFY(!run.quality->marchingCubes.fromFrontPercent);
    QCOMPARE(mesh.triangles, run.surface->mesh->triangles.size());
    QVERIFY(mesh.radiusRatioMean > run.quality->marchingCubes.radiusRatioMean);
    // Vertices lie outside by what inscribed triangles miss: of the radius, rho^2 / 16 or so.
    QVERIFY(mesh.vertexDeviation && mesh.vertexDeviation->meanMm < 3.0 * 0.4 * 0.4 / 16.0);
    QVERIFY(run.quality->unsmoothed.vertexDeviation->maxMm < 1e-3);
    QVERIFY(std::fabs(mesh.volumeMm3 / static_cast<double>(run.surface->insideVoxels) - 1.0) < 0.2);
  }

  void aChangedParameterRecomputesItsStepAndThoseAfterIt() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    Parameters params = smallParams();
    pipeline.run(params);
    for (const Step step : {Step::Preprocess, Step::Evolve, Step::Quality})
      QVERIFY(pipeline.has(step, params));
    Parameters changed = params;
    changed.thresholds.xi = 22.0;
    QCOMPARE(pipeline.key(Step::Seeds, changed), pipeline.key(Step::Seeds, params));
    QVERIFY(pipeline.key(Step::Evolve, changed) != pipeline.key(Step::Evolve, params));
    const RunResult run = pipeline.run(changed);
    for (const StageReport& stage : run.stages) QCOMPARE(stage.reused, stage.step < Step::Evolve);
    for (const StageReport& stage : pipeline.run(params).stages) QVERIFY(stage.reused);
  }

  // b = xi v_avg / (sigma_max / sigma_min), eq. 3.20.
  void thresholdsTakeTheRangeOfScales() {
    Volume<float> v(cube(4), -0.5F);
    v.voxels[3] = 0.2F;
    v.voxels[9] = 0.4F;
    VesselnessResult vessels;
    vessels.multiScale = std::make_shared<const Volume<float>>(v);
    vessels.scalesMm = {0.5, 1.1, 2.0};
    ThresholdParams params;
    params.bRule = ThresholdRule::Average;
    params.xi = 3.0;
    params.bMin = 0.01;
    params.bMax = 5.0;
    const Thresholds t = thresholdsFor(vessels, params);
    QVERIFY(std::fabs(t.b - 3.0 * 0.3 / 4.0) < 1e-6 && std::fabs(t.a - 2.0 * t.b) < 1e-12);
    QVERIFY(!t.clamped);
    const Volume<float> p = speedVolume(v, t);
    for (std::size_t i = 0; i < p.voxels.size(); ++i)
      QCOMPARE(p.voxels[i], static_cast<float>(vesselSpeed(v.voxels[i], t)));
    params.b = 0.07;
    QCOMPARE(thresholdsFor(vessels, params).b, 0.07);
  }

  // What was handed on stays, whatever becomes of later steps.
  void eachStepIsToldWithItsResult() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    std::vector<Step> told;
    std::shared_ptr<const SurfaceResult> surface;
    RunOptions options;
    Progress progress;
    options.done = [&](Step step, const RunResult& soFar) {
      told.push_back(step);
      QVERIFY(soFar.stages.back().step == step && soFar.key == soFar.stages.back().key);
      if (step != Step::Surface) return;
      QVERIFY(soFar.surface && !soFar.smoothed && !soFar.quality);
      surface = soFar.surface;
      progress.cancel();
    };
    QVERIFY_THROWS_EXCEPTION(Cancelled, pipeline.run(Parameters(), options, progress));
    const std::vector<Step> upToSurface{Step::Preprocess, Step::Vesselness, Step::Seeds,
                                        Step::Evolve,     Step::Correct,    Step::Surface};
    QVERIFY(told == upToSurface);
    QVERIFY(pipeline.has(Step::Surface, Parameters()));
    QCOMPARE(pipeline.deepestAtHand(Parameters()), Step::Surface);

    RunOptions upToSmooth;
    upToSmooth.begins = [](Step step) { return step <= Step::Smooth; };
    const RunResult stopped = pipeline.run(Parameters(), upToSmooth);
    QVERIFY(stopped.surface == surface && stopped.smoothed && !stopped.quality);
    QCOMPARE(stopped.key, pipeline.key(Step::Smooth, Parameters()));
  }

  void aStepReadsTheFieldsThatAreItsOwn() {
    const Pipeline pipeline(makeSource(Volume<float>(cube(4)), "cube"));
    Parameters scan, mask;
    mask.segmentation.method = SegmentationMethod::Label;
    for (const Parameters& base : {scan, mask})
      for (const Field& field : parameterFields()) {
        if (field.kind != FieldKind::Boolean) continue;
        Parameters changed = base;
        field.put(changed, !std::get<bool>(field.get(base)));
        const std::optional<Step> reader = isSegmented(base) ? field.ofMask : field.ofScan;
        for (int s = 1; s < kStepCount; ++s) {
          const auto step = static_cast<Step>(s);
          QCOMPARE(pipeline.key(step, changed) != pipeline.key(step, base),
                   reader && *reader <= step);
        }
      }
    Parameters named = scan;
    named.ports.names = {"border_1=inlet"};
    QCOMPARE(pipeline.key(Step::Quality, named), pipeline.key(Step::Quality, scan));
  }

  // Two tubes: the segmentation keeps one, and so does every surface.
  void theLargestComponentIsOneSurface_data() {
    QTest::addColumn<QString>("method");
    for (const char* method : {"advancing-front", "remesh", "marching-cubes"})
      QTest::newRow(method) << method;
  }
  void theLargestComponentIsOneSurface() {
    QFETCH(QString, method);
    Parameters params;
    setFieldFromText(params, "surface.method", method.toStdString());
    setFieldFromText(params, "segmentation.keep", "largest");
    const RunResult run = Pipeline(makeSource(twoTubes(), "tubes")).run(params);
    QCOMPARE(run.surface->components.size(), std::size_t{2});
    QCOMPARE(run.quality->mesh.components, 1);
  }

  void everyParameterBelongsToAStep() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    for (const Field& field : parameterFields()) {
      Parameters base;
      if (field.key == "segmentation.label" || field.key == "segmentation.connectivity")
        base.segmentation.method = SegmentationMethod::Label;
      Parameters changed = base;
      FieldValue value = field.get(base);
      if (field.kind == FieldKind::Boolean)
        value = !std::get<bool>(value);
      else if (field.kind == FieldKind::Choice)
        value = field.choices.back() == std::get<std::string>(value) ? field.choices.front()
                                                                     : field.choices.back();
      else if (field.kind == FieldKind::Numbers)
        value = std::vector<double>(field.groupOf, 1.0);
      else if (field.kind == FieldKind::Texts)
        value = std::vector<std::string>{"1,2,3,inlet"};
      else if (field.kind == FieldKind::Integer)
        value = static_cast<std::int64_t>(field.maximum);
      else
        value = value == FieldValue(field.maximum) ? field.minimum : field.maximum;
      if (field.choices.size() == 1) continue;
      if (field.key == "ports.names") continue;  // see namesOfPortsMakeNothingAnew()
      field.put(changed, value);
      QVERIFY2(pipeline.key(Step::Quality, changed) != pipeline.key(Step::Quality, base),
               field.key.c_str());
    }
  }

  void namesOfPortsMakeNothingAnew() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    Parameters params = smallParams();
    const RunResult plain = pipeline.run(params);
    QVERIFY(!plain.ports.empty());
    QCOMPARE(plain.ports[0].name, std::string("border_1"));
    const auto warnings = [](const RunResult& run) {
      std::size_t count = 0;
      for (const StageReport& stage : run.stages) count += stage.warnings.size();
      return count;
    };
    params.ports.names = {"border_1=inlet", "border_99=none"};
    const RunResult named = pipeline.run(params);
    for (const StageReport& stage : named.stages) QVERIFY(stage.reused);
    QCOMPARE(named.ports[0].name, std::string("inlet"));
    QCOMPARE(warnings(named), warnings(plain) + 1);
    params.ports.names.clear();
    const RunResult again = pipeline.run(params);
    QCOMPARE(again.ports[0].name, std::string("border_1"));
    QCOMPARE(warnings(again), warnings(plain));
  }

  void whatSmoothingDoesToAPortIsSaidByItsName() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    Parameters params = smallParams();
    params.smooth.method = SmoothMethod::Taubin;
    params.smooth.iterations = 1000;
    for (const std::string name : {"border_1", "inlet", "outlet"}) {
      if (name != "border_1") params.ports.names = {"border_1=" + name};
      const RunResult run = pipeline.run(params);
      const auto smooth =
          std::find_if(run.stages.begin(), run.stages.end(),
                       [](const StageReport& stage) { return stage.step == Step::Smooth; });
      QVERIFY(smooth != run.stages.end());
      QVERIFY(std::any_of(smooth->warnings.begin(), smooth->warnings.end(), [&](const auto& text) {
        return text.find("the port '" + name + "' has an area of ") == 0;
      }));
    }
  }

  void componentsCanBeLeftOut() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    Parameters params = smallParams();
    params.seeds.topPercent = 1.0;
    const RunResult both = pipeline.run(params);
    QCOMPARE(both.surface->components.size(), std::size_t{2});
    const Eigen::Vector3d inner = both.surface->components[0].innerPointLps;
    QVERIFY(std::fabs(inner[0] - 9.0) < 3.0);

    Parameters dropped = params;
    dropped.segmentation.drop = {inner[0], inner[1], inner[2]};
    const RunResult one = pipeline.run(dropped);
    QCOMPARE(one.surface->components.size(), std::size_t{2});
    QVERIFY(!one.surface->components[0].kept && one.surface->components[1].kept);
    QCOMPARE(one.quality->mesh.components, 1);
    for (const Eigen::Vector3d& x : one.smoothed->points) QVERIFY(x[0] > 20.0);

    Parameters largest = params;
    largest.segmentation.keep = KeepComponents::Largest;
    for (const Eigen::Vector3d& x : pipeline.run(largest).smoothed->points) QVERIFY(x[0] < 16.0);
    Parameters seeded = params;
    seeded.segmentation.keep = KeepComponents::Seeded;
    seeded.seeds.points = {27.0, 18.0, 18.0};
    const RunResult thin = pipeline.run(seeded);
    for (const Eigen::Vector3d& x : thin.smoothed->points) QVERIFY(x[0] > 20.0);
    const auto& parts = thin.surface->components;
    QVERIFY(!parts[0].seeded && !parts[0].kept && parts[1].seeded && parts[1].kept);
    QVERIFY(parts[0].volumeMm3 > parts[1].volumeMm3);
    for (const SegmentComponent& part : parts)
      QVERIFY(part.measure && std::fabs(part.measure->lengthMm / 36.0 - 1.0) < 0.05);
    QVERIFY(std::fabs(parts[0].measure->meanRadiusMm - 3.0) < 0.3);
    QVERIFY(std::fabs(parts[1].measure->meanRadiusMm - 2.0) < 0.3);
    Parameters none = params;
    none.segmentation.minVolumeMm3 = 1e6;
    QVERIFY_THROWS_EXCEPTION(NumericError, pipeline.run(none));
  }

  void threadsDoNotChangeTheMesh() {
    const Phantom phantom = smallBifurcation();
    const auto [one, two] = onOneAndSeveralThreads(
        [&] { return Pipeline(makeSource(phantom.image, "x")).run(smallParams()); });
    QCOMPARE(one.key, two.key);
    QVERIFY(one.evolve->phi->voxels == two.evolve->phi->voxels);
    QVERIFY(one.smoothed->triangles == two.smoothed->triangles);
    QVERIFY(one.smoothed->points == two.smoothed->points);
  }

  void anAnisotropicObliqueScanGivesTheSameVessel() {
    const Geometry g = oblique(70, 56, 30);
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 1, 2).normalized();
    const auto image = sampled(g, [&](const Eigen::Vector3d& x) {
      return 200.0 * std::clamp(0.5 - tube(x, centreOf(g), axis, 1.6) / 0.4, 0.0, 1.0);
    });
    for (const Isotropic isotropic : {Isotropic::On, Isotropic::Off}) {
      Parameters params;
      params.preprocess.isotropic = isotropic;
      params.vesselness.sigmaMinMm = 0.5;
      params.vesselness.sigmaMaxMm = 2.0;
      const RunResult run = Pipeline(makeSource(image, "x")).run(params);
      double sum = 0.0;
      double count = 0.0;
      for (const Eigen::Vector3d& x : run.smoothed->points) {
        const Eigen::Vector3d index = g.toIndex(x);
        bool inner = true;
        for (int a = 0; a < 3; ++a) inner = inner && index[a] > 5.0 && index[a] < g.size[a] - 6.0;
        if (!inner) continue;
        sum += tube(x, centreOf(g), axis, 0.0);
        count += 1.0;
      }
      QVERIFY(count > 100.0);
      // The method places the wall on an iso-level of vesselness, not on the edge: within half a
      // voxel.
      QVERIFY(isNear(sum / count, 1.6, 0.4));
    }
  }

  void snapshotsAndControlDoNotChangeTheResult() {
    const Phantom phantom = smallBifurcation();
    const RunResult plain = Pipeline(makeSource(phantom.image, "x")).run(smallParams());
    RunOptions options;
    options.snapshots = std::make_shared<Mailbox<EvolutionSnapshot>>();
    options.snapshotSeconds = 0.0;
    options.control = std::make_shared<EvolutionControl>();
    options.control->paused = true;
    std::jthread player([control = options.control] {
      control->stepsWanted = 3;
      while (control->stepsWanted != 0) std::this_thread::yield();
      control->paused = false;
    });
    const RunResult watched = Pipeline(makeSource(phantom.image, "x")).run(smallParams(), options);
    QVERIFY(watched.evolve->phi->voxels == plain.evolve->phi->voxels);
    const auto snapshot = options.snapshots->take();
    QVERIFY(snapshot != nullptr);
    QCOMPARE(snapshot->iterations, watched.evolve->iterations);
    QVERIFY(!snapshot->surface->triangles.empty());
    QVERIFY(options.snapshots->take() == nullptr);
  }

  void anEvolutionStoppedByHandIsNotRemembered() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    RunOptions options;
    options.control = std::make_shared<EvolutionControl>();
    options.control->finishNow = true;
    const RunResult stopped = pipeline.run(smallParams(), options);
    QCOMPARE(stopped.evolve->stopReason, StopReason::Stopped);
    QVERIFY(!pipeline.has(Step::Evolve, smallParams()));
    QVERIFY(!pipeline.has(Step::Quality, smallParams()));
    QVERIFY(pipeline.run(smallParams()).evolve->stopReason != StopReason::Stopped);
  }

  void aRestoredEvolutionIsTakenForItsKeyAlone() {
    const Source source = makeSource(smallBifurcation().image, "bifurcation");
    Pipeline first(source);
    const RunResult run = first.run(smallParams());
    const StageReport report = run.stages[3];
    QCOMPARE(report.step, Step::Evolve);
    Pipeline second(source);
    Parameters other = smallParams();
    other.thresholds.xi += 1.0;
    QVERIFY(!second.restore(run.evolve, report, other));
    QVERIFY(!second.restore(run.evolve, run.stages[4], smallParams()));
    QVERIFY(!second.has(Step::Evolve, smallParams()));
    QVERIFY(second.restore(run.evolve, report, smallParams()));
    const RunResult again = second.run(smallParams());
    QVERIFY(!again.vesselness && !again.seeds);
    QVERIFY(again.evolve == run.evolve);
    QVERIFY(again.smoothed->points == run.smoothed->points);
    QVERIFY(again.smoothed->triangles == run.smoothed->triangles);
    // A change of a step before it makes all of them again.
    other = smallParams();
    other.vesselness.sigmaMaxMm = 3.0;
    QVERIFY(second.run(other).vesselness);
    RunOptions options;
    options.until = Step::Vesselness;
    QVERIFY(second.run(smallParams(), options).vesselness);
  }

  void aSegmentationIsMeshedAsItIs() {
    // Two labels that touch, thick slices, a region of interest.
    Volume<float> labels(cube(40));
    labels.geometry.spacing = {0.5, 0.5, 1.0};
    for (int k = 0; k < 40; ++k)
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 40; ++i)
          if (std::hypot(i - 18.3, j - 19.6, 0.3 * (k - 19.0)) < 5.0)
            labels.at(i, j, k) = i < 18 ? 7.0F : 3.0F;
    const double voxels = double(std::count(labels.voxels.begin(), labels.voxels.end(), 7.0F));
    const double voxelMm3 = labels.geometry.voxelVolumeMm3();
    Pipeline pipeline(makeSource(labels, "labels"));
    Parameters params;
    params.segmentation.method = SegmentationMethod::Label;
    params.segmentation.label = 7;
    const RunResult run = pipeline.run(params);
    QVERIFY(!run.vesselness && !run.seeds);
    QCOMPARE(run.evolve->phi->geometry.size, labels.geometry.size);
    QCOMPARE(double(run.evolve->label->voxels), voxels);
    QVERIFY(run.evolve->label->largestShiftVoxels < 0.5);
    // The sharp rim where the labels touch becomes round.
    QVERIFY(std::fabs(double(run.surface->insideVoxels) - voxels) < 0.015 * voxels);
    QVERIFY(run.quality->mesh.closed);
    QVERIFY(std::fabs(run.quality->mesh.volumeMm3 / (voxels * voxelMm3) - 1.0) < 0.02);

    // Nothing of a scan's parameters counts, the label does.
    Parameters other = params;
    other.vesselness.sigmaMaxMm = 9.0;
    other.preprocess.sigmoidEnabled = true;
    other.seeds.automatic = false;
    QCOMPARE(pipeline.run(other).stages.back().reused, true);
    other.segmentation.label = 3;
    QVERIFY(pipeline.run(other).evolve->label->voxels != run.evolve->label->voxels);
    other.segmentation.label = 5;
    QVERIFY_THROWS_EXCEPTION(InputError, pipeline.run(other));
    // As resampling leaves labels.
    for (float& value : labels.voxels) value *= 0.99F;
    const RunResult near = Pipeline(makeSource(labels, "labels")).run(params);
    QCOMPARE(near.evolve->label->voxels, run.evolve->label->voxels);
    params.preprocess.roi = {0.0, 0.0, 0.0, 20.0, 20.0, 20.0};
    QCOMPARE(pipeline.run(params).evolve->phi->geometry.size, (Index3{40, 40, 21}));
  }

  void cancelAndFailuresLeaveThePipelineUsable() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, pipeline.run(smallParams(), {}, progress));
    Parameters dark = smallParams();
    dark.thresholds.b = 1.0;
    QVERIFY_THROWS_EXCEPTION(NumericError, pipeline.run(dark));
    QVERIFY(pipeline.run(smallParams()).quality->mesh.closed);
  }

  void aFailureAfterTheEvolutionMayKeepWhatWasComputed() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    Parameters params = smallParams();
    params.surface.maxTriangles = 100;
    QVERIFY_THROWS_EXCEPTION(InputError, pipeline.run(params));
    RunOptions options;
    options.keepOnFailure = true;
    const RunResult run = pipeline.run(params, options);
    QVERIFY(run.failure && run.failure->step == Step::Surface);
    QVERIFY(run.evolve && !run.surface && !run.smoothed && !run.quality);
    QCOMPARE(run.key, pipeline.key(Step::Correct, params));
    QVERIFY(run.stages.back().step == Step::Correct);
    // What failed before is thrown all the same.
    params.thresholds.b = 1.0;
    QVERIFY_THROWS_EXCEPTION(NumericError, pipeline.run(params, options));
  }

  void whatIsKnownBeforehandIsSaidBeforehand() {
    Volume<float> wild(cube(24));
    for (std::size_t i = 0; i < wild.voxels.size(); ++i)
      wild.voxels[i] = randomUniform(3, i) < 0.45 ? 1.0F : 0.0F;
    Pipeline pipeline(makeSource(std::move(wild), "wild"));
    Parameters params = smallParams();
    params.segmentation.method = SegmentationMethod::Label;
    params.surface.sizing = SizingParams::printed();
    RunOptions options;
    options.until = Step::Surface;
    struct Enough {};
    std::vector<std::string> said;
    options.warned = [&](Step step, const std::string& warning) {
      QVERIFY(step == Step::Surface);
      said.push_back(warning);
      throw Enough();  // before anything is meshed
    };
    QVERIFY_THROWS_EXCEPTION(Enough, pipeline.run(params, options));
    QCOMPARE(said.size(), std::size_t{1});
    QVERIFY2(said[0].find("surface.edgeMinMm") != std::string::npos, said[0].c_str());
  }

  void finerCellsGiveMoreTriangles() {
    Pipeline pipeline(makeSource(twoTubes(), "tubes"));
    Parameters params = smallParams();
    params.surface.method = SurfaceMethod::MarchingCubes;
    const RunResult normal = pipeline.run(params);
    QCOMPARE(normal.quality->mesh.triangles, normal.quality->marchingCubes.triangles);
    params.surface.cellVoxels = 0.5;
    const RunResult fine = pipeline.run(params);
    QVERIFY(fine.quality->mesh.triangles > 3 * normal.quality->mesh.triangles);
    QCOMPARE(fine.quality->marchingCubes.triangles, normal.quality->marchingCubes.triangles);
    QVERIFY(fine.quality->unsmoothed.centroidDeviation->meanMm <
            normal.quality->unsmoothed.centroidDeviation->meanMm);
  }
};

QTEST_GUILESS_MAIN(TestPipeline)
#include "tst_pipeline.moc"
