// SPDX-License-Identifier: GPL-2.0-or-later
// The text of large files.
// Scope: see the header.
#include "io/file_text.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "parallel/in_parallel.h"

namespace muckpile {

class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path)
      : path_(path.string()), number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    std::error_code no_size;
    const std::uintmax_t size = std::filesystem::file_size(path, no_size);
    if (number_ >= 0 && !no_size) {
      size_ = static_cast<std::size_t>(size);
      return;
    }
    if (number_ >= 0) ::close(number_);
    throw InputError(path.string() + ": cannot be opened");
  }
  ~OpenFile() { ::close(number_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  [[nodiscard]] std::size_t size() const { return size_; }

  // Copies the bytes [from, from + count) on all cores; returns how many of them there were.
  std::size_t read(std::size_t from, std::size_t count, char* to) const {
    constexpr std::size_t kPart = 4 << 20;  // bytes
    std::vector<std::size_t> missing((count + kPart - 1) / kPart, 0);
    in_parallel(missing.size(), [&](std::size_t part) {
      const std::size_t begin = part * kPart, end = std::min(count, begin + kPart);
      missing[part] = end - begin - read_part(from + begin, end - begin, to + begin);
    });
    const auto cut = std::ranges::find_if(missing, [](std::size_t bytes) { return bytes > 0; });
    if (cut == missing.end()) return count;
    const auto part = static_cast<std::size_t>(cut - missing.begin());
    return std::min(count, (part + 1) * kPart) - *cut;
  }

 private:
  std::size_t read_part(std::size_t from, std::size_t count, char* to) const {
    std::size_t done = 0;
    while (done < count) {
      const ::ssize_t got =
          ::pread(number_, to + done, count - done, static_cast<::off_t>(from + done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw InputError(path_ + ": cannot be read: " + std::strerror(errno));
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

  std::string path_;
  int number_;
  std::size_t size_ = 0;
};

void read_text(const std::filesystem::path& path, std::string& text, std::size_t from) {
  const OpenFile in(path);
  text.resize(in.size() - std::min(from, in.size()));
  text.resize(in.read(from, text.size(), text.data()));
}

FileWindow::FileWindow(const std::filesystem::path& path, std::size_t bytes)
    : file_(std::make_unique<OpenFile>(path)), held_(std::min(bytes, file_->size())) {}

FileWindow::~FileWindow() = default;

void FileWindow::fill() {
  std::copy(held_.data() + from_, held_.data() + length_, held_.data());
  length_ -= from_;
  from_ = 0;
  const std::size_t wanted = std::min(held_.size() - length_, file_->size() - read_);
  const std::size_t got = file_->read(read_, wanted, held_.data() + length_);
  length_ += got;
  read_ += got;
}

std::size_t FileWindow::file_size() const { return file_->size(); }

}  // namespace muckpile
