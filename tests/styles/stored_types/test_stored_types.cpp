// SPDX-License-Identifier: GPL-2.0-or-later
// Every type that restart files or messages hold is in stored_types.txt, as it is now: one that
// changes needs a new version, or a file of the program before would be read as something else.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "fixes/blocks/block_placement.h"
#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/blocks/fix_muckpile_shapes.h"
#include "fixes/blocks/fix_muckpile_sleep.h"
#include "fixes/contact/fix_muckpile_contact_history.h"
#include "fixes/contact/fix_muckpile_wall.h"
#include "fixes/explosive/fix_muckpile_blast.h"
#include "fixes/explosive/fix_muckpile_gas.h"
#include "fixes/joints/fix_muckpile_quiet.h"
#include "fixes/output/fix_muckpile_gauges.h"
#include "fixes/output/fix_muckpile_ledger.h"
#include "fixes/run/fix_muckpile_progress.h"
#include "fixes/run/fix_muckpile_timestep.h"

namespace muckpile {
namespace {

constexpr const char* kHeadsOwn = "stored_type";  // in the head of each part, before its version

template <class... Part>
StoredTypes types_in() {
  StoredTypes types;
  (Encoding<Part>::list(types), ...);
  return types;
}

/// Of all parts of restart files and all messages.
StoredTypes all_types() {
  return types_in<BlocksState, BlocksShare, PlacedBlock, NetworkTotals, QuietState, LedgerState,
                  SleepState, RestRecord, CrushedBed::State, JointGasState, BlockGas, BlastState,
                  StepState, ProgressState, ContactsState, ContactRecord, GaugesState, WallState,
                  WallContact, ShapesState>();
}

std::string line_of(const StoredType& type) {
  std::ostringstream line;
  line << type.name << ' ' << type.version << ' ' << type.size << ' ' << type.layout;
  return line.str();
}

/// Lines of the list by name.
std::map<std::string, std::string> listed() {
  std::map<std::string, std::string> lines;
  std::ifstream in(MUCKPILE_STORED_TYPES);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.front() != '#') lines[line.substr(0, line.find(' '))] = line;
  }
  return lines;
}

/// Names of all specialisations of Stored in the sources.
std::multiset<std::string> names_in_sources() {
  std::multiset<std::string> names;
  const std::regex specialised(
      "struct Stored<[^>]*>+ \\{\\s*static constexpr std::string_view kName = \"([^\"]*)\"");
  for (const char* folder : {"/src/core", "/fixes"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::string(MUCKPILE_SOURCE) + folder)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      const std::string all = text.str();
      for (std::sregex_iterator found(all.begin(), all.end(), specialised), end; found != end;
           ++found)
        names.insert((*found)[1]);
    }
  }
  return names;
}

TEST(StoredTypes, AreAsTheListHasThem) {
  std::map<std::string, std::string> lines = listed();
  for (const StoredType& type : all_types()) {
    EXPECT_EQ(lines[type.name], line_of(type))
        << "has '" << type.name << "' changed? Raise its kVersion and put this line into "
        << MUCKPILE_STORED_TYPES << ":\n"
        << line_of(type);
    lines.erase(type.name);
  }
  for (const auto& [name, line] : lines) ADD_FAILURE() << "no part holds it: " << line;
}

template <class Enum>
int value_of(Enum enumerator) {
  return static_cast<int>(enumerator);
}

/// The layout has an enumeration's size only. Another order of its values needs a new version of
/// the types that hold it: facet, facet_traces_image, step_settings.
TEST(StoredTypes, EnumerationsKeepTheirValues) {
  EXPECT_EQ(value_of(FacetKind::joint), 0);
  EXPECT_EQ(value_of(FacetKind::fixed), 1);
  EXPECT_EQ(value_of(FacetKind::mirror), 2);
  EXPECT_EQ(value_of(FacetState::intact), 0);
  EXPECT_EQ(value_of(FacetState::cracked), 1);
  EXPECT_EQ(value_of(FacetState::fading), 2);
  EXPECT_EQ(value_of(FacetState::retired), 3);
  EXPECT_EQ(value_of(Breaking::none), 0);
  EXPECT_EQ(value_of(Breaking::possible), 1);
}

TEST(StoredTypes, AreAllInTheListAndHaveNamesOfTheirOwn) {
  std::multiset<std::string> names = names_in_sources();
  EXPECT_EQ(names.erase(kHeadsOwn), 1u);
  for (const StoredType& type : all_types()) {
    EXPECT_EQ(names.count(type.name), 1u) << type.name << ": one specialisation of Stored";
    names.erase(type.name);
  }
  for (const std::string& name : names)
    ADD_FAILURE() << "'" << name << "' is stored, but in no part that all_types() names";
}

}  // namespace
}  // namespace muckpile
