// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks in their start configuration, from a run's dump/blocks.vtk.
// Scope: VTK parses the file; this turns cells into polyhedra and checks them.
#include "io/blocks_file.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "args/input_error.h"

namespace muckpile {
namespace {

void keep_message(vtkObject*, unsigned long, void* client, void* text) {
  *static_cast<std::string*>(client) = static_cast<const char*>(text);
}

void read_grid(vtkUnstructuredGridReader& reader, const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(path.string() + ": is not a file");
  std::string message;
  vtkNew<vtkCallbackCommand> on_error;
  on_error->SetCallback(keep_message);
  on_error->SetClientData(&message);
  reader.AddObserver(vtkCommand::ErrorEvent, on_error);
  reader.SetFileName(path.c_str());
  reader.ReadAllScalarsOn();
  reader.Update();
  if (!message.empty()) throw InputError(path.string() + ": VTK cannot read it: " + message);
  if (reader.GetOutput()->GetNumberOfCells() == 0)
    throw InputError(path.string() + ": holds no cells");
}

vtkDataArray& cell_array(vtkUnstructuredGrid& grid, const char* name, const std::string& file) {
  vtkDataArray* array = grid.GetCellData()->GetArray(name);
  if (array == nullptr) throw InputError(file + ": has no cell data '" + std::string(name) + "'");
  return *array;
}

// The face stream of VTK is: faces, then per face its vertex count and its vertices' numbers in the
// grid.
Polyhedron polyhedron_of_cell(vtkUnstructuredGrid& grid, vtkIdType cell) {
  vtkNew<vtkIdList> stream;
  grid.GetFaceStream(cell, stream);
  Polyhedron shape;
  std::unordered_map<vtkIdType, int> local;
  vtkIdType at = 0;
  const vtkIdType faces = stream->GetId(at++);
  for (vtkIdType f = 0; f < faces; ++f) {
    std::vector<int> face(static_cast<size_t>(stream->GetId(at++)));
    for (int& vertex : face) {
      const vtkIdType point = stream->GetId(at++);
      const auto [found, is_new] =
          local.try_emplace(point, static_cast<int>(shape.vertices.size()));
      if (is_new) shape.vertices.emplace_back(Vec3::Map(grid.GetPoint(point)));
      vertex = found->second;
    }
    shape.faces.push_back(std::move(face));
  }
  return shape;
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
  if (!(block.mass > 0.0)) {
    throw InputError(file + ": block " + std::to_string(block.id) +
                     ": mass_kg must be > 0 kg, got '" + std::to_string(block.mass) + "'");
  }
}

}  // namespace

std::vector<StartBlock> read_blocks(const std::filesystem::path& path) {
  vtkNew<vtkUnstructuredGridReader> reader;
  read_grid(*reader, path);
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  const std::string file = path.string();
  vtkDataArray& id = cell_array(grid, "id", file);
  vtkDataArray& volume = cell_array(grid, "volume_m3", file);
  vtkDataArray& size = cell_array(grid, "size_m", file);
  vtkDataArray& mass = cell_array(grid, "mass_kg", file);
  vtkDataArray& free_face = cell_array(grid, "on_free_face", file);

  std::vector<StartBlock> blocks;
  blocks.reserve(static_cast<size_t>(grid.GetNumberOfCells()));
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
    const int number = static_cast<int>(id.GetComponent(c, 0));
    if (grid.GetCellType(c) != VTK_POLYHEDRON) {
      throw InputError(file + ": block " + std::to_string(number) +
                       " must be a polyhedron (VTK type 42), got '" +
                       std::to_string(grid.GetCellType(c)) + "'");
    }
    StartBlock block{number,
                     polyhedron_of_cell(grid, c),
                     Vec3::Zero(),
                     volume.GetComponent(c, 0),
                     size.GetComponent(c, 0),
                     mass.GetComponent(c, 0),
                     free_face.GetComponent(c, 0) != 0.0};
    const MassProperties exact = mass_properties(block.shape);
    block.centroid = exact.centroid;
    check(block, exact.volume, file);
    blocks.push_back(std::move(block));
  }
  std::ranges::sort(blocks, {}, &StartBlock::id);
  const auto twin = std::ranges::adjacent_find(blocks, {}, &StartBlock::id);
  if (twin != blocks.end())
    throw InputError(file + ": id " + std::to_string(twin->id) + " occurs twice");
  return blocks;
}

}  // namespace muckpile
