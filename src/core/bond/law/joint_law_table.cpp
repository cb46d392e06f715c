// SPDX-License-Identifier: GPL-2.0-or-later
// The laws of natural joints by name; the words of a joint class.
// Scope: see the header.
#include "bond/law/joint_law_table.h"

#include <limits>
#include <map>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/suggestion.h"
#include "bond/law/barton_bandis.h"
#include "bond/law/coulomb.h"

namespace muckpile {
namespace {

constexpr const char* kClass = "joint_class";
constexpr std::size_t kHead = 3;  // N law NAME

std::string form() {
  return "'joint_class N law NAME keyword value ...', as in 'joint_class 1 law coulomb tension 0 "
         "cohesion 0 friction_angle 35 residual_friction_angle 30'";
}

const JointLawEntry& law_named(const std::string& where, const std::string& name) {
  std::vector<std::string> names;
  for (const JointLawEntry& entry : joint_law_entries()) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw InputError(where + ": law must be one of " + joined(names) + ", got '" + name + "'" +
                   did_you_mean(name, names));
}

/// The classes of one command.
class ClassReader {
 public:
  ClassReader(const ArgTable& style, const std::string& where,
              const std::vector<std::string>& words)
      : style_(style), where_(where), words_(words) {}

  JointClassWords read() {
    JointClassWords result;
    while (at_ < words_.size()) {
      if (words_[at_] != kClass) {
        result.others.push_back(words_[at_++]);
        continue;
      }
      ++at_;
      read_class(result.echo);
    }
    long expected = 1;
    for (const auto& [number, joint] : classes_) {
      if (number != expected)
        throw InputError(where_ + ": joint_class " + std::to_string(expected) +
                         " is missing before joint_class " + std::to_string(number));
      result.classes.push_back(joint);
      ++expected;
    }
    return result;
  }

 private:
  void read_class(std::string& echo) {
    constexpr double kMost = std::numeric_limits<std::uint8_t>::max();
    const bool complete = at_ + kHead <= words_.size();
    if (!complete || words_[at_ + 1] != "law") {
      std::string got;
      for (std::size_t k = at_; k < std::min(at_ + kHead, words_.size()); ++k)
        got += " " + words_[k];
      throw InputError(where_ + ": joint_class must be given as " + form() + ", got 'joint_class" +
                       got + "'");
    }
    const long number = parse_integer(where_, kClass, words_[at_], "", Range::closed(1.0, kMost));
    const std::string where = where_ + ": joint_class " + words_[at_];
    const JointLawEntry& law = law_named(where, words_[at_ + 2]);
    at_ += kHead;
    const ArgValues values = parse_args(law.table, where + " law " + law.name, take(law.table));
    if (!classes_.try_emplace(number, law.make(values, where)).second)
      throw InputError(where + " is given twice");
    echo += values.echo();
  }
  /// A word that neither law nor style knows is the law's, whose parser then tells what is wrong.
  std::vector<std::string> take(const ArgTable& law) {
    std::vector<std::string> mine;
    while (at_ < words_.size()) {
      const std::string& word = words_[at_];
      const bool known = law.find(word) != nullptr;
      if (!known && (word == kClass || style_.find(word) != nullptr)) break;
      mine.push_back(words_[at_++]);
      if (known && at_ < words_.size()) mine.push_back(words_[at_++]);
      if (!known) break;
    }
    return mine;
  }

  const ArgTable& style_;
  const std::string& where_;
  const std::vector<std::string>& words_;
  std::size_t at_ = 0;
  std::map<long, JointClass> classes_;
};

}  // namespace

const std::vector<JointLawEntry>& joint_law_entries() {
  static const std::vector<JointLawEntry> entries = {coulomb_entry(), barton_bandis_entry()};
  return entries;
}

ArgTable joint_class_table(const std::string& law) { return ArgTable("joint_class law " + law); }

double rigid_if_0(double stiffness) {
  return stiffness > 0.0 ? stiffness : std::numeric_limits<double>::infinity();
}

JointClassWords read_joint_classes(const ArgTable& style, const std::string& where,
                                   const std::vector<std::string>& words) {
  return ClassReader(style, where, words).read();
}

}  // namespace muckpile
