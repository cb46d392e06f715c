// SPDX-License-Identifier: GPL-2.0-or-later
// From words to a wall and its contact law.
// Scope: see the header.
#include "wall/wall_options.h"

#include <cmath>
#include <utility>

#include "args/input_error.h"
#include "args/numbers.h"
#include "geometry/files/survey_file.h"
#include "geometry/surface/rock_body.h"
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

std::shared_ptr<const WallSurface> mesh_of(const ArgValues& args, const std::string& where) {
  MineFrame frame;
  frame.bearing = args.real("x_bearing") * M_PI / 180.0;
  for (const auto& words : args.groups("origin"))
    frame.origin = vector_of(words, 0, "origin", "m", where);
  SurveyedSurface survey = read_survey(args.word("mesh"), args.real("unit"));
  for (Vec3& point : survey.points) point = frame.to_run(point);
  for (StlTriangle& triangle : survey.triangles)
    for (Vec3& corner : triangle) corner = frame.to_run(corner);
  std::vector<StlTriangle> triangles =
      survey.triangles.empty() ? terrain_triangles(survey) : std::move(survey.triangles);
  if (triangles.empty())
    refuse(where, "mesh must have triangles, or points that do not lie on one line in plan");
  return std::make_shared<WallMesh>(std::move(triangles));
}

}  // namespace

ArgTable wall_table() {
  return ArgTable("fix muckpile/wall")
      .group("plane", 6, 6, false,
             "x y z of a point [m], and the normal out of the ground: a plane without end")
      .word("mesh", {}, "none",
            "file of triangles (.stl, faces of .dxf) whose normals look out of the ground, or of "
            "points of the ground (.xyz, .csv, .txt, .las, points of .dxf)")
      .group("origin", 3, 3, false,
             "x y z that the file has at 0 0 0 of the run [m], as `create_blocks`")
      .real("x_bearing", "deg", Range::closed(0.0, 360.0), 90.0,
            "that the x axis of the run looks to in the file, from north (y) over east (x)")
      .real("unit", "m", Range::closed(1e-4, 1e4), 1.0, "what the numbers of the file count in")
      .real("youngs_modulus", "Pa", Range::closed(0.0, 1e15), 0.0,
            "contact modulus of the ground; 0: that of the pair style")
      .real("restitution", "", Range::closed(0.0, 1.0), 0.0,
            "speed after over speed before a head-on impact; 0: that of the pair style")
      .real("friction", "", Range::closed(-1.0, 10.0), -1.0,
            "Coulomb friction coefficient; -1: that of the pair style")
      .real("rolling_friction", "", Range::closed(-1.0, 10.0), -1.0,
            "limit torque over radius times normal force; -1: that of the pair style");
}

ContactParameters WallOptions::parameters(ContactParameters rock) const {
  if (youngs_modulus > 0.0)
    rock.youngs_modulus = modulus_against(rock.youngs_modulus, youngs_modulus);
  if (restitution > 0.0) rock.restitution = restitution;
  if (friction >= 0.0) rock.friction = friction;
  if (rolling_friction >= 0.0) rock.rolling_friction = rolling_friction;
  return rock;
}

WallOptions wall_options(const ArgValues& args, const std::string& where) {
  const bool plane = !args.groups("plane").empty(), mesh = args.word("mesh") != "none";
  if (plane == mesh)
    refuse(where, std::string("needs one of plane and mesh, got ") + (plane ? "both" : "none"));
  for (const char* word : {"origin", "x_bearing", "unit"})
    if (plane && args.given(word))
      refuse(where, std::string(word) + " is about a mesh, got a plane");
  WallOptions options{plane ? plane_of(args.groups("plane").front(), where) : mesh_of(args, where),
                      args.real("youngs_modulus"), args.real("restitution"), args.real("friction"),
                      args.real("rolling_friction")};
  constexpr double kLeastModulus = 1e3, kLeastRestitution = 0.05;
  if (options.youngs_modulus > 0.0 && options.youngs_modulus < kLeastModulus)
    refuse(where, "youngs_modulus must be 0 or >= 1000 Pa, got '" +
                      number_text(options.youngs_modulus) + "'");
  if (options.restitution > 0.0 && options.restitution < kLeastRestitution)
    refuse(where,
           "restitution must be 0 or >= 0.05, got '" + number_text(options.restitution) + "'");
  if (options.friction < 0.0 && options.friction != -1.0)
    refuse(where, "friction must be -1 or >= 0, got '" + number_text(options.friction) + "'");
  if (options.rolling_friction < 0.0 && options.rolling_friction != -1.0)
    refuse(where, "rolling_friction must be -1 or >= 0, got '" +
                      number_text(options.rolling_friction) + "'");
  return options;
}

}  // namespace muckpile
