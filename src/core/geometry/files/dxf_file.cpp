// SPDX-License-Identifier: GPL-2.0-or-later
// Drawings in DXF: surfaces in.
// Scope: see the header.
#include "geometry/files/dxf_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// Two lines each: what a value is, and the value.
struct Group {
  int code = -1;
  std::string value;
  size_t line = 0;  // of the value
};

struct Entity {
  std::string kind;
  size_t line = 0;
  std::map<int, Group> groups;  // of each code the last
};

class DxfReader {
 public:
  explicit DxfReader(const std::filesystem::path& path) : path_(path.string()), in_(path) {
    if (!in_) refuse(path_, "cannot be opened");
  }

  DxfSurface surface() {
    std::string section;
    Group group;
    bool ended = false;
    while (!ended && next(group)) {
      if (group.code == 0) close(section);
      if (group.code == 0) entity_ = {group.value, group.line, {}};
      if (group.code == 2 && entity_.kind == "SECTION") section = group.value;
      if (group.code == 0 && group.value == "ENDSEC") section.clear();
      ended = group.code == 0 && group.value == "EOF";
      entity_.groups[group.code] = group;
    }
    if (!ended)
      refuse(path_, "ends at line " + std::to_string(number_) + " without EOF: it is cut");
    if (found_.triangles.empty() && found_.points.size() < 3)
      refuse(path_, "has neither 3DFACE, a polyface mesh nor three POINT in its section ENTITIES");
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::string where(size_t line) const {
    return path_ + ":" + std::to_string(line) + ": ";
  }

  bool next(Group& group) {
    std::string code;
    if (!std::getline(in_, code)) return false;
    ++number_;
    if (number_ == 1 && code.starts_with("AutoCAD Binary DXF"))
      refuse(path_, "is a binary DXF; save it as text");
    const std::string word = trimmed(code);
    if (number_ == 1 && word.find_first_not_of("0123456789") != std::string::npos)
      refuse(path_, "is no DXF: it must begin with a group code, got '" + word.substr(0, 40) + "'");
    group.code = static_cast<int>(parse_number(word, where(number_) + "group code"));
    std::string value;
    if (!std::getline(in_, value)) return false;
    ++number_;
    group.value = trimmed(value);
    group.line = number_;
    return true;
  }

  // The entity that was read last is whole.
  void close(const std::string& section) {
    if (section != "ENTITIES") return;
    if (entity_.kind == "3DFACE") add_face();
    if (entity_.kind == "POINT") found_.points.push_back(corner(entity_, 10));
    if (entity_.kind == "POLYLINE") vertices_.clear();
    if (entity_.kind == "VERTEX") add_vertex();
  }

  [[nodiscard]] double number(const Entity& entity, int code) const {
    const auto found = entity.groups.find(code);
    if (found == entity.groups.end())
      throw InputError(where(entity.line) + entity.kind + " has no group " + std::to_string(code));
    return parse_number(found->second.value,
                        where(found->second.line) + entity.kind + " group " + std::to_string(code));
  }

  [[nodiscard]] int whole(const Entity& entity, int code) const {
    return entity.groups.contains(code) ? static_cast<int>(std::lround(number(entity, code))) : 0;
  }

  [[nodiscard]] Vec3 corner(const Entity& entity, int code) const {
    return {number(entity, code), number(entity, code + 10), number(entity, code + 20)};
  }

  void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double kFlat = 1e-12;  // two corners in one place make no face
    const double edge = std::max((b - a).squaredNorm(), (c - a).squaredNorm());
    if ((b - a).cross(c - a).norm() > kFlat * edge) found_.triangles.push_back({a, b, c});
  }

  void add_corners(const std::vector<Vec3>& corners) {
    add_triangle(corners[0], corners[1], corners[2]);
    if (corners.size() > 3) add_triangle(corners[0], corners[2], corners[3]);
  }

  void add_face() {
    std::vector<Vec3> corners{corner(entity_, 10), corner(entity_, 11), corner(entity_, 12)};
    if (entity_.groups.contains(13)) corners.push_back(corner(entity_, 13));
    add_corners(corners);
  }

  // Of a polyface mesh: flag 128 alone is a face, 128 and 64 a corner.
  void add_vertex() {
    const int flags = whole(entity_, 70);
    constexpr int kPolyface = 128, kPlace = 64;
    if ((flags & kPolyface) == 0) return;
    if ((flags & kPlace) != 0) {
      vertices_.push_back(corner(entity_, 10));
      return;
    }
    std::vector<Vec3> corners;
    for (const int code : {71, 72, 73, 74}) {
      const int index = std::abs(whole(entity_, code));  // negative: an edge that is not shown
      if (index == 0) continue;
      if (index > static_cast<int>(vertices_.size()))
        throw InputError(where(entity_.line) + "the face names vertex " + std::to_string(index) +
                         " of " + std::to_string(vertices_.size()));
      corners.push_back(vertices_[static_cast<size_t>(index) - 1]);
    }
    if (corners.size() >= 3) add_corners(corners);
  }

  std::string path_;
  std::ifstream in_;
  size_t number_ = 0;  // of the line
  Entity entity_;
  std::vector<Vec3> vertices_;  // of the present polyface mesh
  DxfSurface found_;
};

}  // namespace

DxfSurface read_dxf(const std::filesystem::path& path) { return DxfReader(path).surface(); }

}  // namespace muckpile
