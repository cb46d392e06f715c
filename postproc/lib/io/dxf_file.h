// SPDX-License-Identifier: GPL-2.0-or-later
// Drawings in DXF: surfaces in, lines and outlines out.
// Scope: text DXF. Read are 3DFACE, polyface meshes and POINT of the section ENTITIES, whatever
// their layer; written is release 12, which every program reads.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/stl_file.h"
#include "math/types.h"

namespace muckpile {

struct DxfSurface {
  std::vector<StlTriangle> triangles;  // of faces; one of four corners is two
  std::vector<Vec3> points;
};

// In the file's own axes and unit. Throws InputError, with file and line, on a file that is cut, is
// binary or no DXF, has a face with a corner that is no finite number or is not there, or neither a
// face nor three points.
DxfSurface read_dxf(const std::filesystem::path& path);

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
