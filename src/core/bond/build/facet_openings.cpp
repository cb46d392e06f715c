// SPDX-License-Identifier: GPL-2.0-or-later
// m of every facet: from each block alone, or from all together where the faces lean.
// Scope: see the header.
//
// The jump u of a facet adds A m.u/2 to the volume of its block. In a homogeneous strain that sum,
// and with it the gradient of leaning_faces.h, is right if sum of A m (x) r = V I, r half the way
// to the neighbour's centre. With m = n it is wrong by the first moment of the facets about the
// lines between the centres. Two ways to take that out:
//   of each block: m = K n, K the inverse of the sum of A n (x) r / V;
//   balanced, where faces lean: m_i = 2 w n + s and m_j = 2 (1 - w) n - s, w the share of block i
//   in h, with the s of least A h |s|^2 that makes all sums right (as nearly as walls allow). The
//   mean of m_i and m_j is n, so a uniform stress is in balance too.
#include "bond/build/facet_openings.h"

#include <cmath>

namespace muckpile {
namespace {

constexpr int kMostRounds = 40;      // of the conjugate gradients: moduli stand to 1e-5 then
constexpr double kRoundOff = 1e-12;  // of the square of the gradient

/// Half the way to the centre of the neighbour, its mirror image or, at other faces, all the way to
/// the face.
Vec3 half_way(const Facet& facet) {
  if (facet.kind == FacetKind::mirror) return facet.normal.dot(facet.arm_i) * facet.normal;
  return facet.kind == FacetKind::fixed ? facet.arm_i : 0.5 * (facet.arm_i - facet.arm_j);
}

class OpeningSearch {
 public:
  OpeningSearch(const std::vector<Block>& blocks, int first_tag, FacetSet& set)
      : blocks_(blocks), first_tag_(first_tag), set_(set) {}

  void of_each_block() {
    for (Facet& facet : set_.facets) facet.opening_i = facet.opening_j = facet.normal;
    const std::vector<Mat3> sums = moments();
    for (Facet& facet : set_.facets) {
      facet.opening_i = sums[number(facet.tag_i)].inverse() * facet.normal;
      facet.opening_j =
          is_joint(facet) ? Vec3(sums[number(facet.tag_j)].inverse() * facet.normal) : Vec3::Zero();
    }
  }

  /// Conjugate gradients on the normal equations (Hestenes & Stiefel 1952), from s = 0, which gives
  /// the least s. Unknowns are sqrt(A h) s.
  void balanced() {
    for (Facet& facet : set_.facets) {
      const bool joint = is_joint(facet);
      const double h = facet.normal.dot(facet.arm_i - facet.arm_j);
      const double share = joint ? facet.normal.dot(facet.arm_i) / h : 0.5;
      facet.opening_i = 2.0 * share * facet.normal;
      facet.opening_j = joint ? Vec3(2.0 * (1.0 - share) * facet.normal) : Vec3::Zero();
    }
    std::vector<Mat3> missing = moments();
    for (std::size_t b = 0; b < missing.size(); ++b)
      missing[b] = std::sqrt(blocks_[b].mass.volume) * (Mat3::Identity() - missing[b]);
    std::vector<Vec3> found(set_.facets.size(), Vec3::Zero());
    std::vector<Vec3> gradient = on_facets(missing), direction = gradient;
    double size = squared(gradient);
    const double first = size;
    for (int round = 0; round < kMostRounds && size > kRoundOff * first; ++round) {
      const std::vector<Mat3> change = on_blocks(direction);
      const double step = size / squared(change);
      for (std::size_t f = 0; f < found.size(); ++f) found[f] += step * direction[f];
      for (std::size_t b = 0; b < missing.size(); ++b) missing[b] -= step * change[b];
      gradient = on_facets(missing);
      const double next = squared(gradient);
      for (std::size_t f = 0; f < found.size(); ++f)
        direction[f] = gradient[f] + next / size * direction[f];
      size = next;
    }
    for (std::size_t f = 0; f < found.size(); ++f) {
      Facet& facet = set_.facets[f];
      if (!is_joint(facet)) continue;
      const Vec3 s = found[f] / std::sqrt(facet.area * facet.normal.dot(facet.arm_i - facet.arm_j));
      facet.opening_i += s;
      facet.opening_j -= s;
    }
  }

  /// All but the blocks of fixed supports, whose ground is solved for without these terms, and
  /// those beside another rock: the gradient of a block is that of one rock.
  void mark_slanted() {
    std::vector<bool> plain(blocks_.size(), false);
    for (const Facet& facet : set_.facets) {
      if (facet.kind == FacetKind::fixed) plain[number(facet.tag_i)] = true;
      if (facet.zone_i == facet.zone_j) continue;
      plain[number(facet.tag_i)] = plain[number(facet.tag_j)] = true;
    }
    for (Facet& facet : set_.facets) {
      facet.slanted = {!plain[number(facet.tag_i)], is_joint(facet) && !plain[number(facet.tag_j)]};
    }
  }

 private:
  [[nodiscard]] static bool is_joint(const Facet& facet) { return facet.kind == FacetKind::joint; }
  [[nodiscard]] std::size_t number(int tag) const {
    return static_cast<std::size_t>(tag - first_tag_);
  }

  template <typename Values>
  [[nodiscard]] static double squared(const Values& values) {
    double sum = 0.0;
    for (const auto& value : values) sum += value.squaredNorm();
    return sum;
  }

  /// Sum of A m (x) r / V of every block.
  [[nodiscard]] std::vector<Mat3> moments() const {
    std::vector<Mat3> sums(blocks_.size(), Mat3::Zero());
    const auto add = [&](int tag, const Vec3& opened, const Vec3& reach) {
      sums[number(tag)] += opened * reach.transpose() / blocks_[number(tag)].mass.volume;
    };
    for (const Facet& facet : set_.facets) {
      const Vec3 reach = half_way(facet);
      add(facet.tag_i, facet.area * facet.opening_i, reach);
      if (is_joint(facet)) add(facet.tag_j, facet.area * facet.opening_j, reach);
    }
    for (const BoundaryFace& face : set_.faces) add(face.tag, face.area * face.normal, face.arm);
    return sums;
  }

  /// d sqrt(A/h)/2 over the root of the volume of either block.
  [[nodiscard]] std::array<Vec3, 2> levers(const Facet& facet) const {
    const Vec3 between = facet.arm_i - facet.arm_j;
    const Vec3 lever = 0.5 * std::sqrt(facet.area / facet.normal.dot(between)) * between;
    return {lever / std::sqrt(blocks_[number(facet.tag_i)].mass.volume),
            lever / std::sqrt(blocks_[number(facet.tag_j)].mass.volume)};
  }
  [[nodiscard]] std::vector<Mat3> on_blocks(const std::vector<Vec3>& of_facets) const {
    std::vector<Mat3> out(blocks_.size(), Mat3::Zero());
    for (std::size_t f = 0; f < of_facets.size(); ++f) {
      const Facet& facet = set_.facets[f];
      if (!is_joint(facet)) continue;
      const auto [lever_i, lever_j] = levers(facet);
      out[number(facet.tag_i)] += of_facets[f] * lever_i.transpose();
      out[number(facet.tag_j)] -= of_facets[f] * lever_j.transpose();
    }
    return out;
  }
  [[nodiscard]] std::vector<Vec3> on_facets(const std::vector<Mat3>& of_blocks) const {
    std::vector<Vec3> out(set_.facets.size(), Vec3::Zero());
    for (std::size_t f = 0; f < out.size(); ++f) {
      const Facet& facet = set_.facets[f];
      if (!is_joint(facet)) continue;
      const auto [lever_i, lever_j] = levers(facet);
      out[f] = of_blocks[number(facet.tag_i)] * lever_i - of_blocks[number(facet.tag_j)] * lever_j;
    }
    return out;
  }

  const std::vector<Block>& blocks_;
  int first_tag_;
  FacetSet& set_;
};

}  // namespace

void set_openings(const std::vector<Block>& blocks, int first_tag, Leaning leaning, FacetSet& set) {
  OpeningSearch search(blocks, first_tag, set);
  if (leaning == Leaning::little) return search.of_each_block();
  search.balanced();
  search.mark_slanted();
}

}  // namespace muckpile
