// SPDX-License-Identifier: BSD-3-Clause
#include "io/file/temporary_place.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <random>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/formatted.h"
#include "io/file/file_lock.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = ".angiomesh-";
constexpr std::string_view kLock = ".angiomesh-lock";
constexpr std::chrono::hours kForeignAge{24};

/// The lowest eight digits.
std::string hexadecimal(std::uint64_t number) {
  return formatted("%08x", static_cast<unsigned>(number));
}

/// FNV-1a, which is the same for every program.
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

/// Of this machine's name, which need not be told to everybody.
const std::string& machine() {
  static const std::string text = [] {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return hexadecimal(hashOf(name.data()));
  }();
  return text;
}

std::string newName(const std::string& extension) {
  static std::atomic<unsigned> counter{0};
  static const unsigned salt = std::random_device{}();
  return std::string(kPrefix) + machine() + "-" + std::to_string(::getpid()) + "-" +
         std::to_string(salt) + "-" + std::to_string(counter++) + extension;
}

/// The process in a temporary place's name; 0 where it is none, -1 on another machine.
long processIn(std::string_view name) {
  if (!name.starts_with(kPrefix)) return 0;
  name.remove_prefix(kPrefix.size());
  const std::size_t dash = name.find('-');
  if (dash != 8) return 0;
  long process = 0;
  std::size_t at = dash + 1;
  for (; at < name.size() && name[at] >= '0' && name[at] <= '9' && process < 1000000000L; ++at)
    process = 10 * process + (name[at] - '0');
  if (process == 0 || at == name.size() || name[at] != '-') return 0;
  return name.substr(0, dash) == machine() ? process : -1;
}

}  // namespace

TemporaryPlace::TemporaryPlace(const fs::path& folder, Kind kind, const std::string& extension)
    : path_(folder / newName(extension)) {
  if (kind == Kind::Folder) {
    if (::mkdir(path_.c_str(), 0777) == 0)
      descriptor_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  } else {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  }
  if (descriptor_ < 0)
    throw fs::filesystem_error("", path_, std::error_code(errno, std::generic_category()));
  (void)::flock(descriptor_, LOCK_EX | LOCK_NB);
}

TemporaryPlace::~TemporaryPlace() {
  std::error_code error;
  fs::remove_all(path_, error);
  ::close(descriptor_);
}

bool isLeftover(const fs::path& path) {
  const long process = processIn(path.filename().string());
  if (process == 0 || isLocked(path)) return false;
  if (process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH) return true;
  // Of another machine, or the process has a new owner.
  std::error_code error;
  const auto written = fs::last_write_time(path, error);
  return !error && fs::file_time_type::clock::now() - written > kForeignAge;
}

void removeLeftovers(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.filename().string().starts_with(kPrefix)) old.push_back(path);
  }
  for (const fs::path& path : old) {
    if (path.filename().string().starts_with(kLock)) {
      const FileLock gone(path);
    } else if (isLeftover(path) && !fs::exists(path / kCommitNote, error)) {
      fs::remove_all(path, error);
    }
  }
}

void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fsync(descriptor);
  ::close(descriptor);
}

std::error_code renameNew(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
  if (errno != EINVAL && errno != ENOSYS) return {errno, std::generic_category()};
  std::error_code error;
  if (fs::exists(fs::symlink_status(to, error)))
    return std::make_error_code(std::errc::file_exists);
  fs::rename(from, to, error);
  return error;
}

fs::path outputLockFile(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return folder / kLock;
  return folder.parent_path() /
         (std::string(kLock) + "-" + hexadecimal(hashOf(folder.filename().string())));
}

}  // namespace angiomesh
