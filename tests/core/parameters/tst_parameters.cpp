// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>
#include <fstream>
#include <set>

#include "core/base/error.h"
#include "core/parameters/field.h"
#include "core/parameters/presets.h"
#include "tests/core/random_parameters.h"
#include "tests/core/refusal.h"

using namespace angiomesh;
using angiomesh::test::randomValue;

namespace {

/// The cells of the rows of docs/parameters.md: of its presets, which are their name and what they
/// are for, and of its fields: key, default, values in other presets, what is allowed, unit,
/// meaning.
struct DocumentedRows {
  std::vector<std::vector<std::string>> presets, fields;
};

DocumentedRows documentedRows() {
  std::vector<std::vector<std::string>> rows;
  DocumentedRows all;
  std::ifstream page(ANGIOMESH_SOURCE_DIR "/docs/parameters.md");
  for (std::string line; std::getline(page, line);) {
    if (line.compare(0, 3, "| `") != 0) continue;
    rows.emplace_back();
    for (std::size_t at = 2; at < line.size();) {
      const std::size_t end = line.find(" |", at);
      if (end == std::string::npos) break;
      rows.back().push_back(line.substr(at, end - at));
      at = end + 3;
    }
  }
  for (auto& row : rows) (row.size() == 2 ? all.presets : all.fields).push_back(std::move(row));
  return all;
}

/// Of "0 (ct, head-cta); 2 (thesis)" what a preset has; `usual` where it is not named.
std::string documentedValue(const std::string& others, const std::string& usual,
                            const std::string& preset) {
  for (std::size_t at = 0; at < others.size();) {
    const std::size_t open = others.find(" (", at), close = others.find(')', at);
    const std::string names = ", " + others.substr(open + 2, close - open - 2) + ",";
    if (names.find(", " + preset + ",") != std::string::npos) return others.substr(at, open - at);
    at = close + 3;
  }
  return usual;
}

}  // namespace

class TestParameters : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void keysAreUniqueAndDescribed() {
    std::set<std::string> keys;
    for (const Field& field : parameterFields()) {
      QVERIFY2(keys.insert(field.key).second, field.key.c_str());
      QVERIFY(!field.help.empty());
      QVERIFY(field.kind == FieldKind::Choice || field.kind == FieldKind::Texts ||
              field.minimum < field.maximum);
    }
  }

  // What people read is what the table holds, and what is taken ends where the page says.
  void thePageSaysWhatIsTaken() {
    const auto [presets, rows] = documentedRows();
    QCOMPARE(rows.size(), parameterFields().size());
    QCOMPARE(presets.size(), shippedPresets().size());
    for (std::size_t p = 0; p < presets.size(); ++p) {
      QCOMPARE(presets[p][0], "`" + shippedPresets()[p].name + "`");
      QCOMPARE(presets[p][1], shippedPresets()[p].about);
    }
    for (std::size_t n = 0; n < rows.size(); ++n) {
      const std::vector<std::string>& row = rows[n];
      const Field& field = parameterFields()[n];
      QCOMPARE(row[0], "`" + field.key + "`");
      for (const Preset& preset : shippedPresets()) {
        Parameters written = preset.params;
        // So that it is known to be set.
        field.put(written, randomValue(field, n));
        setFieldFromText(written, field.key, documentedValue(row[2], row[1], preset.name));
        QVERIFY2(field.get(written) == field.get(preset.params), field.key.c_str());
      }
      QCOMPARE(row[4], field.unit);
      QCOMPARE(row[5], field.help);
      if (field.kind != FieldKind::Integer && field.kind != FieldKind::Real) continue;
      const std::string& allowed = row[3];
      const double low = std::stod(allowed),
                   high = std::stod(allowed.substr(allowed.find("to ") + 3));
      const auto taken = [&](double value) {
        Parameters params;
        FieldValue number = value;
        if (field.kind == FieldKind::Integer) number = static_cast<std::int64_t>(value);
        return messageOf([&] { setField(params, field.key, number); }).empty();
      };
      const double beyond = field.kind == FieldKind::Integer ? 1.0 : 1e-3 * (high - low);
      QVERIFY2(taken(low) && taken(high), field.key.c_str());
      QVERIFY2(
          (!taken(low - beyond) || (field.zeroIsEmpty && low == beyond)) && !taken(high + beyond),
          field.key.c_str());
    }
  }

  // A slider, and what a form begins with, lie in the range.
  void slidersLieInTheirRanges() {
    const Parameters usual;
    FieldContext context;
    context.largestValue = 40.0;
    for (const Field& field : parameterFields()) {
      if (field.kind != FieldKind::Integer && field.kind != FieldKind::Real) continue;
      const auto [low, high] = sliderRange(field, context);
      QVERIFY2(low < high, field.key.c_str());
      QVERIFY(low >= field.minimum && high <= field.maximum);
      Parameters suggested;
      setField(suggested, field.key, suggestedValue(field, usual, context));
    }
  }

  void anyParametersSurviveJsonAndText() {
    for (std::uint64_t n = 0; n < 50; ++n) {
      Parameters params;
      Parameters byText;
      std::uint64_t counter = 0;
      for (const Field& field : parameterFields()) {
        const FieldValue value = randomValue(field, n * 1000 + counter++);
        setField(params, field.key, value);
        setFieldFromText(byText, field.key, fieldText(value, field));
        QVERIFY(field.get(params) == value);
        QVERIFY2(field.get(byText) == value, field.key.c_str());
      }
      const Parameters back = parametersFromJson(parametersToJson(params), Parameters{}, "test");
      for (const Field& field : parameterFields())
        QVERIFY2(field.get(back) == field.get(params), field.key.c_str());
    }
  }

  void defaultsLieInTheirRanges() {
    for (const std::string& name : presetNames()) {
      Parameters params = preset(name);
      validate(params);
      for (const Field& field : parameterFields()) setField(params, field.key, field.get(params));
    }
  }

  // Choosing one puts the user's places aside, so it must have none.
  void presetsHaveNoPlaces() {
    std::set<std::string> names;
    for (const Preset& preset : shippedPresets()) {
      QVERIFY(names.insert(preset.name).second);
      QVERIFY(!preset.about.empty() && preset.about.back() == '.');
      for (const Field& field : parameterFields())
        if (field.place) QVERIFY(field.get(preset.params) == field.get(Parameters()));
    }
    QVERIFY(preset("angiomesh") == Parameters());
    QCOMPARE(presetNames().front(), std::string("angiomesh"));
  }

  void presetsDifferOnlyWhereTheyShould() {
    const Parameters own = preset("angiomesh");
    const Parameters thesis = preset("thesis");
    std::set<std::string> different;
    for (const Field& field : parameterFields())
      if (field.get(own) != field.get(thesis)) different.insert(field.key);
    const std::set<std::string> expected{"vesselness.scaleRule",
                                         "vesselness.contrast",
                                         "levelset.bRule",
                                         "levelset.start",
                                         "levelset.maxIterations",
                                         "levelset.checkEvery",
                                         "levelset.refine",
                                         "wall.smooth",
                                         "levelset.acrossCrests",
                                         "surface.spline",
                                         "levelset.stepVoxels",
                                         "seeds.least",
                                         "vesselness.scalesFromImage",
                                         "surface.border",
                                         "smooth.method",
                                         "surface.etaCompensated",
                                         "surface.rho",
                                         "surface.edgeMinVoxels",
                                         "surface.edgesAround"};
    QVERIFY(different == expected);

    const auto keysOf = [&](const char* name, const char* base) {
      std::set<std::string> keys;
      for (const Field& field : parameterFields())
        if (field.get(preset(name)) != field.get(preset(base))) keys.insert(field.key);
      return keys;
    };
    const std::set<std::string> region{"vesselness.sigmaMaxMm", "segmentation.minLengthMm"};
    for (const char* name : {"brain-tof", "abdominal-mra", "peripheral-mra"})
      QVERIFY(keysOf(name, "angiomesh") == region);
    QVERIFY(keysOf("head-cta", "ct") == region);
    QVERIFY(keysOf("head-cta", "brain-tof") == keysOf("ct", "angiomesh"));
    QVERIFY_THROWS_EXCEPTION(InputError, preset("thesys"));
  }

  void wrongInputIsNamed() {
    Parameters p;
    const std::string unknown = messageOf([&] { setFieldFromText(p, "levelset.gama", "1"); });
    QVERIFY2(unknown.find("levelset.gamma") != std::string::npos, unknown.c_str());
    for (const auto& [key, text] :
         std::vector<std::pair<const char*, const char*>>{{"levelset.gamma", "1.5"},
                                                          {"levelset.gamma", "much"},
                                                          {"levelset.gamma", "0.5x"},
                                                          {"levelset.gamma", "nan"},
                                                          {"levelset.gamma", "auto"},
                                                          {"levelset.checkEvery", "0"},
                                                          {"levelset.checkEvery", "2.5"},
                                                          {"vesselness.measure", "best"},
                                                          {"preprocess.sigmoid.enabled", "maybe"},
                                                          {"preprocess.roi", "1,2,3"},
                                                          {"seeds.points", "1,2"},
                                                          {"seeds.points", "1,,3"}}) {
      const std::string message = messageOf([&, k = key, t = text] { setFieldFromText(p, k, t); });
      QVERIFY2(message.find(key) != std::string::npos, key);
    }
    for (const char* json : {"{\"levelset\": {\"gama\": 1}}", "{\"levelset\": 3}", "[1]", "{",
                             "{\"levelset.gamma\": \"0.7\"}", "{\"levelset.gamma\": 7}"})
      QVERIFY_THROWS_EXCEPTION(InputError, parametersFromJson(json, p, "test"));
    p.vesselness.sigmaMinMm = 3.0;
    p.vesselness.sigmaMaxMm = 2.0;
    QVERIFY_THROWS_EXCEPTION(InputError, validate(p));
    Parameters edges;
    edges.surface.sizing.edgeMinMm = 0.5;
    validate(edges);
    edges.surface.sizing.edgeMaxMm = 0.4;
    QVERIFY_THROWS_EXCEPTION(InputError, validate(edges));
    edges.surface.sizing.edgeMaxMm = 0.5;
    validate(edges);
  }

  void noLimitCanBeWrittenAsZeroOrNone() {
    for (const char* text : {"none", "0"}) {
      Parameters p;
      setFieldFromText(p, "surface.edgesAround", text);
      QCOMPARE(p.surface.sizing.edgesAround, 0);
      QCOMPARE(fieldText(findField("surface.edgesAround").get(p), findField("surface.edgesAround")),
               std::string("none"));
    }
    const Parameters zero = parametersFromJson("{\"surface.edgesAround\": 0}", {}, "test");
    QCOMPARE(zero.surface.sizing.edgesAround, 0);
    Parameters p;
    for (const char* text : {"1", "2", "-1", "auto"})
      QVERIFY_THROWS_EXCEPTION(InputError, setFieldFromText(p, "surface.edgesAround", text));
    QVERIFY_THROWS_EXCEPTION(InputError, setFieldFromText(p, "surface.edgeMinMm", "0"));
    setFieldFromText(p, "surface.edgeMinMm", "none");
    QVERIFY(!p.surface.sizing.edgeMinMm);
  }

  void fieldsWithoutEffectSayWhy() {
    Parameters p;
    const auto idle = [&p](const char* key) { return findField(key).idle(p); };
    p.surface.method = SurfaceMethod::MarchingCubes;
    QVERIFY(!idle("surface.rho").empty());
    QVERIFY(idle("surface.cellVoxels").empty());
    p.smooth.method = SmoothMethod::KeepWall;
    QVERIFY(!idle("smooth.mu").empty());
    QVERIFY(idle("smooth.wallBoundVoxels").empty());
    p.surface.method = SurfaceMethod::AdvancingFront;
    QVERIFY(idle("surface.rho").empty());
    QVERIFY(!idle("surface.cellVoxels").empty());
    QVERIFY(!idle("smooth.wallBoundVoxels").empty());
    QVERIFY(!idle("smooth.lambda").empty());
    p.smooth.method = SmoothMethod::Taubin;
    for (const char* key : {"smooth.iterations", "smooth.lambda", "smooth.mu"})
      QVERIFY2(idle(key).empty(), key);
    p.smooth.method = SmoothMethod::None;
    QVERIFY(!idle("smooth.iterations").empty());
  }

  void dottedAndNestedKeysChangeOnlyWhatTheyName() {
    const Parameters p =
        parametersFromJson("{\"levelset.xi\": 31, \"preprocess\": {\"sigmoid\": {\"window\": 5}}}",
                           preset("thesis"), "test");
    QCOMPARE(p.thresholds.xi, 31.0);
    QCOMPARE(*p.preprocess.sigmoidWindow, 5.0);
    QCOMPARE(p.levelset.gamma, 0.7);
    QVERIFY(p.smooth.method == SmoothMethod::Taubin);
  }
};

QTEST_GUILESS_MAIN(TestParameters)
#include "tst_parameters.moc"
