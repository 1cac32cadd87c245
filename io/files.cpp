// SPDX-License-Identifier: BSD-3-Clause
#include "io/files.h"

#include <fstream>
#include <sstream>
#include <system_error>

#include "core/base/error.h"

namespace angiomesh {

void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write) {
  namespace fs = std::filesystem;
  const std::string extension =
      path.filename().string().ends_with(".nii.gz") ? ".nii.gz" : path.extension().string();
  const fs::path temporary =
      path.parent_path() / (".angiomesh-" + path.stem().string() + ".part" + extension);
  std::error_code error;
  try {
    write(temporary);
    fs::rename(temporary, path, error);
    if (error)
      throw IoError("cannot write the file (" + error.message() + ")", path.string(),
                    "choose another place");
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

void writeText(const std::filesystem::path& path, std::string_view text) {
  writeAtomically(path, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out)
      throw IoError("cannot write the file", path.string(),
                    "check that the folder exists, may be written to and has free space");
  });
}

std::string readText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in || !text)
    throw IoError("cannot read the file", path.string(), "check the name and the permissions");
  return text.str();
}

}  // namespace angiomesh
