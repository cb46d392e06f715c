// SPDX-License-Identifier: GPL-2.0-or-later
// Run ids in lines and steps in names, written and read in one place.
// Scope: see the header.
#include "provenance/run_files.h"

#include <algorithm>
#include <charconv>

namespace muckpile {
namespace {

constexpr std::string_view kMark = "run=";
constexpr std::string_view kBefore = "blocks_", kTable = ".csv", kPacked = ".bin";
static_assert(kTable.size() == kPacked.size());
constexpr std::string_view kBlanks = " \t\r\n";

/// Names sort by step up to a thousand million steps.
std::string nine_digits(long long step) {
  constexpr std::size_t kDigits = 9;
  const std::string digits = std::to_string(step);
  return std::string(kDigits - std::min(kDigits, digits.size()), '0') + digits;
}

}  // namespace

bool is_run_id(std::string_view text) {
  constexpr std::size_t kDigits = 16;
  return text.size() == kDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string run_mark(std::string_view id) { return std::string(kMark).append(id); }

std::string run_id_in(std::string_view line) {
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    if (line.empty()) return {};
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    if (word.starts_with(kMark) && is_run_id(word.substr(kMark.size())))
      return std::string(word.substr(kMark.size()));
    line.remove_prefix(word.size());
  }
}

std::string snapshot_name(long long step, SnapshotForm form) {
  return std::string(kBefore) + nine_digits(step) +
         std::string(form == SnapshotForm::csv ? kTable : kPacked);
}

std::string impulses_name(long long step) { return "impulses_" + nine_digits(step) + ".csv"; }

SnapshotForm snapshot_form(std::string_view name) {
  return name.ends_with(kPacked) ? SnapshotForm::packed : SnapshotForm::csv;
}

long long snapshot_step(std::string_view name) {
  if (!name.starts_with(kBefore) || !(name.ends_with(kTable) || name.ends_with(kPacked))) return -1;
  if (name.size() < kBefore.size() + kTable.size()) return -1;
  const char* begin = name.data() + kBefore.size();
  const char* end = name.data() + name.size() - kTable.size();
  long long step = -1;
  const auto [stop, error] = std::from_chars(begin, end, step);
  return error == std::errc() && stop == end && step >= 0 ? step : -1;
}

}  // namespace muckpile
