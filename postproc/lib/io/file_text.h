// SPDX-License-Identifier: GPL-2.0-or-later
// The text of large files.
// Scope: whole files that nobody writes to meanwhile.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace muckpile {

// Reads a file into `text`, whose memory is used again. Throws InputError if it cannot be opened.
void read_text(const std::filesystem::path& path, std::string& text);

// A file as the system holds it in memory, without a copy. Throws InputError if it is no file that
// can be read.
class MappedText {
 public:
  explicit MappedText(const std::filesystem::path& path);
  ~MappedText();
  MappedText(const MappedText&) = delete;
  MappedText& operator=(const MappedText&) = delete;
  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};

}  // namespace muckpile
