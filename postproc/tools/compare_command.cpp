// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command compare of muckpile-post.
// Scope: see the header.
#include "compare_command.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "command_words.h"
#include "compare/comparison.h"
#include "compare/inputs_apart.h"

namespace muckpile {
namespace {

struct CompareWords {
  std::string a, b, expected, csv;
  std::vector<std::string> tolerances, ignored;
  Tolerance general;
  bool all = false;
};

std::string number_or_blank(const std::optional<double>& number) {
  return number ? check::text_of(*number) : std::string();
}

void print(const ComparedQuantity& row) {
  std::printf("%-34s %20s %20s", row.name.c_str(), row.a.c_str(), row.b.c_str());
  if (row.difference) std::printf("  difference %.4g, allowed %.4g", *row.difference, *row.allowed);
  if (!row.place.empty()) std::printf(", at %s", row.place.c_str());
  std::printf("%s\n", row.same ? "" : "  DIFFERS");
}

void write_csv(const std::string& path, const std::vector<ComparedQuantity>& rows) {
  std::ofstream out(path);
  out << "quantity,a,b,difference,allowed,place,same\n";
  for (const ComparedQuantity& row : rows) {
    std::string line = row.name;
    for (std::string field :
         {row.a, row.b, number_or_blank(row.difference), number_or_blank(row.allowed), row.place}) {
      std::ranges::replace(field, ',', ';');  // our tables have no quotes
      line += "," + field;
    }
    out << line << (row.same ? ",1\n" : ",0\n");
  }
  if (!out.flush()) refuse(path, "cannot be written");
}

// Whether they are the same.
bool compare(const CompareWords& words) {
  CompareOptions options{words.general, {}, {}, words.ignored};
  for (const std::string& each : words.tolerances) options.named.insert(parse_tolerance(each));
  if (!words.expected.empty()) options.of_the_case = tolerances_of_case(words.expected);
  const std::vector<ComparedQuantity> rows =
      compare_runs(read_run_figures(words.a), read_run_figures(words.b), options);
  const auto differing = std::ranges::count(rows, false, &ComparedQuantity::same);
  if (words.all || differing > 0)
    std::printf("%-34s %20s %20s\n", "quantity", words.a.c_str(), words.b.c_str());
  for (const ComparedQuantity& row : rows) {
    if (words.all || !row.same) print(row);
  }
  if (!words.csv.empty()) write_csv(words.csv, rows);
  std::printf("%zu quantities, %td differ\n", rows.size(), differing);
  const std::vector<std::string> apart = inputs_apart(words.a, words.b);
  if (!apart.empty()) std::printf("the inputs differ: %s\n", joined(apart, "; ").c_str());
  return differing == 0;
}

int status_of(const CompareWords& words) {
  try {
    return compare(words) ? 0 : 1;
  } catch (const std::exception& error) {
    tell(error);
    return 2;
  }
}

}  // namespace

void add_compare_command(CLI::App& app, int& status) {
  const auto words = std::make_shared<CompareWords>();
  CLI::App* command = app.add_subcommand(
      "compare",
      "whether two runs have the same summary and tables within tolerances; exit status 0 if so, "
      "1 if not, 2 if a file cannot be read");
  command->add_option("A", words->a, "result folder or summary.json: the reference")->required();
  command->add_option("B", words->b, "the other")->required();
  command
      ->add_option("--relative", words->general.relative,
                   "allowed difference as a share of A's value; of a column, of its largest")
      ->check(at_least_zero());
  command
      ->add_option("--absolute", words->general.absolute,
                   "allowed difference in the quantity's unit; the larger of the two counts")
      ->check(at_least_zero());
  command->add_option("--tolerance", words->tolerances,
                      "KEY=RELATIVE or KEY=RELATIVE,ABSOLUTE for one key, table (profile.csv) or "
                      "column (profile.csv:pile_mean_m)");
  command->add_option("--expected", words->expected,
                      "expected.json of a case, whose tolerances hold for its quantities");
  command->add_option("--ignore", words->ignored, "keys, tables or columns to leave out");
  command->add_option("--csv", words->csv, "write the table of differences to this file, too");
  command->add_flag("--all", words->all, "show the rows that are the same, too");
  command->callback([words, &status] { status = status_of(*words); });
}

}  // namespace muckpile
