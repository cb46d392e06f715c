// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blast: words, clock, and the sums over ranks; the laws are in core/explosive.
// Scope: outputs and restart are in fix_muckpile_blast_output.cpp.
#include "fixes/explosive/fix_muckpile_blast.h"

#include <comm.h>
#include <error.h>
#include <modify.h>
#include <mpi.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "args/numbers.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "geometry/holes/hole_surface.h"

namespace muckpile {
namespace {

std::vector<Hole> holes_of(const BlastSurface& surface) {
  std::vector<Hole> holes;
  for (int i = 0; i < surface.hole_count(); ++i) holes.push_back(surface.hole(i));
  return holes;
}

}  // namespace

FixMuckpileBlast::FixMuckpileBlast(LAMMPS_NS::LAMMPS* lmp_in, int narg, char** arg)
    : Fix(lmp_in, narg, arg), where_(engine::name_of(*this)) {
  engine::refuse_second_fix(*lmp, where_, "muckpile/blast");
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues values = engine::read_args(*lmp, blast_table(), where_, narg, arg, 3);
  options_ = engine::or_engine_error(*lmp, [&] { return blast_options(values, where_); });
  crack_discharge_ = options_.flow.crack_discharge;
  vector_flag = array_flag = 1;
  size_vector = kOutputs;
  size_array_cols = kHoleOutputs;
  if (const auto* surface = engine::find_view<BlastSurface>(*lmp))
    size_array_rows = surface->hole_count();
  global_freq = 1;
  extvector = 0;
  restart_global = 1;
  nevery = 1;  // end_of_step()
}

int FixMuckpileBlast::setmask() {
  return LAMMPS_NS::FixConst::PRE_FORCE | LAMMPS_NS::FixConst::END_OF_STEP;
}

void FixMuckpileBlast::init() {
  if (std::strcmp(update->unit_style, "si") != 0) {
    engine::stop(*lmp, where_ + ": needs units si, got '" + update->unit_style + "'");
  }
  surface_ = engine::find_view<BlastSurface>(*lmp);
  if (surface_ == nullptr) {
    engine::stop(*lmp, where_ + ": needs a fix muckpile/joint, which holds the faces to load");
  }
  arrivals_known_ = false;
  const std::vector<Hole> holes = holes_of(*surface_);
  engine::or_engine_error(*lmp, [&] {
    std::vector<HoleBlast> blasts = hole_blasts(options_, holes);
    if (!described_) engine::print_once(*lmp, describe(options_, holes, blasts));
    holes_.set(std::move(blasts), hole_charges(options_, holes));
  });
  described_ = true;
  size_array_rows = static_cast<int>(holes_.count());
  surface_->expect_pressure(!over_);
}

/// A wall gives way to pressure by that over its stiffness: on joints softened to next to nothing
/// the gas would fill a crushed zone many times as large, without any block having moved. With gas
/// in joints fix muckpile/gas decides. The walls have their pressures of this moment.
void FixMuckpileBlast::release_from_softened_walls() {
  constexpr double kBearable = 0.1;  // pressure over shear modulus; strains of some per cent
  const double modulus = surface_->shear_modulus(), before = softened_;
  softened_ = surface_->softened();
  if (softened_ >= before || over_) return;
  require_fired(kBearable * modulus);
  const double pressure = greatest_pressure();
  if (holes_.ambient() > 0.0 || pressure <= kBearable * modulus) return;
  release_gas();
  surface_->unload_softened();
  load_faces(clock());
  engine::print_once(
      *lmp, where_ + ": the gas in the holes is released, as joints of a shear modulus of " +
                number_text(modulus) + " Pa do not bear the " + number_text(pressure) +
                " Pa on their walls, at " + number_text(clock()) + " s\n");
}

void FixMuckpileBlast::require_fired(double bearable) const {
  for (std::size_t hole = 0; hole < holes_.count(); ++hole) {
    const HoleBlast& blast = holes_.blast(hole);
    const double load = blast.load().greatest_pressure();
    if (clock() > blast.firing_time() || load <= bearable) continue;
    engine::stop(*lmp, where_ +
                           ": joints are to be softened after the last hole has fired, got hole " +
                           std::to_string(hole + 1) + " to fire at " +
                           number_text(blast.firing_time()) + " s with " + number_text(load) +
                           " Pa, softened at " + number_text(clock()) + " s");
  }
}

double FixMuckpileBlast::greatest_pressure() const {
  double greatest = 0.0;
  for (const double pressure : pressures_) greatest = std::max(greatest, pressure);
  return engine::greatest_over_ranks(greatest, world);
}

/// An unfix in the middle of the blast takes the pressure off; at the end of the program there is
/// nothing to do.
void FixMuckpileBlast::pre_delete(bool unfixflag) {
  BlastSurface* surface = unfixflag ? engine::find_view<BlastSurface>(*lmp) : nullptr;
  if (surface == nullptr) return;
  const std::size_t count = surface->loaded_facets().size();
  const std::vector<double> none(count, 0.0);
  surface->set_pressure(none, none);
  surface->expect_pressure(false);
}

/// Before a charge fires, and once its pulse has passed, rise_time is no measure of the step.
void FixMuckpileBlast::check_timestep() {
  // The sampled peak of a starfield pulse is then within 0.5 % of P1; measured in a small bench,
  // work of wave and gas are within 0.4 % of those with 15 steps.
  constexpr double kStepsPerRise = 5.0;
  constexpr double kRounding = 1e-9;
  const double of_rise = options_.pulse_shape.rise_time / kStepsPerRise;
  const double longest = (1.0 + kRounding) * std::max(of_rise, expected_step_);
  if (warned_ || over_ || update->dt <= longest) return;
  if (!holes_.any_pulse(clock())) return;
  warned_ = true;
  if (comm->me != 0) return;
  error->warning(FLERR,
                 (where_ + ": the time step, " + number_text(update->dt) +
                  " s, is longer than a fifth of rise_time; the pulse is cut into few steps; "
                  "give a shorter 'timestep', or max of fix muckpile/timestep")
                     .c_str());
}

BlastTiming FixMuckpileBlast::timing() const {
  BlastTiming timing;
  timing.start = clock_started_ ? clock_zero_ : update->get_cur_time() - clock_restarted_;
  timing.rise_time = options_.pulse_shape.rise_time;
  if (options_.gas) {
    timing.vent_time = options_.vent_time;
    timing.vent_decay = options_.vent_decay;
  }
  const auto* surface = engine::find_view<BlastSurface>(*lmp);
  if (surface == nullptr) return timing;
  engine::or_engine_error(*lmp, [&] {
    const std::vector<Hole> zones = holes_of(*surface);
    const std::vector<HoleBlast> blasts = hole_blasts(options_, zones);
    for (std::size_t h = 0; h < blasts.size(); ++h) {
      const HoleBlast& hole = blasts[h];
      timing.last_firing = std::max(timing.last_firing, hole.firing_time());
      timing.pulse_end = std::max(timing.pulse_end, hole.pulse_end());
      timing.pulses.push_back({hole.firing_time(), hole.pulse_end()});
      timing.wall_load =
          std::max(timing.wall_load, hole.load().greatest_pressure() / zones[h].radius);
    }
  });
  return timing;
}

double FixMuckpileBlast::gas_gamma() const {
  return engine::or_engine_error(*lmp, [&] { return muckpile::gas_gamma(options_); });
}

double FixMuckpileBlast::gas_constant() const {
  const auto* surface = engine::find_view<BlastSurface>(*lmp);
  return engine::or_engine_error(*lmp, [&] {
    return muckpile::gas_constant(options_,
                                  surface != nullptr ? holes_of(*surface) : std::vector<Hole>{});
  });
}

double FixMuckpileBlast::clock() const { return update->get_cur_time() - clock_zero_; }

void FixMuckpileBlast::setup_pre_force(int vflag) {
  // The clock starts at 0, or goes on from a restart file, whatever the engine's time is.
  if (!clock_started_) clock_zero_ = update->get_cur_time() - clock_restarted_;
  clock_started_ = true;
  // Once only: in a blast that goes on from a file, blocks may have left the walls.
  if (!walls_checked_) check_walls();
  walls_checked_ = true;
  pre_force(vflag);
  release_from_softened_walls();
}

/// Until the first charge has fired, all charges find the walls where they are at the start of the
/// run, whatever has moved them before. The joints know the poses of this moment only if they have
/// been set up before.
void FixMuckpileBlast::setup(int) {
  if (over_ || (walls_swept_ && holes_.any_fired(clock()))) return;
  if (engine::place_of<BlastSurface>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, where_ + ": must be defined after fix muckpile/joint");
  walls_swept_ = true;
  std::vector<double> swept(holes_.count(), 0.0);
  surface_->swept_volume(swept);
  engine::sum_over_ranks_in_place(swept, world);
  holes_.start_from(swept);
}

/// Refuses a hole that lies in part outside the rock and not behind mirror planes: half a wall
/// would sweep half the volume, but with the gas of a whole charge.
void FixMuckpileBlast::check_walls() const {
  // Of the modelled part of the cylinder. Its wall is a prism of six sides at least; that of a part
  // has a few faces only.
  constexpr double kLeastShare = 0.75, kLeastOfPart = 0.6;
  constexpr double kEnd = 1e-3;  // faces nearer to an end than this share of the length are caps
  std::vector<double> area(static_cast<std::size_t>(surface_->hole_count()), 0.0);
  for (const LoadedFacet& face : surface_->loaded_facets()) {
    const Hole& hole = surface_->hole(face.hole);
    const Vec3 axis = hole.collar - hole.toe;
    const double along = (face.start_point - hole.toe).dot(axis) / axis.squaredNorm();
    if (along > kEnd && along < 1.0 - kEnd) area[static_cast<std::size_t>(face.hole)] += face.area;
  }
  engine::sum_over_ranks_in_place(area, world);
  for (std::size_t h = 0; h < area.size(); ++h) {
    const Hole& hole = surface_->hole(static_cast<int>(h));
    const double share = area[h] / (2.0 * M_PI * hole.radius * hole_length(hole));
    const double least = hole.share < 1.0 ? kLeastOfPart : kLeastShare;
    if (share >= least * hole.share) continue;
    engine::stop(*lmp, where_ + ": hole " + std::to_string(h + 1) +
                           " must lie whole in the rock, or with its axis in mirror planes, got " +
                           std::to_string(std::lround(100.0 * share)) +
                           " % of the wall of its crushed zone");
  }
}

void FixMuckpileBlast::pre_force(int /*vflag*/) {
  if (over_) return;
  const double time = clock();
  if (!holes_.any_fired(time)) return;
  check_timestep();
  refresh_arrivals();
  load_faces(time);
  if (holes_.all_over()) finish();
}

void FixMuckpileBlast::end_of_step() {
  constexpr double kStepsAhead = 10.0;  // of the first charge: the step may grow meanwhile
  if (over_ || !holes_.any_fired(clock() + kStepsAhead * update->dt)) return;
  sum_over_walls();
  holes_.advance(clock(), update->dt);
}

void FixMuckpileBlast::refresh_arrivals() {
  const std::uint64_t version = surface_->loaded_facets_version();
  if (arrivals_known_ && version == arrivals_version_) return;
  arrivals_.clear();
  for (const LoadedFacet& face : surface_->loaded_facets()) {
    arrivals_.push_back(
        holes_.blast(static_cast<std::size_t>(face.hole)).arrival_time(face.start_point));
  }
  pressures_.assign(arrivals_.size(), 0.0);
  wave_share_.assign(arrivals_.size(), 0.0);
  arrivals_version_ = version;
  arrivals_known_ = true;
}

/// Swept volumes and works of all ranks.
void FixMuckpileBlast::sum_over_walls() {
  const std::size_t holes = holes_.count();
  std::vector<double> sums(2 * holes, 0.0);
  const std::span<double> swept(sums.data(), holes), work(sums.data() + holes, holes);
  surface_->swept_volume(swept);
  surface_->work_of_step(work);
  engine::sum_over_ranks_in_place(sums, world);
  holes_.book_walls(swept, work, clock());
}

void FixMuckpileBlast::load_faces(double time) {
  holes_.press(time);
  const std::span<const LoadedFacet> faces = surface_->loaded_facets();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto hole = static_cast<std::size_t>(faces[i].hole);
    const BlastHoles::OnWall load = holes_.on_wall(hole, arrivals_[i], time);
    pressures_[i] = load.pressure;
    wave_share_[i] = load.wave_share;
  }
  surface_->set_pressure(pressures_, wave_share_);
}

void FixMuckpileBlast::let_gas_into_joints(double ambient) {
  if (!options_.gas || !options_.vent_by_flow)
    throw InputError(where_ + ": gas in joints needs gas yes and venting flow");
  options_.flow.crack_discharge = 0.0;
  holes_.press_against(ambient);
}

void FixMuckpileBlast::keep_gas_out_of_joints() {
  options_.flow.crack_discharge = crack_discharge_;
  holes_.press_against(0.0);
}

GasChamber FixMuckpileBlast::chamber(std::size_t hole) const {
  if (holes_.over(hole)) return {};
  const BlastHoles::Gas gas = holes_.gas(hole, clock());
  return {
      {gas.pressure, gas.density}, gas.mass, gas.enthalpy, 0.0, holes_.charge(hole).crushed_rock,
      gas.energy / gas.enthalpy};
}

void FixMuckpileBlast::release_gas() { holes_.release_gas(clock()); }

void FixMuckpileBlast::take_gas(std::span<const GasFlow> per_hole) {
  for (std::size_t hole = 0; hole < holes_.count(); ++hole)
    holes_.take_gas(hole, per_hole[hole].mass, per_hole[hole].energy, clock());
}

/// The last load has just been set to zero on every face; nothing is left to do.
void FixMuckpileBlast::finish() {
  over_ = true;
  surface_->expect_pressure(false);
  engine::print_once(*lmp, where_ + ": all holes are over at " + std::to_string(clock()) + " s\n");
}

}  // namespace muckpile
