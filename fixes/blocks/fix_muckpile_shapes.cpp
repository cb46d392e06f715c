// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/shapes: shapes from rank 0 to all ranks, and through restart files.
// Scope: see the header.
#include "fixes/blocks/fix_muckpile_shapes.h"

#include <comm.h>

#include <algorithm>
#include <string>
#include <utility>

#include "fixes/engine/exchange.h"
#include "fixes/engine/restart_file.h"

namespace muckpile {

FixMuckpileShapes::FixMuckpileShapes(LAMMPS_NS::LAMMPS* engine_object, int narg, char** arg)
    : Fix(engine_object, narg, arg) {
  restart_global = 1;
}

void FixMuckpileShapes::share(const std::vector<BlockShape>& of_rank_0) {
  std::vector<ByteWriter> outgoing(static_cast<std::size_t>(comm->nprocs));
  if (comm->me == 0)
    for (ByteWriter& out : outgoing) out.put(ShapesState{of_rank_0});
  engine::or_engine_error(*lmp, "create_blocks", [&] {
    engine::exchange_messages(outgoing, world, [this](ByteReader& in, std::size_t) {
      while (!in.empty()) take(in.get<ShapesState>().shapes);
    });
  });
}

void FixMuckpileShapes::take(std::vector<BlockShape> shapes) {
  for (BlockShape& shape : shapes) {
    double reach = 0.0;
    for (const Vec3& corner : shape.corners)
      reach = std::max(reach, (corner - shape.key_offset).norm());
    const Solid solid({shape.corners, shape.faces}, {Vec3::Zero(), Mat3::Identity()});
    blocks_.insert_or_assign(shape.tag, ShapedBlock{shape.key, shape.key_offset, solid, reach});
    largest_reach_ = std::max(largest_reach_, reach);
    stored_.push_back(std::move(shape));
  }
}

const ShapedBlock* FixMuckpileShapes::shape(int tag) const {
  const auto place = blocks_.find(tag);
  return place == blocks_.end() ? nullptr : &place->second;
}

void FixMuckpileShapes::write_restart(FILE* file) {
  engine::write_state(*lmp, style, file, ShapesState{stored_});
}

void FixMuckpileShapes::restart(char* state) {
  engine::or_engine_error(*lmp, "read_restart", [&] {
    take(engine::read_state<ShapesState>(*lmp, style, state).shapes);
    return 0;
  });
}

double FixMuckpileShapes::memory_usage() {
  double bytes = 0.0;
  for (const auto& [tag, block] : blocks_)
    bytes += 2.0 * (block.solid.bytes() + static_cast<double>(sizeof(block)));
  return bytes;
}

}  // namespace muckpile
