// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks in their start configuration, from a run's dump/blocks.vtk.
// Scope: strict, as files may be cut short or damaged: VTK's own reader believes every number of a
// cell.
#include "io/blocks_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "args/input_error.h"
#include "args/text_words.h"
#include "geometry/files/cell_data.h"
#include "geometry/files/cell_file.h"
#include "geometry/shape/centroid.h"
#include "io/file_text.h"
#include "io/muck.h"
#include "io/plain_cells.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

struct FileCells {
  std::vector<BlockShape> shapes;
  CellData data;
};

FileCells read_any_file(const std::filesystem::path& path, const std::string& file) {
  std::string whole;
  read_text(path, whole);
  TextWords text{std::move(whole)};
  const CellTable cells = read_cell_table(text, file);
  CellData data = read_cell_data(text, cells.cells(), file);
  std::vector<BlockShape> shapes(cells.cells());
  each_in_parallel(shapes.size(), [&](size_t c) { shapes[c] = cell_of(cells, c, file); });
  return {std::move(shapes), std::move(data)};
}

FileCells read_file(const std::filesystem::path& path, const std::string& file) {
  FileWindow window(path);
  std::optional<std::vector<BlockShape>> plain = read_plain_cells(window);
  if (!plain) return read_any_file(path, file);
  std::string rest;
  read_text(path, rest, window.at());
  TextWords text{std::move(rest)};
  CellData data = read_cell_data(text, plain->size(), file);
  return {std::move(*plain), std::move(data)};
}

int whole_id(double value, const std::string& file) {
  if (!(value >= 1.0 && value <= std::numeric_limits<int>::max()) || value != std::floor(value))
    throw InputError(file + ": id must be a whole number >= 1, got '" + std::to_string(value) +
                     "'");
  return static_cast<int>(value);
}

int zone_number(double value, const std::string& file) {
  constexpr double kMost = 255.0;
  if (!(value >= 0.0 && value <= kMost) || value != std::floor(value))
    throw InputError(file + ": zone must be a whole number from 0 to 255, got '" +
                     std::to_string(value) + "'");
  return static_cast<int>(value);
}

// Text with six digits moves a vertex of a 0.1 m block at 50 m by 1e-4 m, which is 0.3 % of its
// volume; a wrong unit, face order or id shows as far more than this.
constexpr double kVolumeTolerance = 0.01;

void check(const StartBlock& block, double measured, const std::string& file) {
  if (!(std::abs(measured - block.volume) <= kVolumeTolerance * block.volume)) {
    throw InputError(file + ": block " + std::to_string(block.id) +
                     ": volume_m3 must be its polyhedron's " + std::to_string(measured) +
                     " m3, got '" + std::to_string(block.volume) + "'");
  }
  if (!(block.size > 0.0)) {
    throw InputError(file + ": block " + std::to_string(block.id) +
                     ": size_m must be > 0 m, got '" + std::to_string(block.size) + "'");
  }
  if (!(block.mass > 0.0)) {
    throw InputError(file + ": block " + std::to_string(block.id) +
                     ": mass_kg must be > 0 kg, got '" + std::to_string(block.mass) + "'");
  }
}

}  // namespace

std::vector<StartBlock> read_blocks(const std::filesystem::path& path) {
  const std::string file = path.string();
  auto [shapes, data] = read_file(path, file);
  const auto& id = cell_array(data, "id", file);
  const auto& volume = cell_array(data, "volume_m3", file);
  const auto& size = cell_array(data, "size_m", file);
  const auto& mass = cell_array(data, "mass_kg", file);
  const auto& free_face = cell_array(data, "on_free_face", file);

  const auto muck = data.find("muck");
  const auto zones = data.find("zone");
  std::vector<StartBlock> blocks(shapes.size());
  each_in_parallel(shapes.size(), [&](size_t c) {
    blocks[c] = {
        whole_id(id[c], file), std::move(shapes[c]), Vec3::Zero(), volume[c], size[c], mass[c],
        free_face[c] != 0.0};
    if (zones != data.end()) blocks[c].zone = zone_number(zones->second[c], file);
    const VolumeAndCentroid exact = volume_and_centroid(blocks[c].shape);
    blocks[c].centroid = exact.centroid;
    if (muck != data.end() && muck->second[c] != 0.0) blocks[c].image = kMuckImage;
    check(blocks[c], exact.volume, file);
  });
  if (!std::ranges::is_sorted(blocks, {}, &StartBlock::id))
    std::ranges::sort(blocks, {}, &StartBlock::id);
  const auto twin = std::ranges::adjacent_find(blocks, {}, &StartBlock::id);
  if (twin != blocks.end())
    throw InputError(file + ": id " + std::to_string(twin->id) + " occurs twice");
  if (!std::ranges::is_sorted(blocks, {}, is_muck))
    throw InputError(file + ": the ids of muck must be greater than those of rock");
  return blocks;
}

}  // namespace muckpile
