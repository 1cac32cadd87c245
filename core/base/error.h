// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>

namespace angiomesh {

/// Base of every failure that Angiomesh reports. what() is one line: "WHAT, WHERE: WHAT TO DO
/// NEXT".
class Error : public std::runtime_error {
 public:
  /// @param what what happened   @param where file, field or step (may be empty)   @param advice
  /// what to do next
  Error(const std::string& what, const std::string& where, const std::string& advice);

  /// WHAT alone.
  [[nodiscard]] std::string cause() const { return std::string(what(), causeLength_); }

 private:
  std::size_t causeLength_;
};

/// The user's input or parameters cannot be used.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A file or folder cannot be read or written.
class IoError : public Error {
 public:
  using Error::Error;
};

/// A computation has no usable result (for example, no seed was found).
class NumericError : public Error {
 public:
  using Error::Error;
};

/// Thrown by Progress::report() once cancellation was asked for. Not an error.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace angiomesh
