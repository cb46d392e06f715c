// SPDX-License-Identifier: GPL-2.0-or-later
// The text of large files.
// Scope: whole files; what another program cuts off meanwhile is missing at the end.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace muckpile {

class OpenFile;

// Reads a file from its byte `from` on into `text`, whose memory is used again. Throws InputError
// if it cannot be opened.
void read_text(const std::filesystem::path& path, std::string& text, std::size_t from = 0);

// A file of some 100 MB from its front to its back, through memory that is small and used again:
// new memory would take longer than reading. Throws InputError if the file cannot be opened.
class FileWindow {
 public:
  explicit FileWindow(const std::filesystem::path& path, std::size_t bytes = kBytes);
  ~FileWindow();
  FileWindow(const FileWindow&) = delete;
  FileWindow& operator=(const FileWindow&) = delete;

  // Reads on, to as many bytes as the window holds or the file has.
  void fill();
  // What has been read and not skipped, until the next fill().
  [[nodiscard]] std::string_view text() const {
    return std::string_view(held_.data(), length_).substr(from_);
  }
  void skip(std::size_t bytes) { from_ += bytes; }
  // Where text() begins in the file.
  [[nodiscard]] std::size_t at() const { return read_ - length_ + from_; }
  [[nodiscard]] std::size_t file_size() const;

 private:
  static constexpr std::size_t kBytes = 16 << 20;
  std::unique_ptr<OpenFile> file_;
  std::vector<char> held_;
  std::size_t length_ = 0, from_ = 0;  // of what is held, and of what is skipped of it
  std::size_t read_ = 0;               // of the file
};

}  // namespace muckpile
