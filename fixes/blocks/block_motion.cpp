// SPDX-License-Identifier: GPL-2.0-or-later
// block_motion: words to a motion, and the motion to bodies, their spheres and the energy account.
// Scope: see the header. The laws are those of src/core/motion/given_motion.h.
#include "fixes/blocks/block_motion.h"

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <fix_multisphere.h>
#include <input.h>
#include <modify.h>
#include <multisphere.h>
#include <variable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "args/numbers.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/particle_vectors.h"
#include "fixes/engine/region.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/energy_account.h"
#include "fixes/interfaces/given_energy.h"
#include "fixes/interfaces/keyword_tables.h"
#include "fixes/interfaces/resting_blocks.h"

namespace muckpile {
namespace {

constexpr const char* kStyle = "block_motion";
constexpr double kFastest = 1e4;  // [m/s], of any point of a block: faster is a mistake

const ArgTable& table() {
  static const ArgTable args =
      ArgTable(kStyle)
          .group("velocity", 3, 3, false, "x, y and z of the velocity [m/s]")
          .group("rotation", 3, 3, false,
                 "all of them together turn as one rigid body about `origin` [rad/s]")
          .group("origin", 3, 3, false, "a point of the axis of `rotation` [m]; else 0 0 0")
          .group("spin", 3, 3, false, "each turns about its own centre [rad/s]")
          .word("mode", {"set", "add"}, "set",
                "whether velocity, rotation and spin take the place of what a block has")
          .group("impulse", 3, 3, false, "push on each of them [N s], added to the rest")
          .group("at", 3, 3, false,
                 "point where the impulse acts, on one block [m]; else through its centre");
  return args;
}

std::optional<Vec3> vector_of(const ArgValues& args, const std::string& key,
                              const std::string& unit) {
  if (!args.given(key)) return std::nullopt;
  const std::vector<std::string>& words = args.groups(key).front();
  Vec3 vector;
  for (std::size_t d = 0; d < 3; ++d)
    vector[static_cast<Eigen::Index>(d)] = parse_real(kStyle, key, words[d], unit, Range::any());
  return vector;
}

GivenMotion motion_of(const ArgValues& args) {
  GivenMotion given;
  given.velocity = vector_of(args, "velocity", "m/s");
  given.rotation = vector_of(args, "rotation", "rad/s");
  given.origin = vector_of(args, "origin", "m").value_or(Vec3::Zero());
  given.spin = vector_of(args, "spin", "rad/s");
  given.impulse = vector_of(args, "impulse", "N s");
  given.at = vector_of(args, "at", "m");
  given.adds = args.word("mode") == "add";
  const std::string where = kStyle;
  if (!given.velocity && !given.rotation && !given.spin && !given.impulse)
    throw InputError(where + ": needs one of velocity, rotation, spin and impulse");
  if (args.given("origin") && !given.rotation)
    throw InputError(where + ": origin needs rotation beside it");
  if (given.at && !given.impulse) throw InputError(where + ": at needs impulse beside it");
  return given;
}

}  // namespace

const ArgTable& block_motion_keywords() { return table(); }

void BlockMotionCommand::command(int narg, char** arg) {
  const std::string where = kStyle;
  if (narg < 1) engine::stop(*lmp, where + ": needs a region, or 'all', as its first word");
  if (engine::find_multisphere(*lmp) == nullptr)
    engine::stop(*lmp, where + ": needs 'fix ID all multisphere' and blocks before it");
  const GivenMotion given = engine::or_engine_error(*lmp, [&] {
    const ArgValues args = parse_args(table(), kStyle, words_with_values(narg, arg));
    engine::print_once(*lmp, args.echo());
    return motion_of(args);
  });
  const std::string region = arg[0];
  if (region != "all") engine::require_region(*lmp, where, region);
  const std::vector<int> bodies = bodies_in(region);
  check_count(region, bodies, given.at.has_value());
  hand_over(bodies, moved_bodies(bodies, given));
  tell_spheres(bodies);
  if (auto* sleep = engine::find_view<RestingBlocks>(*lmp)) sleep->wake_blocks();
}

/// Words v_NAME become the value of that variable.
std::vector<std::string> BlockMotionCommand::words_with_values(int narg, char** arg) const {
  std::vector<std::string> words = engine::words_of(narg, arg, 1);
  for (std::string& word : words)
    if (word.compare(0, 2, "v_") == 0) word = number_text(value_of(word.substr(2)));
  return words;
}

double BlockMotionCommand::value_of(const std::string& name) const {
  std::string word = name;
  const int variable = input->variable->find(word.data());
  if (variable < 0 || input->variable->equalstyle(variable) == 0)
    throw InputError(std::string(kStyle) + ": v_" + name + " needs 'variable " + name +
                     " equal ...' before it");
  return input->variable->compute_equal(variable);
}

std::vector<int> BlockMotionCommand::bodies_in(const std::string& region) const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  std::vector<int> found;
  for (int b = 0; b < bodies.count(); ++b)
    if (region == "all" || engine::in_region(*lmp, region, bodies.centre(b))) found.push_back(b);
  return found;
}

void BlockMotionCommand::check_count(const std::string& region, const std::vector<int>& bodies,
                                     bool only_one) const {
  const std::string where = kStyle;
  const int all = engine::find_multisphere(*lmp)->data().n_body();
  std::array<int, 2> sum{static_cast<int>(bodies.size()), all};
  engine::sum_over_ranks_in_place(sum, world);
  if (sum[1] == 0) engine::stop(*lmp, where + ": there are no blocks; create_blocks comes before");
  if (sum[0] == 0)
    engine::stop(*lmp, where + ": region '" + region +
                           "' must hold the centre of a block, got none of " +
                           std::to_string(sum[1]) + " blocks");
  if (only_one && sum[0] != 1)
    engine::stop(*lmp, where + ": at needs a region that holds the centre of one block, got " +
                           std::to_string(sum[0]) + " in '" + region + "'");
}

std::vector<MovingBody> BlockMotionCommand::moved_bodies(const std::vector<int>& bodies,
                                                         const GivenMotion& given) const {
  LAMMPS_NS::FixMultisphere& fix = *engine::find_multisphere(*lmp);
  const engine::Bodies now(fix);
  std::vector<MovingBody> states;
  double mine = 0.0;
  for (const int b : bodies) {
    states.push_back(
        moved({now.mass(b), now.inertia_in_space(b), now.centre(b), now.velocity(b), now.spin(b)},
              given));
    const MovingBody& then = states.back();
    const double speed = then.velocity.norm() + then.spin.norm() * fix.data().r_bound(b);
    mine = std::isfinite(speed) ? std::max(mine, speed) : HUGE_VAL;
  }
  const double fastest = engine::greatest_over_ranks(mine, world);
  if (fastest > kFastest)
    engine::stop(*lmp, std::string(kStyle) + ": no point of a block may move faster than " +
                           number_text(kFastest) + " m/s, got " + number_text(fastest) +
                           "; give less velocity, spin or impulse");
  return states;
}

void BlockMotionCommand::hand_over(const std::vector<int>& bodies,
                                   const std::vector<MovingBody>& states) {
  engine::Bodies now(*engine::find_multisphere(*lmp));
  double given = 0.0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const int b = bodies[k];
    given -= now.kinetic_energy(b);
    now.velocity(b) = states[k].velocity;
    now.spin(b) = states[k].spin;
    now.angular_momentum(b) = states[k].inertia * states[k].spin;
    given += now.kinetic_energy(b);
  }
  if (auto* account = engine::find_view<EnergyAccount>(*lmp))
    account->book_given(given);
  else if (auto* before = engine::find_view<GivenEnergy>(*lmp))  // not there without create_blocks
    before->keep_given(given);
}

/// The set-up of a run works out contacts with the velocities that spheres have; some of them may
/// lie on other ranks than their body.
void BlockMotionCommand::tell_spheres(const std::vector<int>& bodies) const {
  LAMMPS_NS::FixMultisphere& fix = *engine::find_multisphere(*lmp);
  const engine::Bodies now(fix);
  std::vector<double> mine;
  for (const int b : bodies) {
    mine.push_back(now.tag(b));
    for (const Vec3& v : {Vec3(now.centre(b)), Vec3(now.velocity(b)), Vec3(now.spin(b))})
      mine.insert(mine.end(), v.data(), v.data() + 3);
  }
  constexpr std::size_t kRow = 10;
  const std::vector<double> all = engine::gather_all(mine, world);
  std::unordered_map<int, const double*> rows;
  for (std::size_t k = 0; k < all.size(); k += kRow)
    rows[static_cast<int>(all[k])] = all.data() + k + 1;
  for (int k = 0; k < atom->nlocal; ++k) {
    const auto row = rows.find(fix.belongs_to(k));
    if (row == rows.end()) continue;
    const Vec3 centre(row->second), velocity(row->second + 3), spin(row->second + 6);
    Vec3 arm = engine::vector_of(atom->x[0], k) - centre;
    domain->minimum_image(arm.x(), arm.y(), arm.z());
    Vec3::Map(atom->v[k]) = velocity + spin.cross(arm);
    Vec3::Map(atom->omega[k]) = spin;
  }
}

}  // namespace muckpile
