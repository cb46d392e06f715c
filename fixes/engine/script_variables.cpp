// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS' table of variables.
// Scope: see the header; how the private members are reached: engine/registry.cpp.
#include "fixes/engine/script_variables.h"

#include <input.h>
#include <lammps.h>
#include <variable.h>

#include <array>
#include <string_view>

#include "args/numbers.h"

namespace muckpile::engine {
namespace {

using LAMMPS_NS::Variable;

template <typename Tag, typename Tag::Type member>
struct Expose {
  friend typename Tag::Type private_member(Tag) { return member; }
};
template <typename Type_, int>
struct Member {
  using Type = Type_ Variable::*;
};
using Count = Member<int, 0>;
using Names = Member<char**, 1>;
using Styles = Member<int*, 2>;
using Places = Member<int*, 3>;
using Data = Member<char***, 4>;
Count::Type private_member(Count);
Names::Type private_member(Names);
Styles::Type private_member(Styles);
Places::Type private_member(Places);
Data::Type private_member(Data);
template struct Expose<Count, &Variable::nvar>;
template struct Expose<Names, &Variable::names>;
template struct Expose<Styles, &Variable::style>;
template struct Expose<Places, &Variable::which>;
template struct Expose<Data, &Variable::data>;

/// As LIGGGHTS 3.8 numbers them in variable.cpp; tests/styles/write_scene defines some of each.
enum Style { kIndex = 0, kString = 5, kEqual = 9, kAtom = 10 };

class Table {
 public:
  explicit Table(LAMMPS_NS::LAMMPS& lmp) : variables_(*lmp.input->variable) {}
  [[nodiscard]] int count() const { return variables_.*private_member(Count{}); }
  [[nodiscard]] std::string name(int k) const { return (variables_.*private_member(Names{}))[k]; }
  [[nodiscard]] int style(int k) const { return (variables_.*private_member(Styles{}))[k]; }
  [[nodiscard]] std::string text(int k) const {
    const int place = (variables_.*private_member(Places{}))[k];
    return (variables_.*private_member(Data{}))[k][place];
  }

 private:
  Variable& variables_;
};

}  // namespace

Knobs script_knobs(LAMMPS_NS::LAMMPS& lmp) {
  const Table table(lmp);
  Knobs knobs;
  for (int k = 0; k < table.count(); ++k) {
    Knob knob{table.name(k), std::nullopt};
    if (table.style(k) == kIndex) knob.value = table.text(k);
    knobs.push_back(std::move(knob));
  }
  return knobs;
}

std::vector<Definition> script_definitions(LAMMPS_NS::LAMMPS& lmp) {
  const Table table(lmp);
  std::vector<Definition> definitions;
  for (int k = 0; k < table.count(); ++k) {
    const int style = table.style(k);
    if (style == kIndex || style == kString || style == kEqual || style == kAtom)
      definitions.push_back({table.name(k), table.text(k)});
  }
  return definitions;
}

std::string knob_value(LAMMPS_NS::LAMMPS& lmp, const std::string& name) {
  for (const Knob& knob : script_knobs(lmp)) {
    if (knob.name == name && knob.value) return *knob.value;
  }
  return "";
}

void set_script_variable(LAMMPS_NS::LAMMPS& lmp, const std::string& name, double value) {
  std::array<std::string, 3> words{name, "string", number_text(value)};
  std::array<char*, 3> arg{words[0].data(), words[1].data(), words[2].data()};
  lmp.input->variable->set(3, arg.data());
}

}  // namespace muckpile::engine
