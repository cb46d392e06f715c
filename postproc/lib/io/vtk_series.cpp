// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks of every snapshot as posed polyhedra for ParaView.
// Scope: the cells are built once; each snapshot moves the points and replaces the cell data.
#include "io/vtk_series.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <fstream>

#include "args/input_error.h"
#include "io/muck.h"

namespace muckpile {
namespace {

void add_cells(const std::vector<StartBlock>& blocks, vtkUnstructuredGrid& grid) {
  grid.AllocateEstimate(static_cast<vtkIdType>(blocks.size()), 16);
  vtkIdType first = 0;
  for (const StartBlock& block : blocks) {
    std::vector<vtkIdType> faces;
    for (const std::span<const int> face : block.shape.faces) {
      faces.push_back(static_cast<vtkIdType>(face.size()));
      for (const int v : face) faces.push_back(first + v);
    }
    grid.InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(block.shape.faces.size()),
                        faces.data());
    first += static_cast<vtkIdType>(block.shape.vertices.size());
  }
}

template <class Array, class Value>
void set_scalar(vtkUnstructuredGrid& grid, const char* name, size_t count, Value&& value) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  using Number = typename Array::ValueType;
  for (size_t i = 0; i < count; ++i)
    array->SetValue(static_cast<vtkIdType>(i), static_cast<Number>(value(i)));
  grid.GetCellData()->AddArray(array);
}

template <class Value>
void set_vector(vtkUnstructuredGrid& grid, const char* name, size_t count, Value&& value) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  for (size_t i = 0; i < count; ++i) {
    const Vec3 v = value(i);
    array->SetTuple3(static_cast<vtkIdType>(i), v.x(), v.y(), v.z());
  }
  grid.GetCellData()->AddArray(array);
}

void set_state(const std::vector<StartBlock>& blocks, const Snapshot& snapshot,
               vtkUnstructuredGrid& grid) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  const auto& states = snapshot.states;
  const size_t n = blocks.size();
  for (size_t b = 0; b < n; ++b) {
    for (const Vec3& p : moved_vertices(blocks[b], states[b])) points->InsertNextPoint(p.data());
  }
  grid.SetPoints(points);
  grid.GetCellData()->Initialize();
  set_scalar<vtkIntArray>(grid, "id", n, [&](size_t b) { return blocks[b].id; });
  set_scalar<vtkIntArray>(grid, "fragment_id", n, [&](size_t b) { return states[b].fragment; });
  set_scalar<vtkFloatArray>(grid, "size_m", n, [&](size_t b) { return blocks[b].size; });
  set_scalar<vtkFloatArray>(grid, "mass_kg", n, [&](size_t b) { return blocks[b].mass; });
  set_scalar<vtkFloatArray>(grid, "broken_fraction", n,
                            [&](size_t b) { return states[b].broken_fraction; });
  if (rock_blocks(blocks) < n)
    set_scalar<vtkIntArray>(grid, "muck", n, [&](size_t b) { return is_muck(blocks[b]) ? 1 : 0; });
  set_vector(grid, "velocity_m_s", n, [&](size_t b) { return states[b].velocity; });
  set_vector(grid, "spin_rad_s", n, [&](size_t b) { return states[b].spin; });
  set_vector(grid, "start_m", n, [&](size_t b) { return blocks[b].centroid; });
  set_vector(grid, "displacement_m", n,
             [&](size_t b) -> Vec3 { return states[b].centre - blocks[b].centroid; });
}

void write_grid(vtkUnstructuredGrid& grid, const std::filesystem::path& path) {
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(&grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetIdTypeToInt32();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);
  if (writer->Write() != 1) throw InputError(path.string() + ": cannot be written");
}

}  // namespace

int write_vtk_series(const ResultFolder& folder, int every) {
  const std::vector<StartBlock>& blocks = folder.blocks();
  const std::filesystem::path target = folder.file("vtk");
  std::filesystem::create_directories(target);
  vtkNew<vtkUnstructuredGrid> grid;
  add_cells(blocks, *grid);
  std::ofstream list(target / "blocks.pvd");
  list << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
          "byte_order=\"LittleEndian\">\n<Collection>\n";
  const std::vector<std::filesystem::path> snapshots = folder.snapshots();
  int written = 0;
  for (size_t k = 0; k < snapshots.size(); ++k) {
    if (k % static_cast<size_t>(every) != 0 && k + 1 != snapshots.size()) continue;
    const Snapshot snapshot = read_snapshot(snapshots[k], blocks);
    const std::string name = snapshots[k].stem().string() + ".vtu";
    set_state(blocks, snapshot, *grid);
    write_grid(*grid, target / name);
    list << "<DataSet timestep=\"" << snapshot.time << "\" part=\"0\" file=\"" << name << "\"/>\n";
    ++written;
  }
  list << "</Collection>\n</VTKFile>\n";
  if (!list.flush()) throw InputError((target / "blocks.pvd").string() + ": cannot be written");
  return written;
}

}  // namespace muckpile
