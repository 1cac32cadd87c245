// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan/label_choice.h"

#include <algorithm>
#include <sstream>

#include "core/base/error.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kListed = 20;

using Labels = std::vector<Label>;

std::string textOf(const Label& label) {
  std::string text = std::to_string(label.value);
  if (!label.name.empty()) text += " '" + label.name + "'";
  text += " (" + std::to_string(label.voxels) + " voxels";
  if (!label.id.empty()) text += ", id:" + label.id;
  return text + ")";
}

std::string listOf(const Labels& labels) {
  std::string text;
  for (std::size_t n = 0; n < labels.size() && n < kListed; ++n)
    text += (n == 0 ? "" : ", ") + textOf(labels[n]);
  if (labels.size() > kListed) text += " and " + std::to_string(labels.size() - kListed) + " more";
  return text;
}

template <class Fits>
Labels those(const Labels& labels, const Fits& fits) {
  Labels found;
  std::copy_if(labels.begin(), labels.end(), std::back_inserter(found), fits);
  return found;
}

Labels byName(const Labels& labels, const std::string& name) {
  return those(labels, [&](const Label& label) { return label.name == name; });
}

Labels byValue(const Labels& labels, const std::string& value) {
  return those(labels, [&](const Label& label) { return std::to_string(label.value) == value; });
}

/// What the text of one label stands for; empty where it stands for none.
Labels matches(const Labels& labels, const std::string& text, const fs::path& path) {
  const auto behind = [&](const char* sign) { return text.substr(std::string(sign).size()); };
  // Labels without a name are not named by nothing.
  if (text.empty() || text == "name:" || text == "id:") return {};
  // A name may begin with "value:" as well.
  Labels found = byName(labels, text);
  const Labels values = byValue(labels, text);
  if (!found.empty() && !values.empty() && (found.size() > 1 || found[0].value != values[0].value))
    throw InputError("'" + text + "' is the name of one label and the value of another",
                     path.string(), "write name:" + text + " or value:" + text);
  if (found.empty()) found = values;
  if (found.empty() && text.starts_with("value:")) found = byValue(labels, behind("value:"));
  if (found.empty() && text.starts_with("name:")) found = byName(labels, behind("name:"));
  if (found.empty() && text.starts_with("id:"))
    found = those(labels, [&](const Label& label) { return label.id == behind("id:"); });
  if (found.size() > 1)
    throw InputError("several labels fit '" + text + "'", path.string(),
                     "choose by value:, by id:, or several between commas: " + listOf(found));
  return found;
}

}  // namespace

Labels chosenLabels(const Labels& labels, const std::string& choice, const fs::path& path) {
  if (choice.empty() && labels.size() == 1) return labels;
  if (choice.empty())
    throw InputError("it holds " + std::to_string(labels.size()) + " labels: " + listOf(labels),
                     path.string(), "choose one by its value or name (--label)");
  // A name may hold commas.
  Labels all = matches(labels, choice, path);
  if (!all.empty()) return all;
  std::istringstream in(choice);
  for (std::string text; std::getline(in, text, ',');) {
    const std::size_t first = text.find_first_not_of(' ');
    text = first == std::string::npos ? ""
                                      : text.substr(first, text.find_last_not_of(' ') + 1 - first);
    const Labels found = matches(labels, text, path);
    if (found.empty())
      throw InputError("there is no label '" + text + "'", path.string(),
                       "choose of " + listOf(labels));
    for (const Label& label : found)
      if (std::none_of(all.begin(), all.end(), [&](const Label& other) {
            return other.value == label.value && other.layer == label.layer;
          }))
        all.push_back(label);
  }
  return all;
}

}  // namespace angiomesh
