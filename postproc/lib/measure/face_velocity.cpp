// SPDX-License-Identifier: GPL-2.0-or-later
// How fast the free face of a bench moves out, as a camera in front of the face would measure it.
// Scope: mass mean over the face layer at the height of the charge.
#include "measure/face_velocity.h"

#include <algorithm>
#include <cmath>

#include "measure/broken_out.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

// The file's on_free_face also marks the back and the sides of the model, so the block's own
// vertices decide.
bool touches_face(const StartBlock& block, const BenchPlanes& planes) {
  // Between the places where a face is known it may bulge.
  if (planes.frames != nullptr) return planes.behind_face(block.centroid) < 0.75 * block.size;
  constexpr double kTouch = 1e-3;  // of the block's size: far above the digits of the file
  return std::ranges::any_of(block.shape.vertices, [&](const Vec3& p) {
    return std::abs(planes.behind_face(p)) <= kTouch * block.size;
  });
}

double depth_of_layer(const std::vector<StartBlock>& blocks, double burden,
                      const BenchPlanes& planes) {
  if (planes.frames == nullptr && planes.face != nullptr)
    return std::max(0.25 * burden, mean_block_size(blocks, planes.face->at_face()));
  std::vector<char> at_face(blocks.size());
  each_in_parallel(blocks.size(),
                   [&](size_t b) { at_face[b] = touches_face(blocks[b], planes) ? 1 : 0; });
  return std::max(0.25 * burden, mean_block_size(blocks, at_face));
}

std::vector<size_t> layer_between(const std::vector<StartBlock>& blocks, double depth, double low,
                                  double high, const BenchPlanes& planes) {
  std::vector<size_t> layer;
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& start = blocks[b].centroid;
    const double behind = planes.behind_face(start);
    if (behind < depth && planes.is_behind_face(start) && start.z() >= low && start.z() <= high &&
        planes.abreast(start))
      layer.push_back(b);
  }
  return layer;
}

}  // namespace

std::vector<size_t> face_layer(const std::vector<StartBlock>& blocks, double burden, double low,
                               double high, const BenchPlanes& planes) {
  return layer_between(blocks, depth_of_layer(blocks, burden, planes), low, high, planes);
}

std::vector<std::vector<size_t>> face_bands(const std::vector<StartBlock>& blocks, double burden,
                                            double height, int bands, const BenchPlanes& planes) {
  const double depth = depth_of_layer(blocks, burden, planes), step = height / bands;
  std::vector<std::vector<size_t>> layers;
  for (int k = 0; k < bands; ++k)
    layers.push_back(layer_between(blocks, depth, k * step, (k + 1) * step, planes));
  return layers;
}

double mean_outward_velocity(const std::vector<StartBlock>& blocks, const Snapshot& snapshot,
                             const std::vector<size_t>& layer, const BenchPlanes& planes) {
  double momentum = 0.0, mass = 0.0;
  for (const size_t b : layer) {
    momentum +=
        blocks[b].mass * planes.outward(blocks[b].centroid).dot(snapshot.states[b].velocity);
    mass += blocks[b].mass;
  }
  return mass > 0.0 ? momentum / mass : 0.0;
}

}  // namespace muckpile
