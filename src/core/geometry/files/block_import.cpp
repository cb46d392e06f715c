// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks from a VTK file.
// Scope: see the header.
#include "geometry/files/block_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "args/input_error.h"
#include "geometry/cut/ground.h"
#include "geometry/cut/shared_faces.h"
#include "geometry/holes/hole_surface.h"
#include "geometry/index/axis_index.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {
namespace {

constexpr int kMostFaces = 65535;  // what the numbers of joints' faces hold
constexpr double kShape = 1e-6;    // of the cell's size: plane, convex and closed to this

template <class... Words>
[[noreturn]] void fail(const Words&... words) {
  std::ostringstream text;
  text << "block import: ";
  (text << ... << words);
  throw InputError(text.str());
}

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
  Words(std::istream& in, const std::string& name) : in_(in), name_(name) {}
  template <class Value>
  Value next(const std::string& what) {
    Value value{};
    if (!(in_ >> value)) fail("'", name_, "': ", what, " expected");
    return value;
  }
  std::size_t count(const std::string& what) {
    constexpr long kMost = 1000000000;
    const long value = next<long>(what);
    if (value < 0 || value > kMost)
      fail("'", name_, "': ", what, " must be >= 0 and <= ", kMost, ", got '", value, "'");
    return static_cast<std::size_t>(value);
  }
  void expect(const std::string& word) {
    const auto got = next<std::string>("'" + word + "'");
    if (got != word) fail("'", name_, "': '", word, "' expected, got '", got, "'");
  }

 private:
  std::istream& in_;
  const std::string& name_;
};

void read_header(std::istream& in, const std::string& name) {
  std::string first, title;
  std::getline(in, first);
  std::getline(in, title);
  constexpr const char* kStart = "# vtk DataFile Version ";
  if (first.rfind(kStart, 0) != 0) fail("'", name, "' is no legacy VTK file");
  if (first.substr(std::string(kStart).size(), 1) > "4")
    fail("'", name, "' has file version 5; write it as version 4.2 or earlier");
}

std::vector<Vec3> read_points(Words& words) {
  words.expect("POINTS");
  std::vector<Vec3> points;  // grows as they come: a count says nothing about the file's length
  std::size_t left = words.count("number of points");
  (void)words.next<std::string>("type of the points");
  for (; left > 0; --left) {
    Vec3& p = points.emplace_back();
    for (int c = 0; c < 3; ++c) p[c] = words.next<double>("a coordinate");
  }
  return points;
}

/// The numbers of a CELLS line, the count before them left out.
std::vector<std::vector<int>> read_lists(Words& words) {
  words.expect("CELLS");
  std::vector<std::vector<int>> lists;
  std::size_t left = words.count("number of cells");
  (void)words.count("number of words of all cells");
  for (; left > 0; --left) {
    std::vector<int>& list = lists.emplace_back();
    for (std::size_t numbers = words.count("number of words of a cell"); numbers > 0; --numbers)
      list.push_back(words.next<int>("a number of a cell"));
  }
  return lists;
}

FaceList faces_of(const std::vector<int>& list, int type, std::size_t cell) {
  FaceList faces;
  if (type == kPolyhedron) {
    if (!list.empty() && list[0] > kMostFaces)
      fail("cell ", cell, " must have at most ", kMostFaces, " faces, got '", list[0], "'");
    std::size_t at = 1;
    for (int f = 0; !list.empty() && f < list[0]; ++f) {
      const std::size_t count = at < list.size() ? static_cast<std::size_t>(list[at]) : 0;
      if (count < 3 || count >= list.size() - at)
        fail("the faces of cell ", cell, " are cut short");
      const auto from = list.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      faces.emplace_back(from, from + static_cast<std::ptrdiff_t>(count));
      at += count + 1;
    }
    return faces;
  }
  const auto known = fixed_cells().find(type);
  if (known == fixed_cells().end())
    fail("cell ", cell,
         " must be a polyhedron, tetrahedron, hexahedron, wedge or pyramid, got type '", type, "'");
  for (const std::vector<int>& corners : known->second) {
    faces.emplace_back();
    for (const int corner : corners) {
      if (static_cast<std::size_t>(corner) >= list.size())
        fail("cell ", cell, " has too few corners");
      faces.back().push_back(list[static_cast<std::size_t>(corner)]);
    }
  }
  return faces;
}

/// With its own vertices, in the order of the file; faces turned so that the cell is behind them.
Polyhedron cell_of(const FaceList& faces, const std::vector<Vec3>& points, std::size_t cell) {
  std::set<int> used;
  for (const auto& face : faces) used.insert(face.begin(), face.end());
  if (used.empty() || *used.begin() < 0 || *used.rbegin() >= static_cast<int>(points.size()))
    fail("cell ", cell, " has a point that is not in the file");
  Polyhedron shape;
  std::map<int, int> number;
  for (const int v : used) {
    number[v] = static_cast<int>(shape.vertices.size());
    shape.vertices.push_back(points[static_cast<std::size_t>(v)]);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    shape.faces.emplace_back();
    for (const int v : faces[f]) shape.faces.back().push_back(number[v]);
    const FaceGeometry face = face_geometry(shape, static_cast<int>(f));
    const auto [lowest, highest] = extent(shape, face.normal);
    if (lowest + highest > 2.0 * face.normal.dot(face.centroid))
      std::reverse(shape.faces.back().begin(), shape.faces.back().end());
  }
  return shape;
}

Block checked_block(Polyhedron shape, std::size_t cell) {
  Block block;
  block.shape = std::move(shape);
  block.mass = mass_properties(block.shape);
  if (!(block.mass.volume > 0.0)) fail("cell ", cell, " must be closed and have a volume > 0 m3");
  const double size = std::cbrt(block.mass.volume);
  for (std::size_t f = 0; f < block.shape.faces.size(); ++f) {
    const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
    if (face.area < kShape * size * size) continue;  // no direction to speak of
    for (const int v : block.shape.faces[f]) {
      const Vec3& at = block.shape.vertices[static_cast<std::size_t>(v)];
      if (std::abs(face.normal.dot(at - face.centroid)) > kShape * size)
        fail("face ", f + 1, " of cell ", cell, " is not plane");
    }
    if (extent(block.shape, face.normal).second - face.normal.dot(face.centroid) > kShape * size)
      fail("cell ", cell, " is not convex at its face ", f + 1);
  }
  if (area_vector_sum(block.shape).norm() > kShape * size * size)
    fail("cell ", cell, " is not closed");
  block.neighbour.assign(block.shape.faces.size(), kFreeFace);
  return block;
}

/// Pairs of blocks whose bounding boxes touch, first number smaller.
std::vector<std::pair<std::size_t, std::size_t>> touching(const std::vector<Block>& blocks) {
  struct Bounds {
    std::size_t block;
    Vec3 lo, hi;
  };
  std::vector<Bounds> bounds;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Bounds box{b, Vec3::Constant(1e300), Vec3::Constant(-1e300)};
    for (const Vec3& v : blocks[b].shape.vertices) {
      box.lo = box.lo.cwiseMin(v);
      box.hi = box.hi.cwiseMax(v);
    }
    const double around = kShape * std::cbrt(blocks[b].mass.volume);
    box.lo.array() -= around;
    box.hi.array() += around;
    bounds.push_back(box);
  }
  std::sort(bounds.begin(), bounds.end(),
            [](const Bounds& a, const Bounds& b) { return a.lo.x() < b.lo.x(); });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    for (std::size_t j = i + 1; j < bounds.size() && bounds[j].lo.x() < bounds[i].hi.x(); ++j) {
      if ((bounds[i].lo.array() > bounds[j].hi.array()).any() ||
          (bounds[j].lo.array() > bounds[i].hi.array()).any())
        continue;
      pairs.push_back(std::minmax(bounds[i].block, bounds[j].block));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

using Faces = std::vector<FaceGeometry>;

/// Volume that two convex blocks share [m3].
double shared_volume(const Block& a, const Block& b, const Faces& faces_of_b) {
  ConvexCell rest{a.shape, std::vector<int>(a.shape.faces.size(), -1)};
  const double size = std::cbrt(b.mass.volume);
  for (const FaceGeometry& face : faces_of_b) {
    if (face.area < kShape * size * size) continue;
    const auto [lowest, highest] = extent(rest.shape, face.normal);
    const double plane = face.normal.dot(face.centroid);
    if (lowest > plane - kShape * size) return 0.0;
    if (highest <= plane) continue;
    if (auto halves = divided(rest, face.centroid, face.normal, -1))
      rest = std::move(halves->below);
  }
  return volume_of(rest);
}

void refuse_overlap(const std::vector<Block>& blocks, const std::vector<Faces>& faces,
                    std::size_t a, std::size_t b) {
  constexpr double kLargest = 1e-6;  // of the smaller block
  const double shared = shared_volume(blocks[a], blocks[b], faces[b]);
  if (shared > kLargest * std::min(blocks[a].mass.volume, blocks[b].mass.volume))
    fail("cells ", a + 1, " and ", b + 1, " overlap by ", shared, " m3");
}

/// Whether all corners of a face are in the plane of another.
bool lies_in(const Block& block, std::size_t face, const FaceGeometry& plane, double size) {
  const auto& corners = block.shape.faces[face];
  return std::all_of(corners.begin(), corners.end(), [&](int v) {
    const Vec3& at = block.shape.vertices[static_cast<std::size_t>(v)];
    return std::abs(plane.normal.dot(at - plane.centroid)) < kShape * size;
  });
}

void join(const std::vector<Block>& blocks, const std::vector<Faces>& faces, std::size_t a,
          std::size_t b, Pieces& pieces) {
  const double size = std::cbrt(std::min(blocks[a].mass.volume, blocks[b].mass.volume));
  constexpr double kOpposite = -0.9;  // cosine; what is in one plane decides, this is the side
  for (std::size_t f = 0; f < blocks[a].shape.faces.size(); ++f) {
    const FaceGeometry& mine = faces[a][f];
    for (std::size_t g = 0; g < blocks[b].shape.faces.size(); ++g) {
      const FaceGeometry& theirs = faces[b][g];
      if (mine.normal.dot(theirs.normal) > kOpposite) continue;
      const bool mine_larger = mine.area > theirs.area;
      if (mine_larger ? !lies_in(blocks[b], g, mine, size) : !lies_in(blocks[a], f, theirs, size))
        continue;
      const PlaneFrame frame(mine.centroid, mine.normal);
      std::vector<PlaneFace> below{plane_face(frame, blocks, a, f, 1.0)},
          above{plane_face(frame, blocks, b, g, -1.0)};
      share_faces(frame, below, above, pieces);
    }
  }
}

/// Gives the faces that look into a void of the region, not out of it, to the nearest hole.
void find_hole_faces(const TessellationOptions& rock, const Ground& ground, Block& block) {
  constexpr double kLook = 1e-3;  // ahead, of the block's size
  constexpr double kFar = 4.0;    // [radii]; a void farther from all axes is none of a charge
  for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
    if (block.neighbour[f] != kFreeFace) continue;
    const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
    if (!ground.in_region(face.centroid + kLook * std::cbrt(block.mass.volume) * face.normal))
      continue;
    double nearest = kFar;
    for (std::size_t h = 0; h < rock.holes.size(); ++h) {
      const Hole& hole = rock.holes[h];
      const double away = Axis(hole.toe, hole.collar).distance(face.centroid) / hole.radius;
      if (away < nearest) block.neighbour[f] = hole_face(static_cast<int>(h));
      nearest = std::min(nearest, away);
    }
  }
}

}  // namespace

std::vector<Polyhedron> read_cells(std::istream& in, const std::string& name) {
  read_header(in, name);
  Words words(in, name);
  words.expect("ASCII");
  words.expect("DATASET");
  words.expect("UNSTRUCTURED_GRID");
  const std::vector<Vec3> points = read_points(words);
  const std::vector<std::vector<int>> lists = read_lists(words);
  words.expect("CELL_TYPES");
  if (words.count("number of cell types") != lists.size())
    fail("'", name, "': there must be as many cell types as cells");
  std::vector<Polyhedron> cells;
  for (std::size_t c = 0; c < lists.size(); ++c)
    cells.push_back(
        cell_of(faces_of(lists[c], words.next<int>("a cell type"), c + 1), points, c + 1));
  if (cells.empty()) fail("'", name, "' holds no cell");
  return cells;
}

std::vector<Block> joined_blocks(std::vector<Polyhedron> cells) {
  std::vector<Block> blocks;
  for (std::size_t c = 0; c < cells.size(); ++c)
    blocks.push_back(checked_block(std::move(cells[c]), c + 1));
  std::vector<Faces> faces;
  for (const Block& block : blocks) {
    faces.emplace_back();
    for (std::size_t f = 0; f < block.shape.faces.size(); ++f)
      faces.back().push_back(face_geometry(block.shape, static_cast<int>(f)));
  }
  Pieces pieces;
  for (const auto& [a, b] : touching(blocks)) {
    refuse_overlap(blocks, faces, a, b);
    join(blocks, faces, a, b, pieces);
  }
  divide_faces(pieces, blocks);
  return blocks;
}

Tessellation import_blocks(const std::string& path, const TessellationOptions& rock) {
  std::ifstream in(path);
  if (!in) fail("cannot read '", path, "'");
  Tessellation result;
  std::vector<Polyhedron> cells = read_cells(in, path);
  if (cells.size() > rock.max_blocks)
    fail("'", path, "' holds ", cells.size(), " cells, more than max_blocks ", rock.max_blocks);
  result.blocks = joined_blocks(std::move(cells));
  const Ground ground(rock);
  for (std::size_t b = 0; b < result.blocks.size(); ++b) {
    Block& block = result.blocks[b];
    const Vec3& at = block.mass.centroid;
    if (!ground.in_region(at)) {
      fail("cell ", b + 1, " must lie in the region, got its centroid at '", at.x(), ' ', at.y(),
           ' ', at.z(), "'");
    }
    block.target_size = std::cbrt(block.mass.volume);
    const SizeLimits& limits = rock.size.limits();
    if (block.target_size < limits.smallest || block.target_size > limits.largest) {
      fail("the size V^(1/3) of cell ", b + 1, " must be >= ", limits.smallest,
           " and <= ", limits.largest, " m, got '", block.target_size, "'");
    }
    find_hole_faces(rock, ground, block);
  }
  for (const Hole& hole : rock.holes)
    result.statistics.cylinder_volume.push_back(cylinder_volume(hole));
  add_statistics(rock, result);
  return result;
}

}  // namespace muckpile
