// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <set>
#include <string>
#include <utility>

#include "core/parameters/field.h"
#include "core/parameters/presets.h"
#include "core/quality/quality_gates.h"
#include "core/quality/quality_table.h"
#include "core/quality/triangle_measures.h"
#include "io/mesh/mesh_format.h"

namespace angiomesh {
namespace {

/// Contexts and texts, as the window asks for their translation.
class Texts {
 public:
  void add(const char* context, const std::string& text) {
    if (!text.empty()) texts_.emplace(context, text);
  }
  void write(std::ostream& out) const {
    for (const auto& [context, text] : texts_)
      out << "QT_TRANSLATE_NOOP(\"" << context << "\", \"" << quoted(text) << "\")\n";
  }

 private:
  static std::string quoted(const std::string& text) {
    std::string out;
    for (const char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
    return out;
  }

  std::set<std::pair<std::string, std::string>> texts_;
};

void addTables(Texts& texts) {
  for (const Field& field : parameterFields())
    for (const std::string& text : {field.label, field.help, field.rise})
      texts.add("Parameter", text);
  for (const Preset& preset : shippedPresets()) texts.add("Preset", preset.about);
  for (const QualityMeasure& measure : qualityMeasures())
    for (const char* text : {measure.label, measure.meaning}) texts.add("QualityMeasure", text);
  for (const TriangleMeasure& measure : triangleMeasures())
    for (const char* text : {measure.label, measure.meaning}) texts.add("TriangleMeasure", text);
  for (const QualityGate& gate : qualityGates()) {
    texts.add("QualityGate", gate.help);
    for (const QualityGate::Limit& limit : gate.limits) {
      texts.add("QualityGate", limit.why);
      texts.add("QualityGate", fixText(limit.fix));
    }
  }
  for (const StepFacts& step : kSteps) texts.add("QObject", step.title);
  for (const MeshFormat& format : meshFormats())
    if (format.hint) texts.add("MeshFormat", format.hint);
}

}  // namespace
}  // namespace angiomesh

/// Writes the texts of tables below gui to a file, in the form that lupdate finds.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  angiomesh::Texts texts;
  angiomesh::addTables(texts);
  std::ofstream file(argv[1]);
  texts.write(file);
  file.close();
  return file ? 0 : 1;
}
