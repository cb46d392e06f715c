// SPDX-License-Identifier: GPL-2.0-or-later
// The text of large files.
// Scope: whole files; what another program cuts off meanwhile is missing at the end.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace muckpile {

// Reads a file into `text`, whose memory is used again. Throws InputError if it cannot be opened.
void read_text(const std::filesystem::path& path, std::string& text);

// A file of some 100 MB in memory of large pages, which takes half the time that a string would.
// Throws InputError if the file cannot be opened.
class FileText {
 public:
  explicit FileText(const std::filesystem::path& path);
  ~FileText();
  FileText(const FileText&) = delete;
  FileText& operator=(const FileText&) = delete;
  [[nodiscard]] std::string_view text() const { return {place_, length_}; }

 private:
  char* place_ = nullptr;
  std::size_t size_ = 0;    // of the memory
  std::size_t length_ = 0;  // of what has been read
};

}  // namespace muckpile
