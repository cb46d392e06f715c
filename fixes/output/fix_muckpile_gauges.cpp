// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gauges: binds gauges to blocks, reads them, and writes the rows on rank 0.
// Scope: see the header; words are read in core/rock/gauge_points, stresses summed in
// core/bond/network/block_stress.
#include "fixes/output/fix_muckpile_gauges.h"

#include <comm.h>
#include <error.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "args/numbers.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/periodic_output.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/block_stresses.h"
#include "fixes/interfaces/keyword_tables.h"
#include "fixes/interfaces/known_blocks.h"

namespace muckpile {
namespace {

constexpr const char* kHeader =
    "step,time_s,gauge,block,x_m,y_m,z_m,ux_m,uy_m,uz_m,vx_m_s,vy_m_s,vz_m_s,"
    "sxx_Pa,syy_Pa,szz_Pa,sxy_Pa,syz_Pa,szx_Pa,pressure_Pa,run_id\n";
constexpr std::size_t kWidth = 13;  // number of the gauge, displacement, velocity, stress

void append(std::string& text, double number, int digits) {
  std::array<char, 32> word{};
  const auto end =
      std::to_chars(word.begin(), word.end(), number, std::chars_format::general, digits);
  text += ',';
  text.append(word.begin(), end.ptr);
}

}  // namespace

const ArgTable& gauges_keywords() { return gauge_table(); }

FixMuckpileGauges::FixMuckpileGauges(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)) {
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues values = engine::read_args(*lmp, gauge_table(), where_, narg, arg, 3);
  options_ = engine::or_engine_error(*lmp, [&] { return gauge_options(values, where_); });
  engine::make_output_folder(*lmp, where_, options_.directory);
  table_ = engine::RunTable(*lmp, where_, options_.directory + "/" + options_.file, kHeader);
  for (const Vec3& point : options_.points) gauges_.push_back({point});
  nevery = 1;
  restart_global = 1;
}

int FixMuckpileGauges::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

void FixMuckpileGauges::init() {
  blocks_ = engine::find_view<KnownBlocks>(*lmp);
  rock_ = engine::find_view<BlockStresses>(*lmp);
  if (blocks_ == nullptr) engine::stop(*lmp, where_ + ": needs create_blocks before the first run");
  if (rock_ == nullptr)
    engine::stop(*lmp, where_ + ": needs a fix muckpile/joint, which knows the stress of blocks");
  if (engine::place_of<BlockStresses>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, where_ + ": must be defined after fix muckpile/joint");
  refuse_shared_file();
}

void FixMuckpileGauges::refuse_shared_file() const {
  for (int k = 0; k < modify->nfix; ++k) {
    const auto* other = dynamic_cast<const FixMuckpileGauges*>(modify->fix[k]);
    if (other == nullptr || other == this || other->options_.file != options_.file ||
        other->options_.directory != options_.directory)
      continue;
    engine::stop(*lmp, where_ + ": file '" + options_.directory + "/" + options_.file +
                           "' is that of fix '" + other->id + "', too; give another name");
  }
}

/// In setup() the joints know where all blocks are.
void FixMuckpileGauges::setup(int) {
  if (first_ >= 0) return;
  first_ = restored_ ? update->ntimestep + 1 : update->ntimestep;
  if (restored_) {
    for (std::size_t g = 0; g < gauges_.size(); ++g) of_block_.emplace(gauges_[g].block, g);
    return;
  }
  bind();
  sample();
}

void FixMuckpileGauges::end_of_step() {
  if (!table_.begun()) table_.begin(blocks_->run_id(), first_);
  if (due()) sample();
}

/// So many intervals have passed since time 0, but for the rounding of time, a sum of steps.
double FixMuckpileGauges::intervals() const {
  constexpr double kRounding = 1e-9;
  return update->get_cur_time() / options_.interval + kRounding;
}

bool FixMuckpileGauges::due() const {
  if (options_.every > 0) return update->ntimestep % options_.every == 0;
  return intervals() * options_.interval >= next_;
}

/// Of this rank's blocks the one that a point lies in, or the nearest; of equally near ones the
/// lowest tag. Without blocks it is infinitely far.
FixMuckpileGauges::Nearest FixMuckpileGauges::nearest_to(const Vec3& point) const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  const std::vector<double> outside = rock_->distances_from_blocks(point);
  Nearest nearest;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto k = static_cast<std::size_t>(b);
    if (blocks_->records()[k].mass == 0.0) continue;  // not made by create_blocks
    const bool nearer = outside[k] < nearest.distance ||
                        (outside[k] == nearest.distance && bodies.tag(b) < nearest.tag);
    if (nearer) nearest = {outside[k], b, bodies.tag(b)};
  }
  return nearest;
}

/// All ranks agree on the block of each gauge; its owner tells where the gauge is on it.
void FixMuckpileGauges::bind() {
  std::vector<Nearest> mine;
  std::vector<double> distances;
  for (const Gauge& gauge : gauges_) {
    mine.push_back(nearest_to(gauge.start));
    distances.push_back(mine.back().distance);
  }
  engine::least_over_ranks_in_place(distances, world);
  std::vector<int> tags;
  for (std::size_t g = 0; g < gauges_.size(); ++g)
    tags.push_back(mine[g].distance > distances[g] ? Nearest{}.tag : mine[g].tag);
  engine::least_over_ranks_in_place(tags, world);
  std::vector<double> rows(4 * gauges_.size(), 0.0);  // offset on the block, and its size [m]
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  for (std::size_t g = 0; g < gauges_.size(); ++g) {
    const int b = mine[g].body;
    if (b < 0 || mine[g].tag != tags[g]) continue;
    const Vec3 offset = bodies.axes(b).transpose() * (gauges_[g].start - Vec3(bodies.centre(b)));
    std::copy_n(offset.data(), 3, rows.begin() + static_cast<std::ptrdiff_t>(4 * g));
    rows[4 * g + 3] = std::cbrt(blocks_->records()[static_cast<std::size_t>(b)].volume);
  }
  engine::sum_over_ranks_in_place(rows, world);
  for (std::size_t g = 0; g < gauges_.size(); ++g) {
    require_near(g, distances[g], rows[4 * g + 3]);
    gauges_[g].block = tags[g];
    gauges_[g].offset = Vec3(rows.data() + 4 * g);
    of_block_.emplace(tags[g], g);
  }
  say_where(distances);
}

void FixMuckpileGauges::require_near(std::size_t g, double distance, double size) const {
  if (distance <= size) return;
  engine::stop(*lmp, where_ + ": gauge " + std::to_string(g + 1) + " at '" +
                         place_text(gauges_[g].start) +
                         "' m must lie in the rock or within a block of it; move it");
}

void FixMuckpileGauges::say_where(const std::vector<double>& distances) const {
  std::size_t outside = 0;
  for (const double distance : distances) outside += distance > 1e-6 ? 1 : 0;
  std::string line = where_ + ": " + std::to_string(gauges_.size()) + " gauges";
  if (outside > 0) line += ", " + std::to_string(outside) + " of them carried by the nearest block";
  engine::print_once(*lmp, line + "\n");
}

std::vector<double> FixMuckpileGauges::rows_of_this_rank() const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  std::vector<int> gauged;
  for (int b = 0; b < bodies.count(); ++b)
    if (of_block_.contains(bodies.tag(b))) gauged.push_back(b);
  const std::vector<Mat3> stresses = rock_->stresses(gauged);
  std::vector<double> rows;
  for (std::size_t k = 0; k < gauged.size(); ++k) {
    const int b = gauged[k];
    const auto [first, last] = of_block_.equal_range(bodies.tag(b));
    for (auto entry = first; entry != last; ++entry) {
      const Gauge& gauge = gauges_[entry->second];
      const Vec3 arm = bodies.axes(b) * gauge.offset;
      const Vec3 moved = Vec3(bodies.centre(b)) + arm - gauge.start;
      const Vec3 velocity = Vec3(bodies.velocity(b)) + Vec3(bodies.spin(b)).cross(arm);
      const Mat3& s = stresses[k];
      rows.insert(rows.end(), {static_cast<double>(entry->second), moved.x(), moved.y(), moved.z(),
                               velocity.x(), velocity.y(), velocity.z(), s(0, 0), s(1, 1), s(2, 2),
                               s(0, 1), s(1, 2), s(2, 0)});
    }
  }
  return rows;
}

void FixMuckpileGauges::sample() {
  if (last_ == update->ntimestep) return;
  last_ = update->ntimestep;
  // Multiples that fall into one step give one sample.
  if (options_.every == 0) next_ = (std::floor(intervals()) + 1.0) * options_.interval;
  const std::vector<double> all = engine::gather_all(rows_of_this_rank(), world);
  std::vector<std::vector<double>> rows(gauges_.size());
  std::vector<bool> seen(gauges_.size(), false);
  for (std::size_t k = 0; k < all.size(); k += kWidth) {
    const auto g = static_cast<std::size_t>(all[k]);
    seen[g] = true;
    rows[g].assign(all.begin() + static_cast<std::ptrdiff_t>(k + 1),
                   all.begin() + static_cast<std::ptrdiff_t>(k + kWidth));
  }
  note_lost(seen);
  table_.add(text(rows));
}

/// A gauge whose block has left the simulation has no rows from then on. The same on all ranks.
void FixMuckpileGauges::note_lost(const std::vector<bool>& seen) {
  for (std::size_t g = 0; g < gauges_.size(); ++g) {
    if (seen[g] || gauges_[g].lost) continue;
    gauges_[g].lost = true;
    if (comm->me != 0) continue;
    error->warning(FLERR, (where_ + ": gauge " + std::to_string(g + 1) +
                           " has left the simulation with its block " +
                           std::to_string(gauges_[g].block) + "; it has no more rows")
                              .c_str());
  }
}

std::string FixMuckpileGauges::text(const std::vector<std::vector<double>>& rows) const {
  std::string text;
  for (std::size_t g = 0; g < rows.size(); ++g) {
    if (rows[g].empty()) continue;
    const Gauge& gauge = gauges_[g];
    text += std::to_string(update->ntimestep);
    append(text, update->get_cur_time(), 12);
    text += ',' + std::to_string(g + 1) + ',' + std::to_string(gauge.block);
    for (const double x : gauge.start) append(text, x, 10);
    for (const double number : rows[g]) append(text, number, 7);
    append(text, -(rows[g][6] + rows[g][7] + rows[g][8]) / 3.0, 7);
    text += ',' + blocks_->run_id() + '\n';
  }
  return text;
}

void FixMuckpileGauges::write_restart(FILE* file) {
  engine::write_state(*lmp, style, file, GaugesState{gauges_, next_});
}

void FixMuckpileGauges::restart(char* bytes) {
  GaugesState state = engine::read_state<GaugesState>(*lmp, style, bytes);
  if (state.gauges.size() != gauges_.size())
    engine::stop(*lmp, where_ +
                           ": must have the gauges that it had when the restart file was "
                           "written, " +
                           std::to_string(state.gauges.size()) + " in number, got " +
                           std::to_string(gauges_.size()) + "; give the same words");
  for (std::size_t g = 0; g < gauges_.size(); ++g) {
    if (state.gauges[g].start == gauges_[g].start) continue;
    engine::stop(*lmp, where_ + ": gauge " + std::to_string(g + 1) + " must be at '" +
                           place_text(state.gauges[g].start) +
                           "' m as when the restart file was written, got '" +
                           place_text(gauges_[g].start) + "'; give the same words");
  }
  gauges_ = std::move(state.gauges);
  next_ = state.next;
  restored_ = gauges_.empty() || gauges_.front().block != 0;
}

}  // namespace muckpile
