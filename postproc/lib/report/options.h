// SPDX-License-Identifier: GPL-2.0-or-later
// What the user can choose for the measures and pictures, with the defaults.
// Scope: values only; tools/ fills them from the command line.
#pragma once

#include <array>
#include <optional>
#include <string>

namespace muckpile {

struct MeasureOptions {
  std::optional<double> least_move;  // a block that moved less stayed [m]; default: the run's mean
                                     // block size, 0 in a crater
  std::optional<double> cell;        // columns [m]; default: a quarter of the run's mean block size
};

struct FragmentOptions {
  std::optional<double> boulder;          // fragments of a larger sieve size are boulders [m]
  std::optional<double> rock_factor;      // A of Kuz-Ram; default: Lilly's index
  double mass_rating = 50.0;              // of Lilly's index: 10 powdery, 50 massive
  std::optional<double> weight_strength;  // RWS of Kuz-Ram, ANFO 100; default: by the energies
  double drilling_deviation = 0.0;        // of Kuz-Ram [m]
  std::optional<double> fines_radius;     // rock this near a charge is fines by a law [hole radii]
  double fines_top = 1e-3;                // 99 % of them are finer [m]
  double fines_exponent = 1.0;            // of their Rosin-Rammler curve
};

struct MovementOptions {
  int levels = 5;          // bands of height between the floor and the top of the bench
  int distances = 4;       // bands of distance between the face and the last row of holes
  std::string polygons;    // file of polygons to carry into the pile; "": none
  std::string model;       // file of a block model to carry into the pile; "": none
  std::string dig;         // file of polygons within which the pile is dug; "": none
  std::string ore_column;  // of the model; "": ore is what lies in the polygons
  double cutoff = 0.0;     // a cell with that much in the column is ore
  std::array<double, 3> shift{0.0, 0.0, 0.0};  // of both, before they are turned [m]
  double turn_deg = 0.0;                       // about the run's z axis, counter-clockwise
};

struct WavesOptions {
  std::string file = "gauges.csv";  // in dump/
  std::optional<double> until;  // peaks and pictures end there [s]; default: the first phase's end
};

struct FlyrockOptions {
  std::optional<double> site_constant;  // k of Richards & Moore; default: its usual range
  double launch_angle_deg = 80.0;       // of stemming, to the horizontal
  double safety_factor = 2.0;           // clearance over range
};

struct SurveyOptions {
  std::string surface;                         // file of the surveyed surface
  std::array<double, 3> shift{0.0, 0.0, 0.0};  // of the surface, before it is turned [m]
  double turn_deg = 0.0;                       // about the run's z axis, counter-clockwise
  double unit = 1.0;                           // of the file's numbers [m]
  std::optional<double> gap;                   // longest side of a triangle between points [m];
                                               // default: five times their spacing
};

struct SectionOptions {
  std::optional<double> y;  // of the section [m]; default: through a hole
  std::string colour_by = "start_height";  // one of field_names() (report/block_fields.h)
};

// A straight line in plan.
struct LineOptions {
  std::array<double, 2> from{0.0, 0.0}, to{0.0, 0.0};  // (x, y) [m]
  bool mine = false;            // the points are east and north of the mine
  std::optional<double> width;  // over which heights are averaged [m]; default: of one column
  std::string colour_by = "start_height";  // one of field_names() (report/block_fields.h)
};

struct TroughOptions {
  std::optional<double> strip;  // width of a section along y [m]; default: the spacing
};

struct PictureOptions {
  std::string colour_by = "start_height";  // one of field_names() (report/block_fields.h)
  std::optional<std::array<double, 2>> colour_range;  // default: that of the blocks
  int frames = 0;                   // pictures over the whole run beside the last one
  int mirror = 0;                   // reflected copies of a bench on each side of it
  int width = 1600;                 // [px]
  int height = 900;                 // [px]
  double azimuth = 55.0;            // of the eye, from the throw direction towards -y [deg]
  std::optional<double> elevation;  // of the eye above the floor [deg]; default: 28, of a crater 45
  double zoom = 1.0;                // the eye comes nearer by this factor
  std::optional<std::array<double, 3>> focus;  // middle of the picture [m]; default: of what it
                                               // is to show
  std::optional<double> section;  // rock in front of the plane at this y is cut away [m]
  std::string film;               // MP4 file of all frames; "": none
  int frames_per_second = 10;     // of the film
};

}  // namespace muckpile
