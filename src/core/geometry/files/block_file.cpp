// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks as a legacy VTK file.
// Scope: see the header.
#include "geometry/files/block_file.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "args/input_error.h"

namespace muckpile {
namespace {

constexpr int kVtkPolyhedron = 42;

void write_cells(std::ofstream& out, const std::vector<Block>& blocks) {
  std::size_t words = 0;
  for (const Block& block : blocks) {
    words += 2;  // the count of words and the count of faces
    for (const auto& face : block.shape.faces) words += 1 + face.size();
  }
  out << "CELLS " << blocks.size() << ' ' << words << '\n';
  std::size_t first = 0;
  for (const Block& block : blocks) {
    std::size_t length = 1;
    for (const auto& face : block.shape.faces) length += 1 + face.size();
    out << length << ' ' << block.shape.faces.size();
    for (const auto& face : block.shape.faces) {
      out << ' ' << face.size();
      for (int v : face) out << ' ' << first + static_cast<std::size_t>(v);
    }
    out << '\n';
    first += block.shape.vertices.size();
  }
  out << "CELL_TYPES " << blocks.size() << '\n';
  for (std::size_t b = 0; b < blocks.size(); ++b) out << kVtkPolyhedron << '\n';
}

template <typename Value>
void write_scalars(std::ofstream& out, const char* name, const char* type, std::size_t count,
                   Value value) {
  out << "SCALARS " << name << ' ' << type << " 1\nLOOKUP_TABLE default\n";
  for (std::size_t b = 0; b < count; ++b) out << value(b) << '\n';
}

}  // namespace

void write_blocks(const std::string& path, const std::vector<Block>& blocks, int first_id,
                  double density, const std::string& run_id) {
  write_blocks(path, blocks, first_id, std::span<const double>(&density, 1), {}, run_id);
}

void write_blocks(const std::string& path, const std::vector<Block>& blocks, int first_id,
                  std::span<const double> density, std::span<const std::uint8_t> zones,
                  const std::string& run_id, std::span<const double> muck) {
  std::error_code ignored;
  const auto folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  std::ofstream out(path);
  out.precision(17);
  std::size_t points = 0;
  for (const Block& block : blocks) points += block.shape.vertices.size();
  out << "# vtk DataFile Version 3.0\nMuckpile blocks, start configuration"
      << (run_id.empty() ? "" : " run=" + run_id) << "\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  out << "POINTS " << points << " double\n";
  for (const Block& block : blocks) {
    for (const Vec3& p : block.shape.vertices) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  write_cells(out, blocks);
  out << "CELL_DATA " << blocks.size() << '\n';
  const auto volume = [&](std::size_t b) { return blocks[b].mass.volume; };
  const std::size_t rock = blocks.size() - muck.size();
  write_scalars(out, "id", "int", blocks.size(),
                [&](std::size_t b) { return first_id + static_cast<int>(b); });
  write_scalars(out, "volume_m3", "double", blocks.size(), volume);
  write_scalars(out, "size_m", "double", blocks.size(),
                [&](std::size_t b) { return std::cbrt(volume(b)); });
  write_scalars(out, "mass_kg", "double", blocks.size(), [&](std::size_t b) {
    if (b >= rock) return muck[b - rock];
    return density[zones.empty() ? 0 : zones[b]] * volume(b);
  });
  write_scalars(out, "on_free_face", "int", blocks.size(), [&](std::size_t b) {
    const auto& n = blocks[b].neighbour;
    return b < rock && std::count(n.begin(), n.end(), kFreeFace) > 0 ? 1 : 0;
  });
  if (!zones.empty())
    write_scalars(out, "zone", "int", blocks.size(),
                  [&](std::size_t b) { return b < rock ? int{zones[b]} : 0; });
  if (!muck.empty())
    write_scalars(out, "muck", "int", blocks.size(),
                  [&](std::size_t b) { return b < rock ? 0 : 1; });
  if (!out.flush()) throw InputError("cannot write '" + path + "': " + std::strerror(errno));
}

}  // namespace muckpile
