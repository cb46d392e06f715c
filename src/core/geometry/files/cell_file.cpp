// SPDX-License-Identifier: GPL-2.0-or-later
// Cells of a legacy VTK file.
// Scope: see the header.
#include "geometry/files/cell_file.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "args/text_words.h"
#include "geometry/files/import_fault.h"

namespace muckpile {
namespace {

constexpr int kMostFaces = 65535;  // what the numbers of joints' faces hold

using FaceList = std::vector<std::vector<int>>;

/// Faces of the cells that VTK describes by their corners alone (VTK file formats, cell types).
const std::map<int, FaceList>& fixed_cells() {
  static const std::map<int, FaceList> faces{
      {10, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}},  // tetrahedron
      {12, {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}},
      {13, {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},  // wedge
      {14, {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},        // pyramid
  };
  return faces;
}
constexpr int kPolyhedron = 42;

/// Words of a file in order, with what was expected when they are not there.
class Words {
 public:
  Words(TextWords& text, const std::string& name) : text_(text), name_(name) {}
  template <class Number>
  Number next(const char* what) {
    Number value{};
    if (!text_.number(value)) refuse(what);
    return value;
  }
  std::size_t count(const char* what) {
    constexpr long kMost = 1000000000;
    const long value = next<long>(what);
    if (value < 0 || value > kMost)
      fail_file(place(), what, " must be >= 0 and <= ", kMost, ", got '", value, "'");
    return static_cast<std::size_t>(value);
  }
  void expect(const std::string& word) {
    const std::string got(text_.word());
    if (got.empty()) refuse("'" + word + "'");
    if (got != word) fail_file(place(), "'", word, "' expected, got '", got, "'");
  }
  void skip(const char* what) {
    if (text_.word().empty()) refuse(what);
  }

 private:
  [[nodiscard]] std::string place() const {
    return "'" + name_ + "', line " + std::to_string(text_.line_number()) + ": ";
  }
  [[noreturn]] void refuse(const std::string& what) const {
    fail_file(place(), what, " expected",
              text_.at_end() ? "; the file ends there, as if it had been cut short" : "");
  }

  TextWords& text_;
  const std::string& name_;
};

void read_header(TextWords& text, const std::string& name) {
  const std::string first(text.line());
  (void)text.line();  // the title
  constexpr const char* kStart = "# vtk DataFile Version ";
  if (first.rfind(kStart, 0) != 0) fail_file("'", name, "' is no legacy VTK file");
  if (first.substr(std::string(kStart).size(), 1) > "4")
    fail_file("'", name, "' has file version 5; write it as version 4.2 or earlier");
}

std::vector<Vec3> read_points(Words& words) {
  words.expect("POINTS");
  std::vector<Vec3> points;  // grows as they come: a count says nothing about the file's length
  std::size_t left = words.count("number of points");
  words.skip("type of the points");
  for (; left > 0; --left) {
    Vec3& p = points.emplace_back();
    for (int c = 0; c < 3; ++c) p[c] = words.next<double>("a coordinate");
  }
  return points;
}

/// The CELLS lines.
void read_lists(Words& words, CellTable& table) {
  words.expect("CELLS");
  std::size_t left = words.count("number of cells");
  (void)words.count("number of words of all cells");
  for (; left > 0; --left) {
    std::size_t numbers = words.count("number of words of a cell");
    table.words.push_back(static_cast<int>(numbers));
    table.begin.push_back(table.words.size());
    for (; numbers > 0; --numbers) table.words.push_back(words.next<int>("a number of a cell"));
  }
}

FaceList faces_of(std::span<const int> list, int type, std::size_t cell) {
  FaceList faces;
  if (type == kPolyhedron) {
    if (!list.empty() && list[0] > kMostFaces)
      fail_import("cell ", cell, " must have at most ", kMostFaces, " faces, got '", list[0], "'");
    if (!list.empty()) faces.reserve(std::min(list.size(), static_cast<std::size_t>(list[0])));
    std::size_t at = 1;
    for (int f = 0; !list.empty() && f < list[0]; ++f) {
      const std::size_t count = at < list.size() ? static_cast<std::size_t>(list[at]) : 0;
      if (count < 3 || count >= list.size() - at)
        fail_import("the faces of cell ", cell, " are cut short");
      const auto from = list.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      faces.emplace_back(from, from + static_cast<std::ptrdiff_t>(count));
      at += count + 1;
    }
    return faces;
  }
  const auto known = fixed_cells().find(type);
  if (known == fixed_cells().end())
    fail_import("cell ", cell,
                " must be a polyhedron, tetrahedron, hexahedron, wedge or pyramid, got type '",
                type, "'");
  for (const std::vector<int>& corners : known->second) {
    faces.emplace_back();
    for (const int corner : corners) {
      if (static_cast<std::size_t>(corner) >= list.size())
        fail_import("cell ", cell, " has too few corners");
      faces.back().push_back(list[static_cast<std::size_t>(corner)]);
    }
  }
  return faces;
}

/// The points that faces use, in the order of the file, and the place of each among them.
class UsedPoints {
 public:
  explicit UsedPoints(const FaceList& faces) {
    for (const auto& face : faces) used_.insert(used_.end(), face.begin(), face.end());
    if (used_.empty()) return;
    const auto [low, high] = std::minmax_element(used_.begin(), used_.end());
    first_ = *low;
    const long long range = static_cast<long long>(*high) - *low + 1;
    // Cells that share no points, as ours, have them one behind the other: they need no sorting.
    if (range > kSparse * static_cast<long long>(used_.size())) {
      std::sort(used_.begin(), used_.end());
      used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
      return;
    }
    place_.assign(static_cast<std::size_t>(range), -1);
    for (const int v : used_) place_[static_cast<std::size_t>(v - first_)] = 0;
    used_.clear();
    for (std::size_t k = 0; k < place_.size(); ++k) {
      if (place_[k] < 0) continue;
      place_[k] = static_cast<int>(used_.size());
      used_.push_back(first_ + static_cast<int>(k));
    }
  }
  [[nodiscard]] const std::vector<int>& list() const { return used_; }
  [[nodiscard]] int place_of(int point) const {
    if (!place_.empty()) return place_[static_cast<std::size_t>(point - first_)];
    return static_cast<int>(std::lower_bound(used_.begin(), used_.end(), point) - used_.begin());
  }

 private:
  static constexpr long long kSparse = 16;
  std::vector<int> used_, place_;
  int first_ = 0;
};

/// With its own vertices, in the order of the file; faces turned so that the cell is behind them.
Polyhedron turned_cell(FaceList faces, const std::vector<Vec3>& points, std::size_t cell) {
  const UsedPoints places(faces);
  const std::vector<int>& used = places.list();
  if (used.empty() || used.front() < 0 || used.back() >= static_cast<int>(points.size()))
    fail_import("cell ", cell, " has a point that is not in the file");
  Polyhedron shape;
  shape.vertices.reserve(used.size());
  for (const int v : used) shape.vertices.push_back(points[static_cast<std::size_t>(v)]);
  for (std::vector<int>& corners : faces) {
    for (int& v : corners) v = places.place_of(v);
    if (faces_inwards(shape.vertices, corners)) std::reverse(corners.begin(), corners.end());
  }
  shape.faces = std::move(faces);
  return shape;
}

}  // namespace

bool faces_inwards(std::span<const Vec3> vertices, std::span<const int> face) {
  const auto at = [&](std::size_t k) -> const Vec3& {
    return vertices[static_cast<std::size_t>(face[k])];
  };
  Vec3 mean = Vec3::Zero(), normal = Vec3::Zero();
  for (std::size_t k = 0; k < face.size(); ++k) mean += at(k);
  mean /= static_cast<double>(face.size());
  for (std::size_t k = 0; k < face.size(); ++k)
    normal += (at(k) - mean).cross(at(k + 1 == face.size() ? 0 : k + 1) - mean);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Vec3& v : vertices) {
    lowest = std::min(lowest, normal.dot(v));
    highest = std::max(highest, normal.dot(v));
  }
  return lowest + highest > 2.0 * normal.dot(mean);
}

bool CellTable::find_cells(std::size_t cells) {
  begin.clear();
  std::size_t at = 0;
  for (; cells > 0; --cells) {
    if (at >= words.size() || words[at] < 0) return false;
    begin.push_back(at + 1);
    at += static_cast<std::size_t>(words[at]) + 1;
  }
  return at == words.size();
}

CellTable read_cell_table(TextWords& text, const std::string& name) {
  read_header(text, name);
  Words words(text, name);
  words.expect("ASCII");
  words.expect("DATASET");
  words.expect("UNSTRUCTURED_GRID");
  CellTable table;
  table.points = read_points(words);
  read_lists(words, table);
  words.expect("CELL_TYPES");
  if (words.count("number of cell types") != table.cells())
    fail_file("'", name, "': there must be as many cell types as cells");
  for (std::size_t c = 0; c < table.cells(); ++c)
    table.types.push_back(words.next<int>("a cell type"));
  if (table.types.empty()) fail_file("'", name, "' holds no cell");
  return table;
}

Polyhedron cell_of(const CellTable& table, std::size_t number) {
  const std::size_t begin = table.begin[number];
  const std::span<const int> list(table.words.data() + begin,
                                  static_cast<std::size_t>(table.words[begin - 1]));
  return cell_of(list, table.types[number], table.points, number);
}

Polyhedron cell_of(std::span<const int> words, int type, const std::vector<Vec3>& points,
                   std::size_t number) {
  return turned_cell(faces_of(words, type, number + 1), points, number + 1);
}

Polyhedron cell_of(const CellTable& table, std::size_t number, const std::string& name) {
  try {
    return cell_of(table, number);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

std::vector<Polyhedron> read_cells(TextWords& text, const std::string& name) {
  const CellTable table = read_cell_table(text, name);
  std::vector<Polyhedron> cells;
  for (std::size_t c = 0; c < table.cells(); ++c) cells.push_back(cell_of(table, c));
  return cells;
}

}  // namespace muckpile
