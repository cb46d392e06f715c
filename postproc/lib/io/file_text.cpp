// SPDX-License-Identifier: GPL-2.0-or-later
// The text of large files.
// Scope: see the header.
#include "io/file_text.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "args/input_error.h"

namespace muckpile {

void read_text(const std::filesystem::path& path, std::string& text) {
  std::ifstream in(path, std::ios::binary);
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(path, no_size);
  if (!in || no_size) throw InputError(path.string() + ": cannot be opened");
  text.resize(static_cast<std::size_t>(size));
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
}

MappedText::MappedText(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": is not a file");
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct ::stat facts = {};
  if (file < 0 || ::fstat(file, &facts) != 0)
    throw InputError(path.string() + ": cannot be opened");
  const auto size = static_cast<std::size_t>(facts.st_size);
  void* const place =
      size > 0 ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, file, 0) : nullptr;
  ::close(file);
  if (place == MAP_FAILED) throw InputError(path.string() + ": cannot be read");
  text_ = {static_cast<const char*>(place), size};
}

MappedText::~MappedText() {
  if (!text_.empty()) ::munmap(const_cast<char*>(text_.data()), text_.size());
}

}  // namespace muckpile
