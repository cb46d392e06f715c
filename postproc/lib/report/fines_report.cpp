// SPDX-License-Identifier: GPL-2.0-or-later
// Fines by a law beside the simulated size curve.
// Scope: see the header.
#include "report/fines_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "draw/curve_plot.h"
#include "draw/png_file.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "measure/fines_law.h"
#include "report/notes.h"

namespace muckpile {
namespace {

// Of each charge [m]: of its deck in the hole table, else of the scene.
std::vector<ChargedHole> charged_holes(const ResultFolder& folder) {
  const bool has_table = std::filesystem::exists(folder.dump("holes.csv"));
  if (folder.scene_word("case") != "bench" && !has_table && charges_of_run(folder).empty())
    refuse("fragments: --fines", "the run has no charges");
  const std::vector<Charge> charges = charges_of(folder);
  std::vector<double> diameters;
  if (has_table) {
    const HoleTable table = hole_table_of(folder);
    for (const Deck& deck : table.decks()) diameters.push_back(deck.diameter);
  }
  if (diameters.size() != charges.size()) {
    if (!folder.scene_has("hole_diameter_m"))
      refuse("fragments: --fines", folder.dump("scene.json").string() + " has no hole_diameter_m");
    diameters.assign(charges.size(), folder.scene_number("hole_diameter_m"));
  }
  std::vector<ChargedHole> holes;
  for (size_t k = 0; k < charges.size(); ++k) holes.push_back({charges[k], 0.5 * diameters[k]});
  return holes;
}

// A pile's curve as it was simulated, and with the law's fines.
class PileWithFines {
 public:
  PileWithFines(const FinesLaw& law, const RunData& run, const CrushedRock& rock,
                const std::vector<Fragment>& fragments, const std::vector<double>& sieves)
      : law_(law) {
    std::map<int, double> crushed;  // of each fragment [kg]
    for (size_t b = 0; b < run.blocks.size(); ++b)
      crushed[run.last.states[b].fragment] += rock.of_block[b];
    fines_ = rock.without_blocks;
    for (size_t k = 0; k < fragments.size(); ++k) {
      if (!fragments[k].in_pile) continue;
      const double taken = crushed[fragments[k].id];
      whole_.push_back({sieves[k], fragments[k].mass});
      left_.push_back({sieves[k], fragments[k].mass - taken});
      fines_ += taken;
    }
    for (const Piece& piece : left_) mass_ += piece.mass;
    whole_curve_ = passing_curve(whole_);
    left_curve_ = passing_curve(left_);
  }
  [[nodiscard]] double fines() const { return fines_; }                     // [kg]
  [[nodiscard]] double share() const { return fines_ / (fines_ + mass_); }  // of all rock
  [[nodiscard]] double simulated(double size) const { return at(whole_curve_, size); }
  [[nodiscard]] double law(double size) const { return law_.passing(size); }
  [[nodiscard]] double both(double size) const {
    return share() * law(size) + (1.0 - share()) * at(left_curve_, size);
  }
  [[nodiscard]] double largest() const { return whole_curve_.back().size; }
  [[nodiscard]] bool empty() const { return whole_curve_.empty(); }

 private:
  static double at(const std::vector<SizePoint>& curve, double size) {
    const auto above = std::ranges::upper_bound(curve, size, {}, &SizePoint::size);
    return above == curve.begin() ? 0.0 : std::prev(above)->passing;
  }
  FinesLaw law_;
  std::vector<Piece> whole_, left_;
  double fines_ = 0.0, mass_ = 0.0;
  std::vector<SizePoint> whole_curve_, left_curve_;
};

// Sixteen to a decade, from a hundredth of the top size of the fines on.
std::vector<double> sizes_of(const PileWithFines& pile, const FinesLaw& law) {
  constexpr double kStep = 1.0 / 16.0;
  std::vector<double> sizes;
  const double first = std::floor(std::log10(0.01 * law.top));
  for (int k = 0; sizes.empty() || sizes.back() < pile.largest(); ++k)
    sizes.push_back(std::pow(10.0, first + kStep * k));
  return sizes;
}

CurvePlot plot_of(const PileWithFines& pile, const FinesLaw& law,
                  const std::vector<double>& sizes) {
  constexpr double kLeastShare = 0.01;  // that is drawn [%]
  CurvePlot plot;
  plot.title = "Fines by a law (dashed), not simulated";
  plot.x_label = "size [m]";
  plot.y_label = "mass passing [%]";
  plot.x_scale = Scale::kLogarithmic;
  plot.y_scale = Scale::kLogarithmic;  // shares of fines are small
  plot.y = AxisRange{kLeastShare, 100.0};
  PlotCurve simulated{"fragments by sieve, simulated", CurveStyle::kLine, 0, {}};
  PlotCurve both{"with the fines of the law", CurveStyle::kDashed, 1, {}};
  PlotCurve fines{"fines of the law: rock within " + spelled(law.radius) + " hole radii, " +
                      spelled(100.0 * pile.share(), 2) + " % of the mass",
                  CurveStyle::kDashed,
                  2,
                  {}};
  for (const double size : sizes) {
    for (const auto& [curve, share] :
         {std::pair(&simulated, pile.simulated(size)), std::pair(&both, pile.both(size)),
          std::pair(&fines, pile.share() * pile.law(size))})
      if (100.0 * share >= kLeastShare) curve->points.emplace_back(size, 100.0 * share);
  }
  plot.curves = {simulated, both, fines};
  return plot;
}

void take_back_fines(const ResultFolder& folder) {
  for (const char* name : {"fines.csv", "fines.png"}) std::filesystem::remove(folder.file(name));
}

}  // namespace

const std::vector<std::string>& fines_keys() {
  static const std::vector<std::string> keys{"fines_law_mass_kg",
                                             "fines_law_mass_fraction",
                                             "fines_law_without_blocks_kg",
                                             "fines_law_radius_hole_radii",
                                             "fines_law_top_m",
                                             "fines_law_exponent",
                                             "fines_law_note"};
  return keys;
}

nlohmann::ordered_json write_fines(const ResultFolder& folder, const RunData& run,
                                   const std::vector<Fragment>& fragments,
                                   const std::vector<double>& sieves,
                                   const FragmentOptions& options) {
  take_back_fines(folder);
  nlohmann::ordered_json keys = nlohmann::ordered_json::object();
  if (!options.fines_radius) return keys;
  const FinesLaw law{*options.fines_radius, options.fines_top, options.fines_exponent};
  const CrushedRock rock = crushed_rock(law, charged_holes(folder), run.blocks, run.moved);
  const PileWithFines pile(law, run, rock, fragments, sieves);
  if (pile.empty()) refuse("fragments: --fines", "no rock was broken out");
  const std::vector<double> sizes = sizes_of(pile, law);
  CsvWriter table(folder.file("fines.csv"),
                  "size_m,simulated_passing,fines_law_passing,with_fines_law_passing");
  for (const double size : sizes)
    table.row({size, pile.simulated(size), pile.law(size), pile.both(size)});
  CurvePlot plot = plot_of(pile, law, sizes);
  plot.warning = motion_warning(run.still);
  write_png(draw_curves(plot), folder.file("fines.png"));
  keys["fines_law_mass_kg"] = pile.fines();
  keys["fines_law_mass_fraction"] = pile.share();
  keys["fines_law_without_blocks_kg"] = rock.without_blocks;
  keys["fines_law_radius_hole_radii"] = law.radius;
  keys["fines_law_top_m"] = law.top;
  keys["fines_law_exponent"] = law.exponent;
  keys["fines_law_note"] = kFinesLawNote;
  return keys;
}

}  // namespace muckpile
