// SPDX-License-Identifier: GPL-2.0-or-later
// The text of large files.
// Scope: see the header.
#include "io/file_text.h"

#include <sys/mman.h>

#include <fstream>
#include <new>

#include "args/input_error.h"

namespace muckpile {
namespace {

// Opens a file and tells its length.
std::size_t open_file(const std::filesystem::path& path, std::ifstream& in) {
  in.open(path, std::ios::binary);
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(path, no_size);
  if (!in || no_size) throw InputError(path.string() + ": cannot be opened");
  return static_cast<std::size_t>(size);
}

// Returns how much could be read.
std::size_t read_bytes(std::ifstream& in, char* to, std::size_t size) {
  in.read(to, static_cast<std::streamsize>(size));
  return static_cast<std::size_t>(in.gcount());
}

}  // namespace

void read_text(const std::filesystem::path& path, std::string& text) {
  std::ifstream in;
  text.resize(open_file(path, in));
  text.resize(read_bytes(in, text.data(), text.size()));
}

FileText::FileText(const std::filesystem::path& path) {
  std::ifstream in;
  size_ = open_file(path, in);
  if (size_ == 0) return;
  void* const place =
      ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED) throw std::bad_alloc();
  (void)::madvise(place, size_, MADV_HUGEPAGE);  // advice: small pages do as well
  place_ = static_cast<char*>(place);
  length_ = read_bytes(in, place_, size_);
}

FileText::~FileText() {
  if (place_ != nullptr) ::munmap(place_, size_);
}

}  // namespace muckpile
