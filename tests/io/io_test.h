// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <QString>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace angiomesh::test {

namespace fs = std::filesystem;

inline std::string bytesOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void save(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// What the failure of some work says; empty: it did not fail.
inline QString messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline int entriesOf(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/// The most addresses that the program has had, in MB: also of memory that was never touched. 0
/// under the sanitizers, which set memory aside for themselves.
inline double peakMb() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("VmPeak:")) return std::stod(line.substr(7)) / 1024.0;
#endif
  return 0.0;
}

/// A folder that goes away with the object.
class Folder {
 public:
  [[nodiscard]] fs::path operator/(const std::string& name) const { return path() / name; }
  [[nodiscard]] fs::path path() const { return folder_.path().toStdString(); }

 private:
  QTemporaryDir folder_;
};

/// What comes out of file descriptors 1 and 2 while the object lives.
class TerminalCapture {
 public:
  TerminalCapture() {
    file_.open();
    flush();
    out_ = ::dup(1);
    err_ = ::dup(2);
    ::dup2(file_.handle(), 1);
    ::dup2(file_.handle(), 2);
  }
  ~TerminalCapture() { restore(); }
  QString text() {
    restore();
    return QString::fromStdString(bytesOf(file_.fileName().toStdString()));
  }

 private:
  static void flush() {
    std::fflush(stdout);
    std::fflush(stderr);
  }
  void restore() {
    if (out_ < 0) return;
    flush();
    ::dup2(out_, 1);
    ::dup2(err_, 2);
    ::close(out_);
    ::close(err_);
    out_ = -1;
  }
  QTemporaryFile file_;
  int out_ = -1;
  int err_ = -1;
};

/// Lets files grow to `bytes` only, as on a full disk, while the object lives.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

}  // namespace angiomesh::test
