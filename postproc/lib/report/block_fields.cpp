// SPDX-License-Identifier: GPL-2.0-or-later
// What blocks can be coloured by.
// Scope: see the header; docs/muckpile-post.md lists the fields.
#include "report/block_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "explosive/hole_table.h"
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
      {"speed", "speed [m/s]", "speed_m_s", kFromZero,
       [](B, S s) { return s.velocity.norm(); }},
      {"vx", "velocity along the throw, x [m/s]", "vx_m_s", kSigned,
       [](B, S s) { return s.velocity.x(); }},
      {"vy", "velocity along y [m/s]", "vy_m_s", kSigned,
       [](B, S s) { return s.velocity.y(); }},
      {"vz", "velocity upwards [m/s]", "vz_m_s", kSigned,
       [](B, S s) { return s.velocity.z(); }},
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

// Level distance from a block to the axis of a charge at its height [m].
double level_distance(const Vec3& place, const Charge& charge) {
  const Vec3 along = charge.collar - charge.toe;
  const Vec2 axis = charge.toe.head<2>() +
                    (place.z() - charge.toe.z()) / along.z() * along.head<2>();
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

bool grows_from_zero(const std::string& field) {
  const SimpleField* const simple = simple_field(field);
  return simple != nullptr && simple->scale == FieldScale::kFromZero;
}

// Of the axis nearest to its start, at its own height, as of `rows`; by the names of the table.
BlockField BlockFields::holes() const {
  BlockField field{"hole nearest before the blast", "hole", FieldScale::kNames, {}, {}};
  const std::filesystem::path path = folder_.dump("holes.csv");
  const bool table = std::filesystem::exists(path);
  if (!table && charges_of_run(folder_).empty() && folder_.scene_word("case") != "bench")
    throw InputError("--colour hole: the run has neither holes.csv nor holes in run.json");
  const std::vector<Charge> charges = charges_of(folder_);
  std::vector<std::string> of_charge;
  if (table) {
    const HoleTable holes_of_run = HoleTable::read(path.string());
    for (const Deck& deck : holes_of_run.decks()) of_charge.push_back(deck.hole);
  }
  std::map<std::string, int> numbers;
  std::vector<int> number_of_charge;
  for (size_t k = 0; k < charges.size(); ++k) {
    const std::string name =
        of_charge.size() == charges.size() ? of_charge[k] : std::to_string(k + 1);
    const int number = numbers.emplace(name, static_cast<int>(numbers.size())).first->second;
    number_of_charge.push_back(number);
    field.names[number] = name;
  }
  for (const StartBlock& block : blocks_) {
    const auto nearest = std::ranges::min_element(
        charges, {}, [&](const Charge& c) { return level_distance(block.centroid, c); });
    field.values.push_back(number_of_charge[static_cast<size_t>(nearest - charges.begin())]);
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
  if (std::ranges::find(other_fields(), name) == other_fields().end()) {
    throw InputError("--colour: must be a field, got '" + name + "'" +
                     did_you_mean(name, field_names()) + " (fields: " + joined(field_names()) +
                     ")");
  }
  const auto known = of_run_.find(name);
  if (known != of_run_.end()) return known->second;
  return of_run_[name] = name == "hole"   ? holes()
                         : name == "zone" ? zones()
                                          : launch_speeds();
}

double BlockFields::largest(const std::string& name) const {
  double largest = 0.0;
  SnapshotReader reader(blocks_);
  for (const auto& path : folder_.snapshots())
    for (const double value : of(name, reader.read(path)).of_rock())
      largest = std::max(largest, value);
  return largest;
}

}  // namespace muckpile
