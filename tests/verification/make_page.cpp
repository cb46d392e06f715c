// SPDX-License-Identifier: GPL-2.0-or-later
// Joins the reports of all cases of a folder: summary.json, one PNG per plot, the page of tables.
// Scope: make_page RESULTS [TEMPLATE PAGE]; RESULTS/cases holds the reports, pictures go to images/
// beside the page. In the template a line {{case NAME TEXT}} becomes one row that sums up the rows
// of all reports whose name begins with NAME and links to them as NAME.csv in a folder beside the
// page, {{plot NAME}} the picture, {{summary}} the count of rows, {{not_met}} those outside their
// bounds, {{file NAME}} the text of RESULTS/NAME. A report may say that it was skipped, and why,
// instead of having rows; the plots that begin with its name are then left out.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/result_folder.h"
#include "report_rows.h"

namespace muckpile {
namespace {

namespace fs = std::filesystem;

std::vector<Json> read_reports(const fs::path& folder) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.insert(entry.path());
  }
  std::vector<Json> reports;
  for (const fs::path& file : files) reports.push_back(read_json_object(file));
  if (reports.empty()) throw std::runtime_error(folder.string() + ": holds no reports");
  return reports;
}

Json all_rows(const std::vector<Json>& reports, const std::string& prefix) {
  Json rows = Json::array();
  for (const Json& report : reports) {
    if (!report["report"].get<std::string>().starts_with(prefix)) continue;
    for (const Json& row : report["rows"]) rows.push_back(row);
  }
  return rows;
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream out(path);
  out << text;
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
}

Scale scale_of(const Json& word) {
  return word == "logarithmic" ? Scale::kLogarithmic : Scale::kStraight;
}

PlotCurve curve_of(const Json& from) {
  PlotCurve curve;
  curve.label = from["label"];
  curve.style = from["style"] == "line"     ? CurveStyle::kLine
                : from["style"] == "dashed" ? CurveStyle::kDashed
                                            : CurveStyle::kPoints;
  curve.colour = from["colour"];
  for (const Json& p : from["points"]) curve.points.emplace_back(p[0], p[1]);
  return curve;
}

std::map<std::string, CurvePlot> collect_plots(const std::vector<Json>& reports) {
  std::map<std::string, CurvePlot> plots;
  for (const Json& report : reports) {
    for (const Json& curve : report["curves"]) {
      CurvePlot& plot = plots[curve["plot"]];
      plot.title = curve["title"];
      plot.x_label = curve["x_label"];
      plot.y_label = curve["y_label"];
      plot.x_scale = scale_of(curve["x_scale"]);
      plot.y_scale = scale_of(curve["y_scale"]);
      plot.curves.push_back(curve_of(curve));
    }
  }
  return plots;
}

/// Why reports whose name begins with `prefix` have no rows, if they say so.
std::string why_skipped(const std::vector<Json>& reports, const std::string& prefix) {
  for (const Json& report : reports) {
    if (report.contains("skipped") && report["report"].get<std::string>().starts_with(prefix))
      return "not run: " + report["skipped"].get<std::string>();
  }
  return "";
}

/// Rows that a report must have unless it says why not.
Json rows_of(const std::vector<Json>& reports, const std::string& name) {
  Json rows = all_rows(reports, name);
  if (rows.empty() && why_skipped(reports, name).empty())
    throw std::runtime_error("no report has rows whose name begins with " + name);
  return rows;
}

std::string summary(const std::vector<Json>& reports) {
  int required = 0, passed = 0;
  double seconds = 0.0;
  for (const Json& report : reports) seconds += report["seconds"].get<double>();
  for (const Json& row : all_rows(reports, "")) {
    if (row["tolerance"].is_null()) continue;
    ++required;
    passed += row["pass"].get<bool>() ? 1 : 0;
  }
  return std::to_string(passed) + " of " + std::to_string(required) +
         " required figures are within their bounds; the programs ran " +
         std::to_string(std::lround(seconds)) + " s in all, on one core each.\n";
}

/// The words behind `keyword` of a line {{keyword words}}, or nothing.
std::string directive(const std::string& line, const std::string& keyword) {
  const std::string head = "{{" + keyword + " ";
  if (!line.starts_with(head) || !line.ends_with("}}")) return "";
  return line.substr(head.size(), line.size() - head.size() - 2);
}

std::ifstream opened(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
  return in;
}

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << opened(path).rdbuf();
  return text.str();
}

struct Source {
  fs::path results;
  fs::path target;  ///< the page; files of figures go into a folder of its name
  std::vector<Json> reports;
  std::map<std::string, CurvePlot> plots;
};

/// Writes the figures of a case; its row of the page.
std::string made_case(const Source& source, const std::string& words) {
  const std::size_t blank = words.find(' ');
  const std::string name = words.substr(0, blank), text = words.substr(blank + 1);
  const Json rows = rows_of(source.reports, name);
  if (rows.empty()) return "| " + text + " | | " + why_skipped(source.reports, name) + " |\n";
  const fs::path file = source.target.stem() / (name + ".csv");
  fs::create_directories(source.target.parent_path() / source.target.stem());
  write_text(source.target.parent_path() / file, csv_of(rows));
  return case_row(rows, text, file.string());
}

std::string page(const fs::path& form, const Source& source, const std::string& images) {
  const auto& [results, target, reports, plots] = source;
  std::ifstream in = opened(form);
  std::string text;
  for (std::string line; std::getline(in, line);) {
    if (const std::string plot = directive(line, "plot"); !plot.empty()) {
      if (!plots.contains(plot)) {
        if (!why_skipped(reports, plot.substr(0, plot.find('_'))).empty()) continue;
        throw std::runtime_error("no report has curves for " + line);
      }
      const fs::path picture = fs::path(images) / (plot + ".png");
      text += "![" + plots.at(plot).title + "](" + picture.string() + ")\n";
    } else if (const std::string file = directive(line, "file"); !file.empty()) {
      text += text_of(results / file);
    } else if (const std::string words = directive(line, "case"); !words.empty()) {
      text += made_case(source, words);
    } else if (line == "{{summary}}") {
      text += summary(reports);
    } else if (line == "{{not_met}}") {
      text += not_met(all_rows(reports, ""));
    } else {
      text += line + "\n";
    }
  }
  return text;
}

void make(int argc, char** argv) {
  Source source{argv[1], argc < 4 ? "" : argv[3], {}, {}};
  const fs::path& results = source.results;
  source.reports = read_reports(results / "cases");
  const Json rows = {{"rows", all_rows(source.reports, "")}};
  write_text(results / "summary.json", rows.dump(1) + "\n");
  source.plots = collect_plots(source.reports);
  for (const auto& [name, plot] : source.plots) {
    write_png(draw_curves(plot), results / (name + ".png"));
  }
  if (argc < 4) return;
  const fs::path& target = source.target;
  const fs::path images = fs::path("images") / target.stem();
  const std::string text = page(argv[2], source, images.string());
  fs::create_directories(target.parent_path() / images);
  for (const auto& [name, plot] : source.plots) {
    fs::copy_file(results / (name + ".png"), target.parent_path() / images / (name + ".png"),
                  fs::copy_options::overwrite_existing);
  }
  write_text(target, text);
}

}  // namespace
}  // namespace muckpile

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::fprintf(stderr, "usage: %s RESULTS [TEMPLATE PAGE]\n", argv[0]);
    return 2;
  }
  try {
    muckpile::make(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_page: %s\n", error.what());
    return 1;
  }
  return 0;
}
