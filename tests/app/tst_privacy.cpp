// SPDX-License-Identifier: BSD-3-Clause
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/cli_process.h"
#include "tests/io/planted_identity.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// As identityTexts(), where the output tells the series, as `info` has to.
std::vector<std::string> allButUids() {
  std::vector<std::string> texts = identityTexts();
  texts.pop_back();
  return texts;
}

QJsonValue withoutOwnWords(const QJsonValue& value) {
  if (value.isArray()) {
    QJsonArray array;
    for (const QJsonValue& one : value.toArray()) array.append(withoutOwnWords(one));
    return array;
  }
  QJsonObject object = value.toObject();
  if (object.isEmpty()) return value;
  for (const QString& key : object.keys())
    if (key == "series_description" || key == "date" || key == "name")
      object.remove(key);
    else
      object[key] = withoutOwnWords(object[key]);
  return object;
}
QJsonDocument withoutOwnWords(const QJsonDocument& json) {
  return QJsonDocument(withoutOwnWords(QJsonValue(json.object())).toObject());
}

}  // namespace

// The commands on inputs that say who it is, in their headers and in the names of their files and
// folders: nothing that is written may.
class TestPrivacy : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir root_;
  fs::path planted_;  ///< what tells it
  fs::path home_;     ///< all that is written lies in here
  QString out_;
  std::vector<fs::path> volumes_, masks_, meshes_;
  fs::path series_, gaps_, damaged_;
  int outputs_ = 0;        ///< in JSON
  std::size_t files_ = 0;  ///< that are planted

  CliResult cli(const QStringList& arguments) {
    CliResult result = runCli(out_, arguments);
    // As if redirected into a file, which is what JSON is for.
    if (arguments.contains("--json"))
      save(QString("%1/%2.json").arg(out_).arg(++outputs_).toStdString(),
           result.output.toStdString());
    return result;
  }
  [[nodiscard]] static QString text(const fs::path& path) {
    return QString::fromStdString(path.string());
  }

  void done(const QStringList& arguments) {
    const CliResult result = cli(arguments);
    QVERIFY2(result.code == 0, result.errors.constData());
  }
  void verifyNothingTold(const std::vector<std::string>& texts = identityTexts()) {
    const std::string told = joined(identityIn(home_, texts));
    QVERIFY2(told.empty(), told.c_str());
  }

 private Q_SLOTS:
  void initTestCase() {
    const fs::path root = root_.path().toStdString();
    home_ = root / "home";
    makeHome(home_);
    fs::create_directories(home_ / "out");
    out_ = text(home_ / "out");
    planted_ = root / "planted";
    const Phantom phantom = plantedTubes();
    series_ = plantedFolder(planted_ / "whole");
    savePlantedSeries(phantom.image, series_);
    gaps_ = plantedFolder(planted_ / "gaps");
    savePlantedSeries(phantom.image, gaps_, {11, 12, 20});
    damaged_ = plantedFolder(planted_ / "damaged");
    savePlantedSlice(phantom.image, 0, damaged_ / (std::string(kPerson) + ".dcm"));
    const std::string whole = bytesOf(damaged_ / (std::string(kPerson) + ".dcm"));
    save(damaged_ / (std::string(kPerson) + "_2.dcm"), whole.substr(0, whole.size() - 1000));
    const fs::path folder = plantedFolder(planted_ / "volumes");
    volumes_ = savePlantedVolumes(phantom.image, folder);
    fs::create_directories(folder / "masks");
    masks_ = savePlantedVolumes(phantom.truth, folder / "masks");
    meshes_ = savePlantedMeshes(plantedFolder(planted_ / "meshes"));
    files_ = filesBelow(planted_);
  }
  void init() {
    fs::remove_all(home_ / "out");
    fs::create_directories(home_ / "out");
  }

  void cleanup() { QCOMPARE(filesBelow(planted_), files_); }

  /// Else the other tests would show nothing.
  void theSearchFindsWhatIsPlanted() {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(planted_)) {
      if (!entry.is_regular_file()) continue;
      const std::string extension = entry.path().extension().string();
      if (extension == ".raw" || entry.path().string().ends_with(".raw.gz")) continue;
      ++files;
      QVERIFY2(!foundIn(bytesOf(entry.path()), {kPerson}).empty(), entry.path().c_str());
      if (extension != ".dcm") continue;
      for (const std::string what : {kBirthDate, kStudyDate, kUidRoot})
        QVERIFY2(!foundIn(bytesOf(entry.path()), {what}).empty(), what.c_str());
    }
    QVERIFY(files > 70);
    QCOMPARE(identityIn(planted_, {"no such text"}), std::vector<std::string>());
    QCOMPARE(identityIn(plantedFolder(root_.path().toStdString() + "/empty").parent_path()).size(),
             std::size_t{1});
    const std::string name = std::string("of ") + kPerson + ".";
    for (const std::string& form :
         {lowered(name), wide(name), '\0' + wide(name), gzipped(name), "PNG" + gzipped(wide(name)),
          gzipped("in it: " + gzipped(name)), QByteArray(name.c_str()).toBase64().toStdString(),
          QByteArray(name.substr(1).c_str()).toBase64().toStdString(),
          QByteArray(name.substr(2).c_str()).toBase64().toStdString()})
      QCOMPARE(foundIn(form, {kPerson}).size(), std::size_t{1});
  }

  /// They refer to the scan by its UIDs, and name the patient on request alone.
  void segmentationsForViewers() {
    const QString series = text(series_);
    done({"run", series, "-o", "run", "--until", "evolve"});
    done({"convert", "run/mask.nrrd", "-o", "none.dcm", "--like", series});
    done({"convert", "run/mask.nrrd", "-o", "of.dcm", "--like", series, "--identity"});
    const auto found = [&](const char* name) {
      return foundIn(bytesOf(home_ / "out" / name), {kPerson, kBirthDate, kStudyDate});
    };
    QVERIFY2(found("none.dcm").empty(), joined(found("none.dcm")).c_str());
    QCOMPARE(found("of.dcm").size(), std::size_t{3});
    done({"evaluate", "none.dcm", "run/mask.nrrd", "--json"});
    const CliResult alone = cli({"convert", "run/mask.nrrd", "-o", "alone.dcm"});
    QVERIFY(alone.code == 2 && alone.errors.contains("--like"));
    const CliResult other = cli({"convert", "run/mask.nrrd", "-o", "other.nrrd", "--like", series});
    QVERIFY(other.code == 2 && other.errors.contains(".dcm"));
    for (const char* name : {"alone.dcm", "other.nrrd"}) QVERIFY(!fs::exists(home_ / "out" / name));
  }

  void aRunOfADicomFolder() {
    const QString series = text(series_);
    done({"run", series, "-o", "whole", "--truth", text(masks_.front())});
    QCOMPARE(filesIn(out_ + "/whole").size(), 11);
    const QString settings = root_.filePath(QString(kPerson) + ".json");
    fs::copy_file(home_ / "out/whole/recipe.json", settings.toStdString());
    done({"run", series, "-o", "whole", "--force", "--until", "vesselness", "--recipe", settings});
    done({"run", text(gaps_), "-o", "gaps", "--until", "evolve", "--uneven-slices", "resample",
          "--series", QString(kUidRoot) + ".2"});
    QVERIFY(bytesOf(home_ / "out/gaps/report.json").find("resampled") != std::string::npos);
    verifyNothingTold();
  }

  void whatFailsLeavesNothing() {
    for (const QStringList& arguments :
         {QStringList{"run", text(gaps_), "-o", "gaps"},
          QStringList{"run", text(damaged_), "-o", "damaged"},
          QStringList{"run", text(series_) + "/none", "-o", "none"},
          QStringList{"convert", text(gaps_), "-o", "gaps.mha"},
          QStringList{"info", "--json",
                      text(series_ / (kPerson + std::string("_series")) /
                           (kPerson + std::string("_letter.txt")))},
          QStringList{"mesh", text(volumes_.front()), "-o", "none/mesh.ply", "--json"}}) {
      QCOMPARE(cli(arguments).code, 2);
    }
    verifyNothingTold();
  }

  void theStepsOneByOne() {
    const QString image = text(volumes_[1]), mask = text(masks_[1]), ball = text(meshes_[0]);
    done({"vesselness", text(series_), "-o", "vesselness.mha"});
    done({"segment", image, "-o", "phi.nii.gz", "--method", "threshold"});
    done({"mesh", mask, "-o", "mask.vtp", "--json"});
    done({"mesh", mask, "--estimate", "--json"});
    done({"smooth", ball, "-o", "smooth.obj", "--phi", mask});
    done({"quality", ball, "--against", text(meshes_[1]), "--json"});
    done({"quality", "mask.vtp", "--phi", mask, "--json"});
    done({"evaluate", mask, text(masks_[2]), "--json"});
    done({"skeleton", mask, "-o", "lines.csv", "-o", "lines.vtp", "--json"});
    done({"phantom", "tube", "-o", "tube", "--size", "16"});
    verifyNothingTold();
  }

  void volumesFromFormatToFormat() {
    std::vector<fs::path> inputs = volumes_;
    inputs.push_back(series_);
    int n = 0;
    for (const fs::path& input : inputs)
      for (const char* end : {".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz"})
        done({"convert", text(input), "-o", QString::number(++n) + end});
    verifyNothingTold();
  }

  void meshesFromFormatToFormat() {
    int n = 0;
    for (const fs::path& input : meshes_) {
      for (const char* end : {".ply", ".stl", ".obj", ".off", ".vtp"})
        done({"convert", text(input), "-o", QString::number(++n) + end});
      // Names of patches lie packed and in base64 in a VTP file, where the search does not look.
      for (const std::string& name :
           loadMesh(out_.toStdString() + "/" + std::to_string(n) + ".vtp").patchNames)
        QVERIFY2(name.find(kPerson) == std::string::npos, name.c_str());
      for (const char* end : {".ply", ".stl"})
        done({"convert", text(input), "-o", QString::number(++n) + end, "--ascii"});
    }
    done({"convert", text(meshes_[3]), "-o", "parts.ply", "--patch-files"});
    verifyNothingTold();
  }

  void namesOfSolidsAreKeptWhenAskedFor() {
    const CliResult result =
        cli({"convert", text(meshes_[3]), "-o", "a.stl", "--ascii", "--solid-names"});
    QVERIFY2(result.code == 0, result.errors.constData());
    QVERIFY(!identityIn(home_, {kPerson}).empty());
  }

  void infoInJsonTellsNoMoreThanTheSeries() {
    std::vector<fs::path> inputs = volumes_;
    inputs.push_back(masks_[0]);
    for (const fs::path& input : inputs) done({"info", text(input), "--json"});
    // A list of series says what they call themselves, their day and their UID.
    for (const fs::path& input : {series_, gaps_, damaged_}) {
      const CliResult result = runCli(out_, {"info", text(input), "--json"});
      QVERIFY2(result.code == 0, result.errors.constData());
      QVERIFY(result.output.contains(kUidRoot) && result.output.contains(kPerson));
      save(QString("%1/%2.json").arg(out_).arg(++outputs_).toStdString(),
           withoutOwnWords(QJsonDocument::fromJson(result.output)).toJson().toStdString());
    }
    verifyNothingTold(allButUids());
  }
};

QTEST_GUILESS_MAIN(TestPrivacy)
#include "tst_privacy.moc"
