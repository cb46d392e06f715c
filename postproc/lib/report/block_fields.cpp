// SPDX-License-Identifier: GPL-2.0-or-later
// What blocks can be coloured by.
// Scope: see the header; docs/post/README.md lists the fields.
#include "report/block_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "io/charges.h"
#include "io/muck.h"
#include "io/snapshot_reader.h"
#include "measure/scan_polygon.h"

namespace muckpile {
namespace {

// A field that one block and its state tell.
struct SimpleField {
  const char *name, *label, *column;
  FieldScale scale;
  double (*value)(const StartBlock&, const BlockState&);
};

using B = const StartBlock&;
using S = const BlockState&;

double turn_of(B, S s) {
  const double w = std::min(1.0, std::abs(s.rotation.w()));
  return 2.0 * std::acos(w) * 180.0 / std::numbers::pi;
}

const std::vector<SimpleField>& simple_fields() {
  using enum FieldScale;
  static const std::vector<SimpleField> fields{
      {"start_height", "height before the blast [m]", "start_height_m", kOrigin,
       [](B b, S) { return b.centroid.z(); }},
      {"start_depth", "distance behind x = 0 before the blast [m]", "start_depth_m", kOrigin,
       [](B b, S) { return -b.centroid.x(); }},
      {"start_side", "y before the blast [m]", "start_y_m", kOrigin,
       [](B b, S) { return b.centroid.y(); }},
      {"fragment", "one colour per fragment", "fragment_id", kNames,
       [](B, S s) { return static_cast<double>(s.fragment); }},
      {"id", "one colour per block", "id", kNames,
       [](B b, S) { return static_cast<double>(b.id); }},
      {"size", "block size [m]", "size_m", kAmount, [](B b, S) { return b.size; }},
      {"volume", "block volume [m³]", "volume_m3", kAmount, [](B b, S) { return b.volume; }},
      {"mass", "block mass [kg]", "mass_kg", kAmount, [](B b, S) { return b.mass; }},
      {"density", "density [kg/m³]", "density_kg_m3", kAmount,
       [](B b, S) { return b.mass / b.volume; }},
      {"on_free_face", "on a free face before the blast", "on_free_face", kNames,
       [](B b, S) { return b.on_free_face ? 1.0 : 0.0; }},
      {"x", "x [m]", "x_m", kAmount, [](B, S s) { return s.centre.x(); }},
      {"y", "y [m]", "y_m", kAmount, [](B, S s) { return s.centre.y(); }},
      {"z", "height [m]", "z_m", kAmount, [](B, S s) { return s.centre.z(); }},
      {"displacement", "displacement [m]", "displacement_m", kFromZero,
       [](B b, S s) { return (s.centre - b.centroid).norm(); }},
      {"moved_x", "displacement along the throw, x [m]", "moved_x_m", kSigned,
       [](B b, S s) { return s.centre.x() - b.centroid.x(); }},
      {"moved_y", "displacement along y [m]", "moved_y_m", kSigned,
       [](B b, S s) { return s.centre.y() - b.centroid.y(); }},
      {"moved_z", "displacement upwards [m]", "moved_z_m", kSigned,
       [](B b, S s) { return s.centre.z() - b.centroid.z(); }},
      {"turn", "turned since the start [°]", "turn_deg", kFromZero, turn_of},
      {"speed", "speed [m/s]", "speed_m_s", kFromZero, [](B, S s) { return s.velocity.norm(); }},
      {"vx", "velocity along the throw, x [m/s]", "vx_m_s", kSigned,
       [](B, S s) { return s.velocity.x(); }},
      {"vy", "velocity along y [m/s]", "vy_m_s", kSigned, [](B, S s) { return s.velocity.y(); }},
      {"vz", "velocity upwards [m/s]", "vz_m_s", kSigned, [](B, S s) { return s.velocity.z(); }},
      {"spin", "spin [rad/s]", "spin_rad_s", kFromZero, [](B, S s) { return s.spin.norm(); }},
      {"broken", "broken share of joint area", "broken_fraction", kShare,
       [](B, S s) { return s.broken_fraction; }},
  };
  return fields;
}

const std::vector<std::string>& other_fields() {
  static const std::vector<std::string> names{"fragment_size", "launch_speed", "hole", "zone"};
  return names;
}

const SimpleField* simple_field(const std::string& name) {
  const auto found = std::ranges::find_if(
      simple_fields(), [&](const SimpleField& field) { return name == field.name; });
  return found == simple_fields().end() ? nullptr : &*found;
}

// V^(1/3) of the fragment of each block [m].
BlockField fragment_sizes(const std::vector<StartBlock>& blocks, const Snapshot& snapshot) {
  BlockField field{"size of the fragment [m]", "fragment_size_m", FieldScale::kAmount, {}};
  std::map<int, double> volume;
  for (size_t b = 0; b < blocks.size(); ++b)
    volume[snapshot.states[b].fragment] += blocks[b].volume;
  for (const BlockState& state : snapshot.states)
    field.values.push_back(std::cbrt(volume[state.fragment]));
  return field;
}

struct NamedAxis {
  std::string name;
  Vec3 toe, collar;  // [m]
};

// Of the holes of the table, else of the charges of the run, which are numbered.
std::vector<NamedAxis> hole_axes(const ResultFolder& folder) {
  std::vector<NamedAxis> axes;
  if (std::filesystem::exists(folder.dump("holes.csv"))) {
    const HoleTable table = hole_table_of(folder);
    for (const Deck& deck : table.decks()) {
      const auto same = [&](const NamedAxis& axis) { return axis.name == deck.hole; };
      if (std::ranges::none_of(axes, same))
        axes.push_back({deck.hole, deck.hole_toe, deck.hole_collar});
    }
    return axes;
  }
  if (charges_of_run(folder).empty() && folder.scene_word("case") != "bench")
    throw InputError("--colour hole: the run has neither holes.csv nor holes in run.json");
  for (const Charge& charge : charges_of(folder))
    axes.push_back({std::to_string(axes.size() + 1), charge.toe, charge.collar});
  return axes;
}

// Level distance from a block to an axis at its height [m]; of a level axis, to its middle.
double level_distance(const Vec3& place, const NamedAxis& hole) {
  const Vec3 along = hole.collar - hole.toe;
  const double share = along.z() != 0.0 ? (place.z() - hole.toe.z()) / along.z() : 0.5;
  const Vec2 axis = (hole.toe + share * along).head<2>();
  return (place.head<2>() - axis).norm();
}

// "zone NAME ..." among the words that an input hands to create_blocks, in their order.
std::map<int, std::string> zone_names(const ResultFolder& folder) {
  std::map<int, std::string> names{{0, "beside the zones"}};
  std::istringstream words(folder.knob("plane_words"));
  for (std::string word, name; words >> word;)
    if (word == "zone" && words >> name) names.emplace(static_cast<int>(names.size()), name);
  return names;
}

}  // namespace

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const SimpleField& field : simple_fields()) names.emplace_back(field.name);
  names.insert(names.end(), other_fields().begin(), other_fields().end());
  return names;
}

std::string wrong_field(const std::string& name) {
  const std::vector<std::string> known = field_names();
  if (std::ranges::find(known, name) != known.end()) return {};
  return "must be a field, got '" + name + "'" + did_you_mean(name, known) +
         " (fields: " + joined(known) + ")";
}

// Of the axis nearest to its start, at its own height.
BlockField BlockFields::holes() const {
  BlockField field{"hole nearest before the blast", "hole", FieldScale::kNames, {}, {}};
  const std::vector<NamedAxis> axes = hole_axes(folder_);
  for (size_t k = 0; k < axes.size(); ++k) field.names[static_cast<int>(k)] = axes[k].name;
  for (const StartBlock& block : blocks_) {
    const auto nearest = std::ranges::min_element(
        axes, {}, [&](const NamedAxis& axis) { return level_distance(block.centroid, axis); });
    field.values.push_back(static_cast<double>(nearest - axes.begin()));
  }
  return field;
}

BlockField BlockFields::zones() const {
  BlockField field{"zone of rock", "zone", FieldScale::kNames, {}, zone_names(folder_)};
  for (const StartBlock& block : blocks_) {
    if (block.zone < 0)
      throw InputError("--colour zone: the run has no zones; blocks.vtk has no 'zone'");
    field.values.push_back(block.zone);
    field.names.emplace(block.zone, "zone " + std::to_string(block.zone));
  }
  return field;
}

// The largest speed over the snapshots.
BlockField BlockFields::launch_speeds() const {
  BlockField field{"largest speed over the snapshots [m/s]", "launch_speed_m_s",
                   FieldScale::kFromZero, std::vector<double>(blocks_.size(), 0.0)};
  SnapshotReader reader(blocks_);
  for (const auto& path : folder_.snapshots()) {
    const Snapshot& snapshot = reader.read(path);
    for (size_t b = 0; b < blocks_.size(); ++b)
      field.values[b] = std::max(field.values[b], snapshot.states[b].velocity.norm());
  }
  return field;
}

BlockField BlockFields::of(const std::string& name, const Snapshot& snapshot) const {
  BlockField field = find(name, snapshot);
  field.muck = blocks_.size() - rock_blocks(blocks_);
  return field;
}

BlockField BlockFields::find(const std::string& name, const Snapshot& snapshot) const {
  if (const SimpleField* const simple = simple_field(name)) {
    BlockField field{simple->label, simple->column, simple->scale, {}};
    field.values.reserve(blocks_.size());
    for (size_t b = 0; b < blocks_.size(); ++b)
      field.values.push_back(simple->value(blocks_[b], snapshot.states[b]));
    if (name == "on_free_face") field.names = {{0, "no"}, {1, "yes"}};
    return field;
  }
  if (name == "fragment_size") return fragment_sizes(blocks_, snapshot);
  if (const std::string wrong = wrong_field(name); !wrong.empty())
    throw InputError("--colour: " + wrong);
  const auto known = of_run_.find(name);
  if (known != of_run_.end()) return known->second;
  return of_run_[name] = name == "hole" ? holes() : name == "zone" ? zones() : launch_speeds();
}

std::optional<std::array<double, 2>> BlockFields::range_of_run(const std::string& name) const {
  using enum FieldScale;
  const FieldScale scale = of(name, start_snapshot(blocks_)).scale;
  if (scale == kOrigin || scale == kShare || scale == kNames || of_run_.contains(name))
    return std::nullopt;
  std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  SnapshotReader reader(blocks_);
  for (const auto& path : folder_.snapshots()) {
    const BlockField field = of(name, reader.read(path));
    const auto [low, high] = std::ranges::minmax(field.of_rock());
    range = {std::min(range[0], low), std::max(range[1], high)};
  }
  return range;
}

}  // namespace muckpile
