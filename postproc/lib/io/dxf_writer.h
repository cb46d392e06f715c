// SPDX-License-Identifier: GPL-2.0-or-later
// Drawings in DXF: lines and outlines out.
// Scope: release 12, which every program reads.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "math/types.h"

namespace muckpile {

class DxfWriter {
 public:
  // Throws InputError, naming the file, if it cannot be written.
  explicit DxfWriter(const std::filesystem::path& path);
  ~DxfWriter();
  DxfWriter(const DxfWriter&) = delete;
  DxfWriter& operator=(const DxfWriter&) = delete;

  // Layers: letters, digits, _ and -; other characters become _.
  void line(const std::string& layer, const Vec3& from, const Vec3& to);
  void outline(const std::string& layer, const std::vector<Vec3>& corners);  // closed
  void text(const std::string& layer, const Vec3& place, double height, const std::string& words);

 private:
  void begin(const char* kind, const std::string& layer);
  void place(int code, const Vec3& point);

  std::ofstream out_;
};

}  // namespace muckpile
