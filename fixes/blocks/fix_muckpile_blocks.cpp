// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blocks: the lists of records, facets and faces, and who holds them.
// Scope: what crosses ranks is in fix_muckpile_blocks_migration.cpp.
#include "fixes/blocks/fix_muckpile_blocks.h"

#include <modify.h>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "args/input_error.h"
#include "fixes/blocks/other_fixes.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/pair_style_check.h"
#include "fixes/engine/style_args.h"
#include "rock/rock_zones.h"

namespace muckpile {
namespace {

using FacetKey = std::pair<int, int>;

FacetKey key_of(const Facet& facet) { return {facet.tag_i, facet.face}; }

}  // namespace

FixMuckpileBlocks::FixMuckpileBlocks(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), multisphere_(engine::find_multisphere(*engine)) {
  if (multisphere_ == nullptr) {
    engine::stop(*lmp, "fix muckpile/blocks needs a fix multisphere defined before it");
  }
  restart_global = restart_file = 1;
}

FixMuckpileBlocks::~FixMuckpileBlocks() {
  if (keeper_ != nullptr) keeper_->store_is_gone();
}

int FixMuckpileBlocks::setmask() { return LAMMPS_NS::FixConst::PRE_NEIGHBOR; }

void FixMuckpileBlocks::init() {
  record_.check_all(*lmp);
  refuse_other_movers(*lmp, *multisphere_);
  warn_of_other_holders(*lmp, *multisphere_, holders_told_);
}

engine::Bodies FixMuckpileBlocks::bodies() { return engine::Bodies(*multisphere_); }

void FixMuckpileBlocks::setup(int /*vflag*/) {
  if (!contact_warned_) engine::warn_without_contact_law(*lmp);
  contact_warned_ = true;
}

FixMuckpileBlocks* FixMuckpileBlocks::find(LAMMPS_NS::LAMMPS& lmp) {
  return dynamic_cast<FixMuckpileBlocks*>(lmp.modify->find_fix_style_strict("muckpile/blocks", 0));
}

double FixMuckpileBlocks::memory_usage() {
  return static_cast<double>(
      records_.capacity() * sizeof(BlockRecord) + facets_.capacity() * sizeof(Facet) +
      memory_.capacity() * sizeof(FacetMemory) + faces_.capacity() * sizeof(BoundaryFace));
}

void FixMuckpileBlocks::add(BlocksShare share, const std::vector<Hole>& holes, int blocks_all,
                            int joints_all) {
  for (const FacetEntry& entry : share.facets)
    highest_joint_class_ = std::max<int>(highest_joint_class_, entry.facet.joint_class);
  // Joints that have retired are no longer in the lists.
  facets_created_ += joints_all;
  take_back();
  records_.insert(records_.end(), share.records.begin(), share.records.end());
  add_facets(std::move(share.facets));
  const int first_hole = static_cast<int>(holes_.size());
  for (BoundaryFace face : share.faces) {
    if (face.hole >= 0) face.hole += first_hole;
    faces_.push_back(face);
  }
  holes_.insert(holes_.end(), holes.begin(), holes.end());
  blocks_created_ += blocks_all;
  tags_.clear();
  synchronise();
}

std::vector<std::uint8_t> FixMuckpileBlocks::zone_numbers(const std::vector<std::string>& names) {
  std::vector<std::uint8_t> numbers{0};
  for (const std::string& name : names) {
    const auto found = std::ranges::find(zones_, name);
    if (found == zones_.end() && zones_.size() == kMostZones)
      throw InputError("create_blocks: zone must be one of at most " + std::to_string(kMostZones) +
                       " names, all create_blocks together, got one more, '" + name + "'");
    numbers.push_back(static_cast<std::uint8_t>(1 + (found - zones_.begin())));
    if (found == zones_.end()) zones_.push_back(name);
  }
  return numbers;
}

std::vector<int> FixMuckpileBlocks::body_tags() {
  const engine::Bodies bodies(*multisphere_);
  std::vector<int> tags(static_cast<std::size_t>(bodies.count()));
  for (int b = 0; b < bodies.count(); ++b) tags[static_cast<std::size_t>(b)] = bodies.tag(b);
  return tags;
}

void FixMuckpileBlocks::synchronise() {
  const std::vector<int> tags = body_tags();
  if (!engine::on_any_rank(tags != tags_, world)) return;
  take_back();
  const engine::BlockDirectory directory(tags, world);
  drop_orphans(tags, directory);
  migrate(tags, directory);
  index(tags, directory);
  tags_ = tags;
  ++version_;
}

/// Gets the facets back from the keeper.
void FixMuckpileBlocks::take_back() {
  if (!handed_over_) return;
  FacetLists lists = keeper_->hand_back();
  facets_ = std::move(lists.facets);
  memory_ = std::move(lists.memory);
  faces_ = std::move(lists.faces);
  handed_over_ = false;
  drop_retired();
}

FacetLists FixMuckpileBlocks::hand_over() {
  handed_over_ = true;
  FacetLists lists{std::move(facets_), std::move(memory_), std::move(faces_)};
  facets_.clear();
  memory_.clear();
  faces_.clear();
  return lists;
}

/// The facets of the former keeper come back first; how soft it made them stays known.
void FixMuckpileBlocks::set_keeper(FacetKeeper* keeper) {
  take_back();
  softness_ = softness();
  keeper_ = keeper;
}

void FixMuckpileBlocks::retire_into_record(const Facet& facet, int end) {
  if (end < 0 || end >= static_cast<int>(records_.size())) return;  // a copy, or the ground
  BlockRecord& record = records_[static_cast<std::size_t>(end)];
  record.retired.add(facet, end == facet.i ? facet.arm_i : facet.arm_j, record.volume);
}

/// Retired facets need not travel: their blocks remember what is left to know of them. Every rank
/// that holds a copy drops it at the same time.
void FixMuckpileBlocks::drop_retired() {
  keep_facets([&](std::size_t f) {
    if (!memory_[f].over()) return true;
    retire_into_record(facets_[f], facets_[f].i);
    retire_into_record(facets_[f], facets_[f].j);
    return false;
  });
}

void FixMuckpileBlocks::keep_facets(const std::function<bool(std::size_t)>& needed) {
  std::size_t kept = 0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (!needed(f)) continue;
    if (kept != f) {
      facets_[kept] = facets_[f];
      memory_[kept] = std::move(memory_[f]);
    }
    ++kept;
  }
  facets_.resize(kept);
  memory_.resize(kept);
}

/// Puts facets in their places among those that are here; one that is here already stays as it is.
void FixMuckpileBlocks::add_facets(std::vector<FacetEntry> added) {
  if (added.empty()) return;
  std::sort(added.begin(), added.end(), [](const FacetEntry& a, const FacetEntry& b) {
    return key_of(a.facet) < key_of(b.facet);
  });
  std::vector<Facet> facets;
  std::vector<FacetMemory> memories;
  facets.reserve(facets_.size() + added.size());
  memories.reserve(facets_.size() + added.size());
  const auto append = [&](const Facet& facet, FacetMemory& its) {
    if (!facets.empty() && key_of(facets.back()) == key_of(facet)) return;
    facets.push_back(facet);
    memories.push_back(std::move(its));
  };
  auto next = added.begin();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    for (; next != added.end() && key_of(next->facet) < key_of(facets_[f]); ++next)
      append(next->facet, next->memory);
    append(facets_[f], memory_[f]);
  }
  for (; next != added.end(); ++next) append(next->facet, next->memory);
  facets_ = std::move(facets);
  memory_ = std::move(memories);
}

void FixMuckpileBlocks::index(const std::vector<int>& tags,
                              const engine::BlockDirectory& directory) {
  std::unordered_map<int, int> position;
  for (std::size_t b = 0; b < tags.size(); ++b) position[tags[b]] = static_cast<int>(b);
  copy_tags_.clear();
  for (const Facet& facet : facets_) {
    for (int tag : {facet.tag_i, facet.tag_j}) {
      if (tag == kGroundTag || position.count(tag) != 0) continue;
      position[tag] = static_cast<int>(tags.size() + copy_tags_.size());
      copy_tags_.push_back(tag);
    }
  }
  const int ground = static_cast<int>(tags.size() + copy_tags_.size());
  const int owned = static_cast<int>(tags.size());
  for (Facet& facet : facets_) {
    facet.i = position.at(facet.tag_i);
    facet.j = facet.tag_j == kGroundTag ? ground : position.at(facet.tag_j);
    if (facet.kind == FacetKind::joint) {
      facet.weight = 0.5 * (facet.i < owned ? 1.0 : 0.0) + 0.5 * (facet.j < owned ? 1.0 : 0.0);
    }
  }
  for (BoundaryFace& face : faces_) face.block = position.at(face.tag);
  halo_ = engine::BlockHalo(tags, copy_tags_, directory, world);
}

}  // namespace muckpile
