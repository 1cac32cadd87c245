// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/case_notes.h"

#include <QTest>
#include <string>
#include <utility>

#include "io/case/case_file.h"
#include "io/case/case_journal.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// A measurement of a kind, with numbers that have no short form.
Measurement sampleOf(MeasurementKind kind, double third = 1.0 / 3.0) {
  Measurement m;
  m.kind = kind;
  m.name = std::string("\xc3\x85 \"") + measurementWord(kind);
  for (std::size_t n = 0; n < placesOf(kind); ++n)
    m.places.emplace_back(third, -2.0 * static_cast<double>(n), 1e-17);
  if (kind != MeasurementKind::Distance) m.key = "0123";
  for (std::size_t n = 0; n < sectionsOf(kind); ++n) {
    CrossSection section;
    section.centreLps = {third, 7.0, static_cast<double>(n)};
    section.axisLps = Eigen::Vector3d(1, 2, 3).normalized();
    section.areaMm2 = third;
    section.narrowest = {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6)};
    section.widest = {Eigen::Vector3d(third, 2, 3), Eigen::Vector3d(4, 5, 60)};
    section.outline = {{0, 0, third}, {1, 0, 0}, {0, 1, 0}};
    m.sections.push_back(section);
  }
  if (kind == MeasurementKind::Profile || kind == MeasurementKind::Stenosis)
    m.profile = {{0.0, {1, 2, third}, 3.0, 2.5, 3.5}, {third, {1, 2, 4}, 3.25, 2.75, 4.0}};
  return m;
}

/// One of each kind.
CaseNotes sampleNotes(double third = 1.0 / 3.0) {
  CaseNotes notes;
  for (int kind = 0; kind < kMeasurementKinds; ++kind)
    notes.measurements.push_back(sampleOf(static_cast<MeasurementKind>(kind), third));
  return notes;
}

SavedCase sampleCase() {
  SavedCase document;
  document.source.hash = "0123456789abcdef";
  document.source.grid.size = {64, 48, 40};
  document.params.thresholds.xi = 44.0;
  document.notes = sampleNotes();
  return document;
}

}  // namespace

class TestCaseNotes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsNotedComesBack() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleCase());
    CaseReading reading = readCase(a);
    QVERIFY(reading.warnings.empty());
    QVERIFY(reading.document.notes == sampleNotes());
    QVERIFY(!(reading.document.notes == sampleNotes(0.25)));
    QCOMPARE(reading.document.params.thresholds.xi, 44.0);
    // A case from before there were notes has no word of them.
    SavedCase without = sampleCase();
    without.notes = {};
    writeCase(a, without);
    QVERIFY(bytesOf(a / "case.json").find("notes") == std::string::npos);
    reading = readCase(a);
    QVERIFY(reading.warnings.empty());
    QVERIFY(reading.document.notes == CaseNotes());
  }

  void whatCannotBeReadIsLeftOutOneByOne() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleCase());
    const std::string whole = bytesOf(a / "case.json");
    const auto damage = [&](const std::string& what, const std::string& with) {
      std::string text = whole;
      const std::size_t at = text.find(what);
      QVERIFY2(at != std::string::npos, what.c_str());
      save(a / "case.json", text.replace(at, what.size(), with));
    };
    const std::pair<const char*, const char*> damages[] = {
        {"\"kind\": \"distance\"", "\"kind\": \"volume\""},
        {"\"kind\": \"section\"", "\"kind\": \"distance\""},
        {"\"kind\": \"profile\"", "\"kind\": 3"},
        {"\"profileMm\": [", "\"profileMm\": [1.0,"},
        {"\"widestMm\": [", "\"widestMm\": [1.0, 2.0, 3.0,"},
        {"\"areaMm2\": 0", "\"areaMm2\": -0"},
        {"\"centreMm\": [", "\"centreMm\": [null,"}};
    for (const auto& [what, with] : damages) {
      damage(what, with);
      const CaseReading reading = readCase(a);
      QCOMPARE(reading.warnings.size(), std::size_t(1));
      QVERIFY(reading.warnings.front().find("1 measurement") == 0);
      QCOMPARE(reading.document.notes.measurements.size(), std::size_t(kMeasurementKinds - 1));
    }
    damage("\"notes\": {", "\"notes\": [1], \"other\": {");
    const CaseReading reading = readCase(a);
    QCOMPARE(reading.warnings.size(), std::size_t(1));
    QVERIFY(reading.document.notes == CaseNotes());
    QCOMPARE(reading.document.params.thresholds.xi, 44.0);
  }

  void aReviewComesBackAsItWas() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    SavedCase saved = sampleCase();
    saved.notes = {};
    CaseReview& review = saved.notes.review;
    review.verdict = Verdict::Rejected;
    review.score = 2;
    review.key = "0123abc";
    review.remarks = {{{1.0 / 3.0, -2.0, 7e-3}, 4, "two vessels, \"touching\"\nhere"},
                      {{0.0, 0.0, 0.0}, 0, ""}};
    review.seen = {{DoubtKind::Neck, {1.5, 2.5, -3.5}}, {DoubtKind::Missed, {0.1, 0.2, 0.3}}};
    writeCase(a, saved);
    const CaseReading whole = readCase(a);
    QVERIFY(whole.warnings.empty());
    QVERIFY(whole.document.notes == saved.notes);
    // What is damaged is left out by itself.
    const std::string text = bytesOf(a / "case.json");
    for (const auto& [what, with] :
         std::vector<std::pair<std::string, std::string>>{{"\"neck\"", "\"nick\""},
                                                          {"\"score\": 4", "\"score\": 6"},
                                                          {"\"score\": 4", "\"score\": 1e99"}}) {
      std::string damaged = text;
      QVERIFY(damaged.find(what) != std::string::npos);
      save(a / "case.json", damaged.replace(damaged.find(what), what.size(), with));
      const CaseReading reading = readCase(a);
      QCOMPARE(reading.warnings.size(), std::size_t(1));
      QVERIFY(reading.warnings.front().find("the review of the case is damaged") == 0);
      const CaseReview& left = reading.document.notes.review;
      QCOMPARE(left.remarks.size() + left.seen.size(), std::size_t(3));
      QCOMPARE(left.verdict, Verdict::Rejected);
      QCOMPARE(left.score, 2);
    }
    std::string damaged = text;
    damaged.replace(damaged.find("\"rejected\""), 10, "\"perhaps\"");
    save(a / "case.json", damaged);
    const CaseReading reading = readCase(a);
    QCOMPARE(reading.warnings.size(), std::size_t(1));
    QCOMPARE(reading.document.notes.review.verdict, Verdict::None);
    QCOMPARE(reading.document.notes.review.remarks.size(), std::size_t(2));
  }

  void theJournalHasThemToo() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleCase());
    JournalStep edit{0, 1, "measure a distance", {}, sampleNotes(0.1)};
    appendJournal(a, {edit});
    edit.position = 2;
    edit.notes = {};
    appendJournal(a, {edit});
    const std::vector<JournalStep> steps = readJournal(a, 0);
    QCOMPARE(steps.size(), std::size_t(2));
    QVERIFY(steps[0].notes == sampleNotes(0.1));
    QVERIFY(steps[1].notes == CaseNotes());
    // It stands in for saves that are damaged.
    edit.position = 3;
    edit.notes = sampleNotes(0.2);
    appendJournal(a, {edit});
    save(a / "case.json", "{");
    QVERIFY(readCase(a).document.notes == sampleNotes(0.2));
  }

  void theLastEditStaysHoweverLong() {
    const Folder folder;
    const fs::path a = folder / "a.angiomesh";
    writeCase(a, sampleCase());
    JournalStep edit{0, 0, "measure a stenosis", {}, {}};
    edit.notes.measurements.push_back(sampleOf(MeasurementKind::Stenosis));
    for (CrossSection& section : edit.notes.measurements.back().sections)
      section.outline.resize(20000, {1.0 / 3.0, 2.0 / 3.0, 1.0 / 7.0});
    for (int n = 0; n < 3; ++n) {
      ++edit.position;
      appendJournal(a, {edit});
      QVERIFY(fs::file_size(a / "edits/journal.jsonl") > 1 << 20);
      const std::vector<JournalStep> steps = readJournal(a, 0);
      QVERIFY(!steps.empty() && steps.size() < 3);
      QCOMPARE(steps.back().position, edit.position);
      QVERIFY(steps.back().notes == edit.notes);
    }
  }
};

QTEST_APPLESS_MAIN(TestCaseNotes)
#include "tst_case_notes.moc"
