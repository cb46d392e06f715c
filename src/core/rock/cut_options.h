// SPDX-License-Identifier: GPL-2.0-or-later
// What the words of create_blocks ask for.
// Scope: no engine; every fault in the words throws InputError that starts with the style's name.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "args/parse_args.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/cut/tessellation.h"
#include "geometry/size/size_target.h"
#include "geometry/surface/surface_fit.h"
#include "rock/muck.h"
#include "rock/natural_joints.h"
#include "rock/rock_cells.h"
#include "rock/rock_zones.h"

namespace muckpile {

/// Zones by a block model: see zone_model.h.
struct ZoneModel {
  std::string file{};    ///< empty: there is none
  bool partial = false;  ///< rock in no cell is that beside the zones
  std::vector<RockCell> cells{};
  std::shared_ptr<const RockCells> index{};  ///< of those at the region, once it is known
};

/// A surface through the rock whose facets have a class: see faults.h.
struct Fault {
  std::string file;
  std::uint8_t joint_class = 0;
  std::shared_ptr<const SurfaceIndex> index{};
  bool flat = false;       ///< the cut follows its plane
  double off_plane = 0.0;  ///< of its corners at the region, at most [m]
};

/// The mouth of a hole of `hole_table`.
struct Collar {
  std::string hole, file;     ///< its name, in which table
  Vec3 place = Vec3::Zero();  ///< [m]
};

struct CutOptions {
  TessellationOptions rock;                  ///< without its box, region and team
  SizeLimits limits{};                       ///< block_min and block_max
  std::optional<SizeTarget> target{};        ///< size curve to meet, in place of rock.size
  std::optional<std::string> import_file{};  ///< blocks are in this file, in place of a cut
  std::optional<JointSetCut> joint_sets{};   ///< cut by them, in place of Voronoi cells
  std::vector<JointPlane> natural_joints{};  ///< the planes in rock.planes with their joint class
  /// Their planes follow once the box of the rock is known: lay_natural_joint_sets().
  std::vector<NaturalJointSet> natural_joint_sets{};
  std::vector<Collar> collars{};        ///< one per hole of the table
  std::vector<RockSurface> surfaces{};  ///< see rock_surfaces.h
  MineFrame mine{};                     ///< that their files have
  double unit = 1.0;                    ///< that the files count in [m]
  bool unit_given = false;              ///< not to be doubted
  bool mine_files = false;              ///< there are some
  double burden = 0.0;                  ///< of the plan; 0: not told [m]
  bool burdens_wanted = false;          ///< of the holes, in the log or in a file
  RegionQuery region_alone{};           ///< without the surfaces
  double density = 0.0;                 ///< of the rock beside the zones [kg/m3]
  std::vector<RockZone> zones{};        ///< see lay_zones()
  ZoneModel model{};
  std::vector<Fault> faults{};
  std::vector<JointPlane> zone_joints{};  ///< borders of zones that are natural joints
  std::optional<MuckSource> muck{};       ///< in front of the rock
  [[nodiscard]] std::vector<double> densities() const;  ///< of the rock, then of the zones [kg/m3]
  SphereRule spheres{};
  bool round_walls = true;  ///< crushed zones have the stiffness of round holes (wall_facets.h)

  /// Rank 0 alone knows when and over which seeds the other cuts sweep.
  [[nodiscard]] bool is_plain_voronoi() const { return !target && !import_file && !joint_sets; }
};

/// Throws InputError where words contradict each other or one that is needed is missing, a value
/// is outside its range, or a file cannot be read. `memory` is the machine's [bytes]; it bounds the
/// number of blocks where the user does not.
[[nodiscard]] CutOptions cut_options(const ArgValues& args, std::size_t memory);

}  // namespace muckpile
