// SPDX-License-Identifier: GPL-2.0-or-later
// check_figures: compares figures of runs with what is expected of them, for all scripts that test.
// Scope: command line only. Exit status 0 if all holds, 1 if a figure is wrong, 2 if one is missing
// or cannot be read. A FIGURE is a number, or FILE.json:QUANTITY, or FILE.csv:QUANTITY (last row;
// mean(QUANTITY) over all rows).
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "check_figures/burden_fit.h"
#include "check_figures/crater_depths.h"
#include "check_figures/exponents.h"
#include "check_figures/limit_charges.h"
#include "check_figures/near_field.h"
#include "figures/expected.h"
#include "figures/figures.h"

namespace {

using namespace muckpile;
using namespace muckpile::check;

struct Options {
  std::string name, figure, reference, table, summary, expected;
  std::vector<std::string> figures, files;
  std::vector<std::filesystem::path> folders;
  double bound = 0.0, times = 1.0, nearest = 0.0, farthest = 0.0, least = 0.0;
  std::vector<double> distances, pulse, rock;
  bool share = false;
  std::string at_least, at_most, above, below;
};

bool is_near(const Options& o) {
  const double value = figure(o.figure), reference = figure(o.reference);
  if (!(o.bound >= 0.0) || !std::isfinite(o.bound))
    refuse("near " + o.name, "the bound must be >= 0, got " + text_of(o.bound));
  if (o.share && reference == 0.0)
    refuse("near " + o.name, "the reference is 0, of which no share can be taken");
  const double off = (value - reference) / (o.share ? std::abs(reference) : 1.0);
  const bool holds = std::abs(off) <= o.bound;
  std::printf("%s: %s, should be %s, %s %.2g, allowed %s%s\n", o.name.c_str(),
              text_of(value).c_str(), text_of(reference).c_str(),
              o.share ? "relative difference" : "difference", off, text_of(o.bound).c_str(),
              holds ? "" : "  WRONG");
  return holds;
}

bool is_within(const Options& o) {
  if (o.at_least.empty() && o.at_most.empty() && o.above.empty() && o.below.empty())
    refuse("bounds " + o.name, "give one bound at least");
  const double value = figure(o.figure);
  bool all = true;
  const auto check = [&](const std::string& given, const char* rule, auto holds) {
    if (given.empty()) return;
    const double bound = figure(given) * o.times;
    const bool good = std::isfinite(bound) && holds(value, bound);
    std::printf("%s: %s, must be %s %s%s\n", o.name.c_str(), text_of(value).c_str(), rule,
                text_of(bound).c_str(), good ? "" : "  WRONG");
    all = all && good;
  };
  check(o.at_least, ">=", [](double a, double b) { return a >= b; });
  check(o.at_most, "<=", [](double a, double b) { return a <= b; });
  check(o.above, ">", [](double a, double b) { return a > b; });
  check(o.below, "<", [](double a, double b) { return a < b; });
  return all;
}

bool has_expected(const Options& o) {
  const Expected expected = read_expected(o.expected);
  const std::vector<FigureFile> files(o.files.begin(), o.files.end());
  return compare(expected, files);
}

void print_vars(const Options& o) {
  const Expected expected = read_expected(o.expected);
  if (!expected.vars) refuse(o.expected, "has no key 'vars'");
  std::printf("%s\n", expected.vars->c_str());
}

void print_figures(const Options& o) {
  std::string line;
  for (const std::string& words : o.figures)
    line += (line.empty() ? "" : " ") + text_of(figure(words));
  std::printf("%s\n", line.c_str());
}

void print_count(const Options& o) {
  const CsvTable table = CsvTable::read(o.table);
  const size_t column = table.column(o.name);
  int rows = 0;
  for (size_t row = 0; row < table.rows(); ++row)
    rows += table.number(row, column) >= o.least ? 1 : 0;
  std::printf("%d\n", rows);
}

void write_summary(const Options& o, const Json& figures) {
  std::ofstream out(o.summary);
  out << figures.dump(2) << '\n';
  if (!out.flush()) refuse(o.summary, "cannot be written");
}

std::optional<ElasticLoad> elastic_load(const Options& o) {
  if (o.pulse.empty()) return {};
  for (const double number : {o.pulse[0], o.pulse[1], o.pulse[2], o.rock[0], o.rock[1]})
    if (!(number > 0.0)) refuse("near_field", "--pulse and --rock must be > 0");
  return ElasticLoad{o.pulse[0], o.pulse[1], o.pulse[2], o.rock[0], o.rock[1], o.rock[2]};
}

/// The commands; each leaves in `holds` whether the figures are right.
void add_case_commands(CLI::App& app, Options& o, bool& holds) {
  CLI::App* expected =
      app.add_subcommand("case", "every row of EXPECTED, in the first file with it");
  expected->add_option("EXPECTED", o.expected, "expected.json of a case")->required();
  expected->add_option("FILE", o.files, "summary.json, history.csv")->required();
  expected->callback([&] { holds = has_expected(o); });
  CLI::App* vars = app.add_subcommand("vars", "print vars of EXPECTED, whose rows are checked too");
  vars->add_option("EXPECTED", o.expected, "expected.json of a case")->required();
  vars->callback([&] { print_vars(o); });
  CLI::App* fit = app.add_subcommand("burden_fit", "speed against burden: TABLE to SUMMARY");
  fit->add_option("TABLE", o.table, "a row per run (CSV)")->required();
  fit->add_option("SUMMARY", o.summary, "exponent and means (JSON)")->required();
  fit->callback([&] { write_summary(o, fit_burdens(o.table)); });
  CLI::App* depths = app.add_subcommand("crater_depths", "craters against depth: TABLE to SUMMARY");
  depths->add_option("TABLE", o.table, "a row per run (CSV)")->required();
  depths->add_option("SUMMARY", o.summary, "means beside rules (JSON)")->required();
  depths->callback([&] { write_summary(o, crater_depths(o.table)); });
  CLI::App* answers = app.add_subcommand("exponents", "answers to factors: TABLE to SUMMARY");
  answers->add_option("TABLE", o.table, "name, factor, value, base (CSV)")->required();
  answers->add_option("SUMMARY", o.summary, "exponent of each row (JSON)")->required();
  answers->callback([&] { write_summary(o, exponents(o.table)); });
  CLI::App* limits = app.add_subcommand("limit_charges", "charges that loosen: TABLE to SUMMARY");
  limits->add_option("TABLE", o.table, "burden, charge, throw (CSV)")->required();
  limits->add_option("SUMMARY", o.summary, "limits beside a law (JSON)")->required();
  limits->callback([&] { write_summary(o, limit_charges(o.table)); });
  CLI::App* field = app.add_subcommand("near_field", "peaks beside a law: FOLDERs to SUMMARY");
  field->add_option("SUMMARY", o.summary, "ratios and exponents (JSON)")->required();
  field->add_option("NEAREST", o.nearest, "gauge that counts [m]")->required();
  field->add_option("FARTHEST", o.farthest, "gauge that counts [m]")->required();
  field->add_option("FOLDER", o.folders, "of a run, with ppv.csv")->required();
  CLI::Option* pulse =
      field->add_option("--pulse", o.pulse, "peak [Pa], rise [s], radius [m]")->expected(3);
  field->add_option("--rock", o.rock, "density [kg/m3], modulus [Pa], Poisson's ratio")
      ->expected(3)
      ->needs(pulse);
  pulse->needs("--rock");
  field->callback(
      [&] { write_summary(o, near_field(o.folders, o.nearest, o.farthest, elastic_load(o))); });
  CLI::App* hole = app.add_subcommand("hole_vibration", "peaks around one hole: to SUMMARY");
  hole->add_option("SUMMARY", o.summary, "ratios and exponents (JSON)")->required();
  hole->add_option("FOLDER", o.folders, "of a run, with ppv.csv and dump/scene.json")->required();
  hole->add_option("--distances", o.distances, "ends of the ranges [m]")->required();
  hole->callback([&] { write_summary(o, hole_vibration(o.folders, o.distances)); });
}

void add_figure_commands(CLI::App& app, Options& o, bool& holds) {
  CLI::App* near = app.add_subcommand("near", "FIGURE is within BOUND of REFERENCE");
  near->add_option("NAME", o.name, "for the message")->required();
  near->add_option("FIGURE", o.figure)->required();
  near->add_option("REFERENCE", o.reference, "a figure")->required();
  near->add_option("BOUND", o.bound, "of the difference")->required();
  near->add_flag("--share", o.share, "BOUND is a share of REFERENCE");
  near->callback([&] { holds = is_near(o); });
  CLI::App* bounds = app.add_subcommand("bounds", "FIGURE keeps all bounds, which are figures too");
  bounds->add_option("NAME", o.name, "for the message")->required();
  bounds->add_option("FIGURE", o.figure)->required();
  bounds->add_option("--at-least", o.at_least);
  bounds->add_option("--at-most", o.at_most);
  bounds->add_option("--above", o.above);
  bounds->add_option("--below", o.below);
  bounds->add_option("--times", o.times, "factor of all bounds");
  bounds->callback([&] { holds = is_within(o); });
  CLI::App* finite = app.add_subcommand("finite", "every number of the files is finite");
  finite->add_option("FILE", o.files)->required();
  finite->callback([&] {
    for (const std::string& file : o.files) FigureFile(file).require_finite();
  });
  CLI::App* count = app.add_subcommand("count", "print how many rows have that much in a column");
  count->add_option("TABLE", o.table, "CSV")->required();
  count->add_option("COLUMN", o.name)->required();
  count->add_option("LEAST", o.least)->required();
  count->callback([&] { print_count(o); });
  CLI::App* print = app.add_subcommand("print", "the figures in one line");
  print->add_option("FIGURE", o.figures)->required();
  print->callback([&] { print_figures(o); });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares figures of runs with what is expected of them.");
  app.require_subcommand(1);
  Options options;
  bool holds = true;
  add_case_commands(app, options, holds);
  add_figure_commands(app, options, holds);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "check_figures: %s\n", error.what());
    return 2;
  }
  return holds ? 0 : 1;
}
