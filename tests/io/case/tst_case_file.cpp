// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/case_file.h"

#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <QTest>
#include <chrono>
#include <functional>
#include <thread>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "io/case/case_cache.h"
#include "io/case/case_journal.h"
#include "io/case/find_source.h"
#include "io/file/files.h"
#include "io/file/temporary_place.h"
#include "io/volume/image_write.h"
#include "tests/core/random_parameters.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

SavedCase sampleDocument(std::uint64_t seed = 1) {
  SavedCase document;
  document.source.hash = "0123456789abcdef";
  document.source.format = "DICOM";
  document.source.files = 40;
  document.source.grid.size = {64, 48, 40};
  document.source.grid.spacing = {0.35, 0.35, 0.6};
  document.source.grid.origin = {-11.25, 7.1, 1.0 / 3.0};
  document.source.grid.direction = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).matrix();
  document.params = randomParameters(seed);
  document.view.layer = "vesselness";
  document.view.windowLevels = {{"source", {300.0, 120.0}}, {"vesselness", {0.5, 0.25}}};
  document.view.slabs = {{"axial", {"mip", 7.5}}, {"coronal", {"none", 4.0}}};
  document.view.overlay = "speed";
  document.view.overlayOpacity = 0.25;
  document.view.planes = CasePlanes{
      true, {{"axial", {0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0}}}, {1.0 / 3.0, -2.0, 5.5}};
  document.view.crosshairLps = Eigen::Vector3d(1.5, -2.25, 0.1);
  document.view.shown = {{"contours", true}, {"surface", false}};
  document.view.mesh = "exported";
  document.view.colour = "minAngle";
  document.saves = 3;
  return document;
}

void verifyEqual(const SavedCase& a, const SavedCase& b) {
  QCOMPARE(a.source.hash, b.source.hash);
  QCOMPARE(a.source.format, b.source.format);
  QCOMPARE(a.source.files, b.source.files);
  QVERIFY(a.source.grid == b.source.grid);
  QCOMPARE(parametersToJson(a.params), parametersToJson(b.params));
  QCOMPARE(a.view.layer, b.view.layer);
  QVERIFY(a.view.windowLevels == b.view.windowLevels);
  QVERIFY(a.view.slabs == b.view.slabs);
  QCOMPARE(a.view.overlay, b.view.overlay);
  QCOMPARE(a.view.overlayOpacity, b.view.overlayOpacity);
  QVERIFY(a.view.planes == b.view.planes);
  QVERIFY(a.view.crosshairLps == b.view.crosshairLps);
  QVERIFY(a.view.shown == b.view.shown);
  QCOMPARE(a.view.mesh, b.view.mesh);
  QCOMPARE(a.view.colour, b.view.colour);
  QCOMPARE(a.saves, b.saves);
}

template <class E>
std::string messageOf(const std::function<void()>& f) {
  try {
    f();
  } catch (const E& error) {
    return error.what();
  }
  return {};
}

JournalStep step(int saves, int position, double xi) {
  JournalStep result;
  result.saves = saves;
  result.position = position;
  result.text = "change levelset.xi";
  result.params.thresholds.xi = xi;
  return result;
}

Volume<float> smallTree() {
  PhantomParams params;
  params.size = {36, 34, 32};
  params.spacingMm = {0.5, 0.5, 0.8};
  return makePhantom(params).image;
}

CaseSource describe(const Volume<float>& image) {
  CaseSource source;
  source.hash = contentHash(image);
  source.format = "NRRD";
  source.grid = image.geometry;
  return source;
}

void replaceIn(const fs::path& file, const std::string& what, const std::string& with) {
  std::string text = bytesOf(file);
  const std::size_t at = text.find(what);
  QVERIFY2(at != std::string::npos, what.c_str());
  save(file, text.replace(at, what.size(), with));
}

}  // namespace

class TestCaseFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsSavedComesBack() {
    const Folder folder;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const SavedCase document = sampleDocument(seed);
      writeCase(folder / "a.angiomesh", document);
      const CaseReading reading = readCase(folder / "a.angiomesh");
      QVERIFY(reading.warnings.empty());
      verifyEqual(reading.document, document);
    }
    QVERIFY(isCase(folder / "a.angiomesh"));
    QCOMPARE(caseFolder(folder / "a.angiomesh" / "case.json"), folder / "a.angiomesh");
    QCOMPARE(caseFolder(folder / "a.angiomesh/"), folder / "a.angiomesh");
    QCOMPARE(caseFolder(folder / "scan.nrrd"), folder / "scan.nrrd");
    QCOMPARE(entriesOf(folder.path()), 1);
  }

  void theSampleOfSchema1OpensForEver() {
    const fs::path sample = fs::path(ANGIOMESH_TEST_DATA) / "schema-1.angiomesh";
    const CaseReading reading = readCase(sample);
    for (const std::string& warning : reading.warnings) QVERIFY2(false, warning.c_str());
    const SavedCase& document = reading.document;
    QCOMPARE(document.source.hash, std::string("0123456789abcdef"));
    QCOMPARE(document.source.grid.size[2], 40);
    QCOMPARE(document.source.grid.origin[2], 1.0 / 3.0);
    QCOMPARE(document.params.thresholds.xi, 33.25);
    QCOMPARE(document.params.segmentation.keep, KeepComponents::Largest);
    QCOMPARE(document.params.seeds.points, (std::vector<double>{1.0, -2.5, 3.0}));
    for (const char* pane : {"sagittal", "coronal", "axial"})
      QVERIFY((document.view.slabs.at(pane) == CaseSlab{"mip", 7.5}));
    QCOMPARE(document.view.crosshairLps->x(), 1.5);
    const std::vector<JournalStep> steps = readJournal(sample, document.saves);
    QCOMPARE(steps.size(), std::size_t(2));
    QCOMPARE(steps[0].text, std::string("change levelset.xi"));
    QCOMPARE(steps[1].params.thresholds.xi, 41.0);
  }

  void aNewerSchemaIsRefusedInWords() {
    const Folder folder;
    writeCase(folder / "a.angiomesh", sampleDocument());
    writeCase(folder / "a.angiomesh", sampleDocument());
    replaceIn(folder / "a.angiomesh/case.json", "\"schema\": 1", "\"schema\": 2");
    const std::string message =
        messageOf<InputError>([&] { (void)readCase(folder / "a.angiomesh"); });
    QVERIFY2(message.find("newer Angiomesh (schema 2") != std::string::npos, message.c_str());
    QVERIFY(message.find("update the program") != std::string::npos);
  }

  void aDamagedCaseOpensAsItWasBefore() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument(1));
    const std::string whole = bytesOf(a / "case.json");
    for (const std::string& damaged :
         {std::string(), std::string("{"), whole.substr(0, 700), std::string("[1]"),
          std::string("{\"schema\": 1}"), std::string("{\"schema\": \"x\"}")}) {
      save(a / "case.json", damaged);
      QVERIFY_THROWS_EXCEPTION(IoError, (void)readCase(a));
    }
    save(a / "case.json", whole);
    writeCase(a, sampleDocument(2));
    save(a / "case.json", whole.substr(0, whole.size() / 2));
    CaseReading reading = readCase(a);
    QCOMPARE(reading.warnings.size(), std::size_t(1));
    verifyEqual(reading.document, sampleDocument(1));
    // A save over a damaged file must not take the good copy's place with it.
    writeCase(a, sampleDocument(3));
    verifyEqual(readCase(a).document, sampleDocument(3));
    fs::remove(a / "case.json");
    reading = readCase(a);
    QCOMPARE(reading.warnings.size(), std::size_t(1));
    verifyEqual(reading.document, sampleDocument(1));
  }

  void unknownParametersAreNamedAndMissingOnesHaveDefaults() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    SavedCase document = sampleDocument();
    document.params = preset("angiomesh");
    document.params.thresholds.xi = 44.0;
    writeCase(a, document);
    replaceIn(a / "case.json", "\"xi\"", "\"xj\"");
    const CaseReading reading = readCase(a);
    QCOMPARE(reading.warnings.size(), std::size_t(1));
    QVERIFY(reading.warnings.front().find("levelset.xj") != std::string::npos);
    QCOMPARE(reading.document.params.thresholds.xi, Parameters().thresholds.xi);
    replaceIn(a / "case.json", "\"xj\": 44.0", "\"xi\": -1.0");
    replaceIn(a / "case.json", "\"method\": \"advancing-front\"", "\"method\": \"marching-cubes\"");
    const CaseReading other = readCase(a);
    QCOMPARE(other.warnings.size(), std::size_t(1));
    QVERIFY(other.warnings.front().find("levelset.xi") != std::string::npos);
    QCOMPARE(other.document.params.thresholds.xi, Parameters().thresholds.xi);
    QCOMPARE(other.document.params.surface.method, SurfaceMethod::MarchingCubes);
    replaceIn(a / "case.json", "\"layer\": \"vesselness\"", "\"layer\": 7");
    replaceIn(a / "case.json", "\"xi\": -1.0", "\"xi\": 2.0");
    QCOMPARE(readCase(a).warnings.size(), std::size_t(1));
    QCOMPARE(readCase(a).document.params.thresholds.xi, 2.0);
  }

  void aCountThatIsNoneIsDamage() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument());
    const std::string whole = bytesOf(a / "case.json");
    const std::pair<std::string, std::string> counts[] = {
        {"\"saves\": ", "3"}, {"\"files\": ", "40"}, {"\"size\": [\n      ", "64"}};
    for (const auto& [key, value] : counts)
      for (const char* other : {"true", "1.5", "1e300", "-1", "2147483647", "4294967299",
                                "18446744073709551615", "null"}) {
        save(a / "case.json", whole);
        replaceIn(a / "case.json", key + value, key + other);
        QVERIFY_THROWS_EXCEPTION(IoError, (void)readCase(a));
      }
    for (const char* schema : {"0", "-1", "18446744073709551615"}) {
      save(a / "case.json", whole);
      replaceIn(a / "case.json", "\"schema\": 1", std::string("\"schema\": ") + schema);
      QVERIFY_THROWS_EXCEPTION(IoError, (void)readCase(a));
    }
    save(a / "case.json", whole);
    replaceIn(a / "case.json", "\"schema\": 1", "\"schema\": 4294967297");
    QVERIFY_THROWS_EXCEPTION(InputError, (void)readCase(a));
    save(a / "case.json", whole);
    appendJournal(a, {step(3, 1, 25.0), step(3, 2, 26.0)});
    replaceIn(a / "edits/journal.jsonl", "\"saves\":3", "\"saves\":4294967299");
    QCOMPARE(readJournal(a, 3).size(), std::size_t(1));
  }

  void theJournalStandsInForDamagedSaves() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument(1));
    writeCase(a, sampleDocument(2));
    appendJournal(a, {step(3, 1, 25.0), step(3, 2, 26.0)});
    for (const char* name : {"case.json", "case.previous.json"}) save(a / name, "{\"schema\": 1");
    const CaseReading reading = readCase(a);
    QCOMPARE(reading.document.params.thresholds.xi, 26.0);
    QCOMPARE(reading.document.source.hash, sampleDocument().source.hash);
    QVERIFY(reading.document.source.grid == sampleDocument().source.grid);
    QCOMPARE(reading.warnings.size(), std::size_t(1));
    fs::remove(a / "edits/journal.jsonl");
    QVERIFY_THROWS_EXCEPTION(IoError, (void)readCase(a));
  }

  void deepAndHugeTextIsDamage() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument(1));
    appendJournal(a, {step(3, 1, 25.0)});
    save(a / "edits/journal.jsonl", bytesOf(a / "edits/journal.jsonl") + std::string(200000, '[') +
                                        std::string(200000, ']') + "\n");
    QCOMPARE(readJournal(a, 0).size(), std::size_t(1));
    save(a / "case.json", "{\"a\":" + std::string(200000, '[') + std::string(200000, ']') + "}");
    QVERIFY(!readCase(a).warnings.empty());
    std::string many = "{\"k\": 1";
    for (int n = 0; n < 300000; ++n) many += ",\"k" + std::to_string(n) + "\":1";
    save(a / "case.json", many + "}");
    QVERIFY(!readCase(a).warnings.empty());
  }

  void noLinkInACaseIsFollowed_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"case.json", "case.previous.json", "edits", "edits/journal.jsonl",
                             "cache", "cache/evolve.json", "cache/evolve.nrrd"})
      QTest::newRow(name) << QString(name);
  }
  void noLinkInACaseIsFollowed() {
    QFETCH(const QString, name);
    const Folder folder, elsewhere;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument(1));
    const fs::path target = elsewhere / "target", link = a / name.toStdString();
    const bool isFolder = name == "edits" || name == "cache";
    if (isFolder)
      fs::create_directory(target);
    else
      save(target, bytesOf(a / "case.json"));
    fs::create_directories(link.parent_path());
    fs::remove(link);
    fs::create_symlink(target, link);
    const std::string before = isFolder ? "" : bytesOf(target);
    CachedEvolve evolve;
    evolve.report.key = "1";
    evolve.result.phi = std::make_shared<const Volume<float>>(smallTree());
    int refused = 0;
    for (const std::function<void()>& work : std::vector<std::function<void()>>{
             [&] { (void)readCase(a); }, [&] { writeCase(a, sampleDocument(2)); },
             [&] { appendJournal(a, {step(3, 1, 25.0)}); }, [&] { (void)readJournal(a, 0); },
             [&] { writeCache(a, evolve); }}) {
      const std::string message = messageOf<IoError>(work);
      if (message.empty()) continue;
      ++refused;
      QVERIFY2(message.find("link") != std::string::npos, message.c_str());
    }
    QVERIFY(refused > 0);
    removeJournal(a);
    QVERIFY(fs::is_symlink(link));
    QCOMPARE(entriesOf(elsewhere.path()), 1);
    if (isFolder)
      QCOMPARE(entriesOf(target), 0);
    else
      QCOMPARE(bytesOf(target), before);
  }

  void aJournalOfTwoNamesIsNotWritten() {
    const Folder folder, elsewhere;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument(1));
    save(elsewhere / "target", "theirs");
    fs::create_directory(a / "edits");
    fs::create_hard_link(elsewhere / "target", a / "edits/journal.jsonl");
    QVERIFY_THROWS_EXCEPTION(IoError, appendJournal(a, {step(3, 1, 25.0)}));
    QCOMPARE(bytesOf(elsewhere / "target"), std::string("theirs"));
  }

  void placesThatAreNoCaseAreRefused() {
    const Folder folder;
    QVERIFY_THROWS_EXCEPTION(IoError, (void)readCase(folder / "none.angiomesh"));
    QVERIFY_THROWS_EXCEPTION(IoError, writeCase(folder / "no/a.angiomesh", sampleDocument()));
    save(folder / "file.angiomesh", "x");
    QVERIFY_THROWS_EXCEPTION(IoError, writeCase(folder / "file.angiomesh", sampleDocument()));
    fs::create_directory(folder / "photos");
    save(folder / "photos/1.jpg", "x");
    QVERIFY_THROWS_EXCEPTION(IoError, writeCase(folder / "photos", sampleDocument()));
    QVERIFY(!isCase(folder / "photos"));
    QCOMPARE(entriesOf(folder / "photos"), 1);
    fs::create_directory(folder / "empty.angiomesh");
    writeCase(folder / "empty.angiomesh", sampleDocument());
    verifyEqual(readCase(folder / "empty.angiomesh").document, sampleDocument());
  }

  void aFullDiskLeavesTheCaseAsItWas() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument(1));
    appendJournal(a, {step(3, 1, 25.0)});
    {
      const FullDisk disk(500);
      QVERIFY_THROWS_EXCEPTION(IoError, writeCase(a, sampleDocument(2)));
      QVERIFY_THROWS_EXCEPTION(IoError, appendJournal(a, {step(3, 2, 26.0)}));
      QVERIFY_THROWS_EXCEPTION(IoError, writeCase(folder / "b.angiomesh", sampleDocument()));
    }
    verifyEqual(readCase(a).document, sampleDocument(1));
    QCOMPARE(readJournal(a, 3).size(), std::size_t(1));
    QCOMPARE(entriesOf(folder.path()), 1);
    appendJournal(a, {step(3, 2, 26.0)});
    QCOMPARE(readJournal(a, 3).size(), std::size_t(2));
  }

  void aKilledProgramLeavesACaseThatOpens() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    int most = 0;
    // On a busy machine it takes more rounds until anything is saved.
    for (std::uint64_t round = 0; round < 25 || (most <= 1 && round < 1000); ++round) {
      const pid_t child = ::fork();
      if (child == 0) {
        SavedCase document = sampleDocument(round);
        for (document.saves = most + 1;; ++document.saves) {
          writeCase(a, document);
          appendJournal(a, {step(document.saves, 1, 25.0), step(document.saves, 2, 26.0)});
        }
      }
      QVERIFY(child > 0);
      std::this_thread::sleep_for(
          std::chrono::microseconds(500 + static_cast<int>(40000 * randomUniform(round, 7))));
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
      if (!fs::exists(a)) continue;
      const CaseReading reading = readCase(a);
      QVERIFY(reading.warnings.empty());
      QVERIFY(reading.document.saves >= most);
      most = reading.document.saves;
      for (const JournalStep& each : readJournal(a, 0))
        QVERIFY(each.params.thresholds.xi == 25.0 || each.params.thresholds.xi == 26.0);
    }
    QVERIFY(most > 1);
  }

  void whatAKilledProgramLeftGoesWhenTheCaseIsOpened() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument());
    appendJournal(a, {step(3, 1, 22.0)});
    fs::create_directory(a / "cache");
    const auto hidden = [&] {
      int count = 0;
      for (const auto& entry : fs::recursive_directory_iterator(a))
        if (entry.path().filename().string().starts_with(".")) ++count;
      return count;
    };
    const pid_t child = ::fork();
    if (child == 0) {
      for (const char* name : {"", "cache", "edits"})
        new TemporaryPlace(a / name, TemporaryPlace::Kind::File);
      ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
    QCOMPARE(hidden(), 3);
    const TemporaryPlace mine(a, TemporaryPlace::Kind::File);
    verifyEqual(readCase(a).document, sampleDocument());
    QCOMPARE(hidden(), 1);
    QVERIFY(fs::exists(mine.path()));
  }

  void theJournalTellsWhatCameAfterTheLastSave() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument());
    QVERIFY(readJournal(a, 3).empty());
    appendJournal(a, {step(2, 1, 21.0), step(3, 1, 22.0)});
    appendJournal(a, {step(3, 1, 23.0)});
    appendJournal(a, {step(3, 2, 24.0)});
    std::vector<JournalStep> steps = readJournal(a, 3);
    QCOMPARE(steps.size(), std::size_t(2));
    QCOMPARE(steps[0].params.thresholds.xi, 23.0);
    QCOMPARE(steps[1].params.thresholds.xi, 24.0);

    const fs::path file = a / "edits/journal.jsonl";
    const std::string whole = bytesOf(file);
    for (std::size_t left = whole.size() - 400; left < whole.size(); left += 37) {
      save(file, whole.substr(0, left));
      QCOMPARE(readJournal(a, 3).size(), std::size_t(1));
    }
    appendJournal(a, {step(3, 2, 27.0)});
    steps = readJournal(a, 3);
    QCOMPARE(steps.size(), std::size_t(2));
    QCOMPARE(steps[1].params.thresholds.xi, 27.0);
    removeJournal(a);
    removeJournal(a);
    QVERIFY(readJournal(a, 0).empty());
    QVERIFY(!fs::exists(a / "edits"));
  }

  void aLongJournalIsCut() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument());
    int position = 0;
    for (int i = 0; i < 60; ++i) {
      std::vector<JournalStep> steps;
      for (int k = 0; k < 10; ++k) steps.push_back(step(0, ++position, 20.0));
      appendJournal(a, steps);
    }
    QVERIFY(fs::file_size(a / "edits/journal.jsonl") <= 1 << 20);
    const std::vector<JournalStep> steps = readJournal(a, 0);
    QVERIFY(steps.size() > 20);
    QCOMPARE(steps.back().position, position);
    QCOMPARE(entriesOf(a / "edits"), 1);
  }

  void theCacheGivesBackItsOwnResultAlone() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleDocument());
    CachedEvolve evolve;
    Volume<float> phi = smallTree();
    phi.geometry.origin = {1.0 / 3.0, -2.0 / 7.0, 1e-3};
    phi.geometry.direction = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    evolve.result.phi = std::make_shared<const Volume<float>>(phi);
    evolve.result.thresholds = {0.2, 0.1, 0.3, true};
    evolve.result.lower = 12.5;
    evolve.result.label = {417, 0.25, 52.125, {3, 2, 1}};
    evolve.result.wall = {0.75, 14, 5, 9};
    evolve.result.iterations = 140;
    evolve.result.stopReason = StopReason::Settled;
    evolve.report.step = Step::Evolve;
    evolve.report.key = "00ff";
    evolve.report.seconds = 1.25;
    evolve.report.warnings = {"b was clamped"};
    QVERIFY(!readCache(a, "00ff"));
    writeCache(a, evolve);
    const auto back = readCache(a, "00ff");
    QVERIFY(back);
    QVERIFY(back->result.phi->geometry == phi.geometry);
    QVERIFY(back->result.phi->voxels == phi.voxels);
    QCOMPARE(back->result.thresholds.b, 0.1);
    QVERIFY(back->result.lower == 12.5 && !back->result.upper);
    const LabelFacts& label = *back->result.label;
    QVERIFY(label.voxels == 417 && label.largestShiftVoxels == 0.25 &&
            label.maskVolumeMm3 == 52.125);
    QVERIFY(label.contacts.joined == 3 && label.contacts.parted == 2 && label.contacts.left == 1);
    const WallFacts& wall = *back->result.wall;
    QVERIFY(wall.spreadVoxels == 0.75 && wall.heldVoxels == 14 && wall.filledHoles == 5 &&
            wall.cutHandles == 9);
    QCOMPARE(back->result.iterations, 140);
    QCOMPARE(back->result.stopReason, StopReason::Settled);
    QVERIFY(back->report.warnings == evolve.report.warnings);
    QVERIFY(!readCache(a, "00fe"));

    const fs::path file = a / "cache/evolve.nrrd";
    const std::string whole = bytesOf(file);
    int refused = 0;
    for (std::size_t part = 1; part < 20; ++part) {
      std::string damaged = whole;
      damaged[part * damaged.size() / 20] ^= 4;
      save(file, damaged);
      // In a run of equal values, a copy from further back is the same copy.
      const auto read = readCache(a, "00ff");
      QVERIFY(!read || read->result.phi->voxels == phi.voxels);
      refused += read ? 0 : 1;
    }
    QVERIFY(refused > 0);
    save(file, whole.substr(0, whole.size() / 2));
    QVERIFY(!readCache(a, "00ff"));
    phi.voxels[0] += 1.0F;
    writeVolume(phi, file);
    QVERIFY(!readCache(a, "00ff"));
    save(file, whole);
    QVERIFY(readCache(a, "00ff"));
    save(a / "cache/evolve.json", "{\"format\": 1, \"key\": \"00ff\"}");
    QVERIFY(!readCache(a, "00ff"));
    for (const char* note : {"[", "{\"format\": \"x\"}", "{\"format\": 3, \"key\": 5}"}) {
      save(a / "cache/evolve.json", note);
      QVERIFY(!readCache(a, "00ff"));
      writeCache(a, evolve);
      QVERIFY(readCache(a, "00ff"));
    }
    fs::remove_all(a / "cache");
    {
      const FullDisk disk(2000);
      QVERIFY_THROWS_EXCEPTION(IoError, writeCache(a, evolve));
    }
    QVERIFY(!readCache(a, "00ff"));
    writeCache(a, evolve);
    QVERIFY(readCache(a, "00ff"));
    QVERIFY(readCase(a).warnings.empty());
  }

  void theSourceIsKnownByItsContent() {
    const Folder folder;
    const Volume<float> image = smallTree();
    Volume<float> other = image;
    other.voxels[100] += 1.0F;
    const CaseSource source = describe(image);
    fs::create_directories(folder / "study/cases");
    const fs::path a = folder / "study/cases/a.angiomesh";
    writeCase(a, sampleDocument());
    save(folder / "study/notes.txt", "no image");
    save(folder / "study/broken.nrrd", "NRRD0004\n");
    writeVolume(other, folder / "study/cases/first.nrrd");
    QVERIFY(!findSource(placesNear(a), source));
    QVERIFY(!sourceAt(folder / "study/cases/first.nrrd", source));
    QVERIFY_THROWS_EXCEPTION(InputError, (void)sourceAt(folder / "study/notes.txt", source));

    writeVolume(image, folder / "study/moved.mha");
    auto found = findSource(placesNear(a), source);
    QVERIFY(found);
    QCOMPARE(found->path, folder / "study/moved.mha");
    QCOMPARE(found->hash, source.hash);
    fs::rename(folder / "study/moved.mha", folder / "study/cases/renamed.mha");
    found = findSource(placesNear(a), source);
    QVERIFY(found && found->path == folder / "study/cases/renamed.mha");
    Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)findSource(placesNear(a), source, progress));
  }
};

QTEST_APPLESS_MAIN(TestCaseFile)
#include "tst_case_file.moc"
