// SPDX-License-Identifier: GPL-2.0-or-later
// A folder that all ranks of a test share and that is gone after it.
// Scope: ranks of one machine; construction and destruction are collective.
#pragma once

#include <filesystem>
#include <string>

namespace muckpile::test {

class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  /// As operator/, another one on each rank: for scenes that each rank runs on its own.
  [[nodiscard]] std::filesystem::path own(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

/// All of a text file, "" if there is none.
[[nodiscard]] std::string content(const std::filesystem::path& path);

}  // namespace muckpile::test
