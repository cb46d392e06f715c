// SPDX-License-Identifier: GPL-2.0-or-later
// The text of large files.
// Scope: see the header.
#include "io/file_text.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

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

  // Copies the file on all cores; returns how much of it there was.
  std::size_t read(char* to) const {
    constexpr std::size_t kPart = 4 << 20;  // bytes
    std::vector<std::size_t> missing((size_ + kPart - 1) / kPart, 0);
    in_parallel(missing.size(), [&](std::size_t part) {
      const std::size_t end = std::min(size_, (part + 1) * kPart);
      missing[part] = end - read_from(part * kPart, end, to);
    });
    const auto cut = std::ranges::find_if(missing, [](std::size_t bytes) { return bytes > 0; });
    if (cut == missing.end()) return size_;
    const auto part = static_cast<std::size_t>(cut - missing.begin());
    return std::min(size_, (part + 1) * kPart) - *cut;
  }

 private:
  // Returns where what could be read ends.
  std::size_t read_from(std::size_t at, std::size_t end, char* to) const {
    while (at < end) {
      const ::ssize_t got = ::pread(number_, to + at, end - at, static_cast<::off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw InputError(path_ + ": cannot be read: " + std::strerror(errno));
      if (got == 0) break;
      at += static_cast<std::size_t>(got);
    }
    return at;
  }

  std::string path_;
  int number_;
  std::size_t size_ = 0;
};

}  // namespace

void read_text(const std::filesystem::path& path, std::string& text) {
  const OpenFile in(path);
  text.resize(in.size());
  text.resize(in.read(text.data()));
}

FileText::FileText(const std::filesystem::path& path) {
  const OpenFile in(path);
  size_ = in.size();
  if (size_ == 0) return;
  void* const place =
      ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) throw std::bad_alloc();
  (void)::madvise(place, size_, MADV_HUGEPAGE);  // advice: small pages do as well
  place_ = static_cast<char*>(place);
  length_ = in.read(place_);
}

FileText::~FileText() {
  if (place_ != nullptr) ::munmap(place_, size_);
}

}  // namespace muckpile
