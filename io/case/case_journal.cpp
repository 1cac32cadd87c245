// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/case_journal.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/parameters/field.h"
#include "io/case/case_file.h"
#include "io/file/files.h"
#include "io/file/staged_folder.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Some 100 edits; then the journal is cut to half of that.
constexpr off_t kLongestBytes = 1 << 20;

fs::path journalOf(const fs::path& folder) { return placeIn(folder, "edits/journal.jsonl"); }

std::string lineOf(const JournalStep& step) {
  Json json = {{"saves", step.saves},
               {"position", step.position},
               {"text", step.text},
               {"parameters", Json::parse(parametersToJson(step.params))}};
  if (step.notes != CaseNotes()) json["notes"] = Json::parse(notesToJson(step.notes));
  return json.dump() + "\n";
}

/// Of one line; false when it was not written whole or by another version of the program.
bool parseLine(std::string_view line, JournalStep& step) {
  const Json json = parseJson<Json>(line);
  if (!json.is_object()) return false;
  try {
    step.saves = countIn(json.at("saves"));
    step.position = countIn(json.at("position"));
    step.text = json.at("text").get<std::string>();
    step.params =
        parametersFromJson(json.at("parameters").dump(), preset("angiomesh"), "the journal");
    std::vector<std::string> leftOut;
    if (json.contains("notes")) step.notes = notesFromJson(json["notes"].dump(), leftOut);
    if (!leftOut.empty()) return false;
  } catch (const Json::exception&) {
    return false;
  } catch (const std::out_of_range&) {
    return false;
  } catch (const InputError&) {
    return false;
  }
  return true;
}

/// A file descriptor that is closed at the end.
class Descriptor {
 public:
  explicit Descriptor(const fs::path& path)
      : fd_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

bool writeAll(int fd, std::string_view bytes, off_t at) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(fd, bytes.data(), bytes.size(), at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
    at += written;
  }
  return true;
}

[[noreturn]] void refuse(const fs::path& file, int code) {
  throw IoError("cannot note the edit (" + std::generic_category().message(code) + ")",
                file.string(), "check that the folder may be written to and has free space");
}

/// The line that a journal begins with, if the case says what it was made of.
std::string headOf(const fs::path& folder) {
  const std::string source = caseSourceText(folder);
  return source.empty() ? "" : "{\"source\":" + source + "}\n";
}

/// Keeps the head and the last half of a long journal, whole lines only, but the last one at least.
void cut(const fs::path& folder, const fs::path& file) {
  const std::string text = readText(file);
  std::size_t from = text.find('\n', text.size() / 2);
  if (from == text.size() - 1) from = text.rfind('\n', from - 1);
  if (from != std::string::npos) writeText(file, headOf(folder) + text.substr(from + 1));
}

}  // namespace

void appendJournal(const fs::path& folder, const std::vector<JournalStep>& steps) {
  const fs::path file = journalOf(folder);
  std::error_code error;
  fs::create_directory(file.parent_path(), error);
  if (error) refuse(file, error.value());
  off_t size = 0;
  {
    const Descriptor journal(file);
    struct stat status {};
    if (journal.get() < 0 || ::fstat(journal.get(), &status) != 0) refuse(file, errno);
    // Of another name elsewhere: what is added here would be added there.
    if (!S_ISREG(status.st_mode) || status.st_nlink != 1)
      throw IoError("cannot note the edit, the journal is no file of the case's own", file.string(),
                    "save the case under another name");
    size = status.st_size;
    // A line that was not written whole must not spoil the next one.
    char last = '\n';
    if (size > 0 && ::pread(journal.get(), &last, 1, size - 1) != 1) refuse(file, errno);
    std::string text = size == 0 ? headOf(folder) : last == '\n' ? "" : "\n";
    for (const JournalStep& step : steps) text += lineOf(step);
    const bool written =
        writeAll(journal.get(), text, size) && (::fsync(journal.get()) == 0 || errno == EINVAL);
    if (!written) {
      const int code = errno;
      if (::ftruncate(journal.get(), size) != 0) refuse(file, code);
      refuse(file, code);
    }
    size += static_cast<off_t>(text.size());
  }
  if (size > kLongestBytes) cut(folder, file);
}

std::vector<JournalStep> readJournal(const fs::path& folder, int saves) {
  std::vector<JournalStep> steps;
  const fs::path file = journalOf(folder);
  std::error_code error;
  if (!fs::exists(file, error)) return steps;
  const std::string text = readText(file);
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    JournalStep step;
    if (end != std::string::npos &&
        parseLine(std::string_view(text).substr(start, end - start), step) && step.saves >= saves) {
      const bool same = !steps.empty() && steps.back().saves == step.saves &&
                        steps.back().position == step.position && steps.back().text == step.text;
      if (same) steps.pop_back();
      steps.push_back(std::move(step));
    }
    start = end == std::string::npos ? text.size() : end + 1;
  }
  return steps;
}

std::string journalSource(const fs::path& folder) {
  const std::string text = readText(journalOf(folder));
  const Json json = parseJson<Json>(std::string_view(text).substr(0, text.find('\n')));
  return json.is_object() && json.contains("source") ? json["source"].dump() : std::string();
}

void removeJournal(const fs::path& folder) {
  std::error_code error;
  fs::path file;
  try {
    file = journalOf(folder);
  } catch (const IoError&) {
    return;
  }
  fs::remove(file, error);
  fs::remove(folder / "edits", error);
}

}  // namespace angiomesh
