// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of verification reports as text.
// Scope: see the header.
#include "report_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "draw/axes.h"

namespace muckpile {
namespace {

std::string spelled_number(const Json& value, int digits) {
  return value.is_null() ? "" : spelled(value.get<double>(), digits);
}

/// Relative errors in per cent; an error whose reference is 0 is the value itself.
std::string spelled_error(const Json& row, const char* key) {
  if (row[key].is_null()) return "";
  const double value = row[key].get<double>();
  if (row["reference"].get<double>() == 0.0) return spelled(value, 2);
  return spelled(100.0 * value, 2) + " %";
}

/// A field of a CSV file; names of cases have commas.
std::string quoted(const Json& word) { return '"' + word.get<std::string>() + '"'; }

std::string figure_outside(const Json& row) {
  return row["case"].get<std::string>() + ", " + row["quantity"].get<std::string>() + ": " +
         spelled_error(row, "error") + " instead of " + spelled_error(row, "tolerance");
}

/// Several figures stand below the reason that they share, one before its own.
std::string with_reason(const std::vector<std::string>& figures, const std::string& reason) {
  if (figures.size() == 1) return "- " + figures[0] + (reason.empty() ? "" : "; " + reason) + "\n";
  std::string text = reason.empty() ? "" : "- " + reason + ":\n";
  for (const std::string& figure : figures)
    text += (reason.empty() ? "- " : "  - ") + figure + "\n";
  return text;
}

}  // namespace

std::string csv_of(const Json& rows) {
  std::string text = "case,quantity,value,unit,expected,error,allowed,within\n";
  for (const Json& row : rows) {
    const bool bound = !row["tolerance"].is_null();
    text += quoted(row["case"]) + "," + quoted(row["quantity"]) + "," +
            spelled_number(row["value"], 5) + "," + row["unit"].get<std::string>() + "," +
            (bound ? spelled_number(row["reference"], 5) : "") + "," +
            spelled_number(row["error"], 2) + "," + spelled_number(row["tolerance"], 2) + "," +
            (bound ? (row["pass"].get<bool>() ? "yes" : "no") : "") + "\n";
  }
  return text;
}

std::string case_row(const Json& rows, const std::string& text, const std::string& file) {
  int required = 0, passed = 0;
  double nearest = -1.0;
  std::string worst = "for information";
  for (const Json& row : rows) {
    if (row["tolerance"].is_null()) continue;
    ++required;
    passed += row["pass"].get<bool>() ? 1 : 0;
    const double share =
        std::abs(row["error"].get<double>()) / std::max(row["tolerance"].get<double>(), 1e-300);
    if (share <= nearest) continue;
    nearest = share;
    worst = spelled_error(row, "error") + " of " + spelled_error(row, "tolerance");
  }
  const std::string within =
      required == 0 ? "" : std::to_string(passed) + " of " + std::to_string(required);
  return "| [" + text + "](" + file + ") | " + within + " | " + worst + " |\n";
}

std::string not_met(const Json& rows) {
  std::vector<std::string> reasons;  // in the order of their first figures
  std::map<std::string, std::vector<std::string>> figures;
  for (const Json& row : rows) {
    if (row["pass"].get<bool>()) continue;
    const std::string reason = row.contains("note") ? row["note"].get<std::string>() : "";
    if (!figures.contains(reason)) reasons.push_back(reason);
    figures[reason].push_back(figure_outside(row));
  }
  std::string text;
  for (const std::string& reason : reasons) text += with_reason(figures[reason], reason);
  return text.empty() ? "All bounds are met.\n" : text;
}

}  // namespace muckpile
