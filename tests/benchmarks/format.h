// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers and files of the benchmark programs.
// Scope: printf's formats for one number; text files are written whole or not at all.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace muckpile::benchmark {

inline std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path);
  out << text;
  if (!out.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace muckpile::benchmark
