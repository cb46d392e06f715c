// SPDX-License-Identifier: GPL-2.0-or-later
// From words to a wall and its contact law.
// Scope: see the header.
#include "wall/wall_options.h"

#include <algorithm>
#include <utility>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/surface/mine_words.h"
#include "geometry/surface/surface_checks.h"
#include "wall/wall_law.h"
#include "wall/wall_mesh.h"
#include "wall/wall_plane.h"

namespace muckpile {
namespace {

constexpr double kFarthest = 1e7;  // [m]

Vec3 vector_of(const std::vector<std::string>& words, std::size_t first, const char* keyword,
               const char* unit, const std::string& where) {
  Vec3 v;
  for (int c = 0; c < 3; ++c) {
    v[c] = parse_real(where, keyword, words[first + static_cast<std::size_t>(c)], unit,
                      Range::closed(-kFarthest, kFarthest));
  }
  return v;
}

std::shared_ptr<const WallSurface> plane_of(const std::vector<std::string>& words,
                                            const std::string& where) {
  const Vec3 normal = vector_of(words, 3, "plane", "", where);
  if (normal.norm() == 0.0)
    refuse(where, "plane needs a point and a normal of some length, got the normal 0 0 0");
  return std::make_shared<WallPlane>(vector_of(words, 0, "plane", "m", where), normal);
}

/// What readers of files say does not name the style.
std::vector<StlTriangle> triangles_of(const std::string& file, const MineWords& mine,
                                      const std::string& where) {
  try {
    SurveyedSurface survey = read_placed(file, mine.frame, mine.unit);
    return survey.triangles.empty() ? terrain_triangles(survey) : std::move(survey.triangles);
  } catch (const InputError& error) {
    refuse(where, error.what());
  }
}

/// The box as it may become while rock flies.
WallBox grown(WallBox box) {
  // Diagonals of the box, and as far as rock flies at 100 m/s; mine coordinates are farther off.
  constexpr double kFlight = 10.0, kFarthestFlight = 1000.0;  // [-], [m]
  const double way = std::min(kFlight * (box.hi - box.lo).norm(), kFarthestFlight);
  for (int c = 0; c < 3; ++c) {
    if (box.lo_follows[static_cast<std::size_t>(c)]) box.lo[c] -= way;
    if (box.hi_follows[static_cast<std::size_t>(c)]) box.hi[c] += way;
  }
  return box;
}

bool reaches(const SurfaceIndex& mesh, const WallBox& box) {
  return (mesh.lo().array() <= box.hi.array()).all() && (mesh.hi().array() >= box.lo.array()).all();
}

void check_mesh(const SurfaceIndex& mesh, bool unit_given, const WallBox& box,
                const std::string& where) {
  const std::string word = "simulation box";
  if (!unit_given) require_likely_unit(mesh.lo(), mesh.hi(), true, box.lo, box.hi, where, word, "");
  if (!reaches(mesh, grown(box)))
    require_at_box(mesh.lo(), mesh.hi(), box.lo, box.hi, where,
                   "no block can touch it; make the box so large that it reaches there, if blocks "
                   "do",
                   word);
  require_turned_alike(mesh.triangles(), where, "ground");
}

std::string describe(const SurfaceIndex& mesh) {
  return std::to_string(mesh.triangles().size()) + " triangles of " + rounded_text(mesh.area()) +
         " m2 " + extent_text(mesh.lo(), mesh.hi()) + ", " +
         rounded_text(1e-6 * static_cast<double>(mesh.bytes()), 3) + " MB on each rank";
}

/// Sets the surface and what is told of it.
void read_mesh(WallOptions& options, const ArgValues& args, const WallBox& box,
               const std::string& where) {
  const std::string& file = args.word("mesh");
  const std::string of_file = where + ": mesh " + file;
  const MineWords mine = read_mine_words(args, where);
  std::vector<StlTriangle> triangles = triangles_of(file, mine, where);
  if (triangles.empty())
    refuse(of_file, "must have triangles, or points that do not lie on one line in plan");
  const std::size_t doubled = leave_out_doubled(triangles, of_file);
  const auto mesh = std::make_shared<const WallMesh>(std::move(triangles));
  check_mesh(mesh->surface(), mine.unit_given, box, of_file);
  options.surface = mesh;
  options.told = of_file + ": " + describe(mesh->surface()) + '\n';
  if (doubled > 0)
    options.told += of_file + ": " + std::to_string(doubled) +
                    " triangles that are there twice have been left out\n";
}

void check_law(const WallOptions& options, const std::string& where) {
  constexpr double kLeastModulus = 1e3, kLeastRestitution = 0.05;
  const auto demand = [&](bool holds, const char* rule, double value) {
    if (!holds) refuse(where, std::string(rule) + ", got '" + number_text(value) + "'");
  };
  demand(options.youngs_modulus == 0.0 || options.youngs_modulus >= kLeastModulus,
         "youngs_modulus must be 0 or >= 1000 Pa", options.youngs_modulus);
  demand(options.restitution == 0.0 || options.restitution >= kLeastRestitution,
         "restitution must be 0 or >= 0.05", options.restitution);
  demand(options.friction >= 0.0 || options.friction == -1.0, "friction must be -1 or >= 0",
         options.friction);
  demand(options.rolling_friction >= 0.0 || options.rolling_friction == -1.0,
         "rolling_friction must be -1 or >= 0", options.rolling_friction);
}

}  // namespace

ArgTable wall_table() {
  return add_mine_words(
             ArgTable("fix muckpile/wall")
                 .group("plane", 6, 6, false,
                        "x y z of a point [m], and the normal out of the ground: a plane without "
                        "end")
                 .word("mesh", {}, "none",
                       "file of triangles (.stl, faces of .dxf) whose normals look out of the "
                       "ground, or of points of the ground (.xyz, .csv, .txt, .las, points of "
                       ".dxf)"),
             "files of `mesh`")
      .real("youngs_modulus", "Pa", Range::closed(0.0, 1e15), 0.0,
            "contact modulus of the ground; 0: that of the pair style")
      .real("restitution", "", Range::closed(0.0, 1.0), 0.0,
            "speed after over speed before a head-on impact; 0: that of the pair style")
      .real("friction", "", Range::closed(-1.0, 10.0), -1.0,
            "Coulomb friction coefficient; -1: that of the pair style")
      .real("rolling_friction", "", Range::closed(-1.0, 10.0), -1.0,
            "limit torque over radius times normal force; -1: that of the pair style")
      .flag("torsion", false, "spin about the normal of the wall is resisted as rolling is");
}

ContactParameters WallOptions::parameters(ContactParameters rock) const {
  if (youngs_modulus > 0.0)
    rock.youngs_modulus = modulus_against(rock.youngs_modulus, youngs_modulus);
  if (restitution > 0.0) rock.restitution = restitution;
  if (friction >= 0.0) rock.friction = friction;
  if (rolling_friction >= 0.0) rock.rolling_friction = rolling_friction;
  return rock;
}

WallOptions wall_options(const ArgValues& args, const WallBox& box, const std::string& where) {
  const bool plane = !args.groups("plane").empty(), mesh = args.word("mesh") != "none";
  if (plane == mesh)
    refuse(where, std::string("needs one of plane and mesh, got ") + (plane ? "both" : "none"));
  for (const char* word : {"origin", "x_bearing", "unit"})
    if (plane && args.given(word))
      refuse(where, std::string(word) + " is about a mesh, got a plane");
  WallOptions options;
  options.youngs_modulus = args.real("youngs_modulus");
  options.restitution = args.real("restitution");
  options.friction = args.real("friction");
  options.rolling_friction = args.real("rolling_friction");
  options.torsion = args.flag("torsion");
  check_law(options, where);
  if (plane)
    options.surface = plane_of(args.groups("plane").front(), where);
  else
    read_mesh(options, args, box, where);
  return options;
}

}  // namespace muckpile
