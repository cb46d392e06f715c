// SPDX-License-Identifier: GPL-2.0-or-later
// The sections of a run's page that show what was measured.
// Scope: see the header.
#include "page/page_measures.h"

#include <cmath>
#include <vector>

#include "page/figures_table.h"
#include "page/speed_chart.h"
#include "report/energy_audit.h"

namespace muckpile {
namespace {

using check::Json;

struct Picture {
  const char *file, *title, *caption;
};

const std::vector<Picture>& pictures_of_the_pile() {
  static const std::vector<Picture> pictures{
      {"profile.png", "Section",
       "Section through a hole, with equal scales; table in profile.csv."},
      {"crater.png", "Section",
       "Section through the charge; tables in crater.csv and, of the launch, launch.csv."},
      {"heap.png", "Section", "Section of the heap; table in heap.csv."},
      {"pile3d.png", "View", "The rock as it lies; the blue edges are the rock before the blast."},
      {"movement.png", "Movement",
       "From where to where the parts of the bench went; table in movement.csv."},
      {"dig.png", "Dig line", "Ore and waste at the end, and the dig line; table in dig.csv."},
      {"survey.png", "Survey", "Surface of the run less the surveyed one; table in survey.csv."},
      {"damage.png", "Broken joints",
       "Broken share of the joints around the charges; table in damage.csv."},
      {"cracks.png", "Cracks",
       "Broken joints around the charges, and which of them hang together with a hole; table in "
       "cracks.csv."},
      {"heights.png", "From above",
       "Heights of the pile and of the rock that stayed; table in heights.csv."},
      {"trough.png", "Power trough",
       "The valley between the rock that stands and the pile; table in trough.csv."},
      {"section.png", "Section along a line",
       "Rock and heights along the line; table in section.csv."},
      {"over.png", "Over a line", "What lies beyond the line, by distance; table in over.csv."},
  };
  return pictures;
}

const std::vector<NamedKey>& figures_of_the_pile() {
  static const std::vector<NamedKey> figures{
      {"blast_volume_m3", "Rock of the holes"},
      {"blast_specific_charge_kg_m3", "Explosive per rock of the holes"},
      {"front_row_throw_m", "Throw, rock of the first row"},
      {"last_row_throw_m", "Throw, rock of the last row"},
      {"hole_throw_least_m", "Throw, hole of the least"},
      {"hole_throw_most_m", "Throw, hole of the most"},
      {"moved_volume_m3", "Rock that was broken out"},
      {"pile_survey_swell", "Swell, survey from above"},
      {"cut_volume_m3", "Surface lower than before, volume"},
      {"fill_volume_m3", "Surface higher than before, volume"},
      {"trough_depth_m", "Power trough, mean depth"},
      {"trough_width_m", "Power trough, mean width"},
      {"end_to_inner_throw", "Throw, end holes over inner ones"},
      {"end_to_inner_moved", "Share moved, end holes over inner ones"},
      {"over_volume_m3", "Rock over the line"},
      {"backbreak_m", "Backbreak, largest"},
      {"backbreak_mean_m", "Backbreak, mean along the row"},
      {"toe_left_volume_m3", "Rock left in front of the last row"},
      {"dig_rock_t", "Rock within the dig line"},
      {"dig_dilution_fraction", "Dilution"},
      {"dig_ore_loss_t", "Ore loss"},
      {"dig_ore_loss_fraction", "Ore loss, share of the ore"},
      {"survey_run_above_m3", "Run higher than the survey"},
      {"survey_run_below_m3", "Run lower than the survey"},
      {"survey_rms_difference_m", "Run and survey, RMS of the vertical difference"},
      {"survey_rms_distance_m", "RMS of the distance from surface to surface"},
      {"largest_charge_within_8_ms_kg", "Explosive within 8 ms"}};
  return figures;
}

void add_pile(Html& page, const PageContent& run) {
  for (const Picture& picture : pictures_of_the_pile())
    add_picture(page, run, picture.file, picture.title, picture.caption);
  add_table(page, run, figures_of_the_pile());
}

void add_speeds(Html& page, const PageContent& run) {
  page.element("h2", "Velocities");
  add_picture(page, run, "face_velocity.png", "Face",
              "Velocity of the face over height; tables in face_velocity.csv and rows.csv.");
  add_table(page, run,
            {{"face_velocity_m_s", "Face, fastest tenth of its height"},
             {"face_velocity_mean_m_s", "Face, middle half of the charge"},
             {"burden_velocity_m_s", "Burden, momentum over mass"},
             {"fastest_block_m_s", "Fastest block"}});
  add_picture(page, run, "momentum.png", "Momentum",
              "What gave the rock its speed: wave, gas, joints, contacts; table in momentum.csv.");
  const std::string chart = speed_chart(run.folder.dump("history.csv"));
  if (chart.empty()) return;
  const auto frame = page.open("figure");
  {
    const auto wide = page.open("div", {{"class", "wide"}});
    page.raw(chart);
  }
  page.element("figcaption", "Speed of the fastest block [m/s]; from dump/history.csv.");
}

void add_waves(Html& page, const PageContent& run) {
  add_picture(page, run, "waves.png", "Waves", "Speed at gauges in the rock; table in waves.csv.");
  add_picture(page, run, "ppv.png", "",
              "Peak particle velocity at the gauges against scaled distance; table in ppv.csv.");
  if (find(run, "ppv_fit_n") == nullptr) return;
  add_table(page, run,
            {{"ppv_fit_K_m_s", "Fit, K"},
             {"ppv_fit_n", "Fit, exponent n"},
             {"ppv_fit_n_low", "n, lower end of its 95 % confidence"},
             {"ppv_fit_n_high", "n, upper end"}});
}

// Formulas of practice, and beside them what the run has.
void add_fly_rock(Html& page, const PageContent& run) {
  const Json* note = find(run, "formula_flyrock_note");
  if (note == nullptr || !note->is_string()) return;
  page.element("h2", "Fly rock, by formulas");
  page.element("p", in_words("", *note));
  add_table(page, run,
            {{"formula_face_burst_low_m", "Face burst, range, from"},
             {"formula_face_burst_high_m", "to"},
             {"formula_cratering_low_m", "Cratering, range, from"},
             {"formula_cratering_high_m", "to"},
             {"formula_gun_barrelling_low_m", "Gun-barrelling, range, from"},
             {"formula_gun_barrelling_high_m", "to"},
             {"formula_mckenzie_m", "McKenzie, largest range"},
             {"formula_clearance_m", "Largest of them times the factor of safety"},
             {"farthest_block_m", "Farthest block of this run"}});
}

void add_sizes(Html& page, const PageContent& run) {
  add_picture(page, run, "fragments.png", "Size of the rock",
              "Size curves of the broken-out rock; tables in sieve.csv, fragments.csv and "
              "fragments_list.csv.");
  add_picture(page, run, "boulders.png", "",
              "Boulders where they lie, seen from above; table in boulders.csv.");
  add_picture(page, run, "fines.png", "",
              "Fines by a law, which is no result of the simulation; table in fines.csv.");
  const auto pair = page.open("div", {{"class", "pair"}});
  add_table(page, run,
            {{"sieve_p20_m", "Sieve P20"},
             {"sieve_p50_m", "Sieve P50"},
             {"sieve_p80_m", "Sieve P80"},
             {"sieve_largest_m", "Largest, by sieve"},
             {"block_sieve_finest_m", "Finest block, by sieve"},
             {"block_sieve_coarsest_m", "Coarsest block, by sieve"},
             {"boulder_mass_fraction", "Mass in boulders"}});
  add_table(page, run,
            {{"rosin_rammler_x50_m", "Rosin-Rammler fit, x50"},
             {"rosin_rammler_x50_error_m", "Its standard error"},
             {"rosin_rammler_n", "Rosin-Rammler fit, n"},
             {"rosin_rammler_n_error", "Its standard error"},
             {"rosin_rammler_rms_fraction", "Rosin-Rammler fit, RMS of the mass passing"},
             {"swebrec_x50_m", "Swebrec fit, x50"},
             {"swebrec_x50_error_m", "Its standard error"},
             {"swebrec_b", "Swebrec fit, b"},
             {"swebrec_b_error", "Its standard error"},
             {"swebrec_rms_fraction", "Swebrec fit, RMS of the mass passing"},
             {"kuz_ram_x50_m", "Kuz-Ram (formula), x50"},
             {"kuz_ram_n", "Kuz-Ram (formula), n"},
             {"fines_law_mass_fraction", "Fines (law), share of the mass"}});
}

void add_energy(Html& page, const PageContent& run) {
  add_picture(page, run, "energy.png", "Energy",
              "Energies of the run over time, and where the explosive's energy is at its end.");
  const std::vector<AuditTerm> audit = energy_audit(run.folder);
  if (audit.empty()) return;
  const auto table = page.open("table");
  {
    const auto head = page.open("tr");
    for (const char* name : {"Energy of the explosive", "", "Share"}) page.element("th", name);
  }
  const auto add_row = [&](const AuditTerm& term) {
    constexpr double kRoundOff = 1e-9;  // of the explosive's energy
    const double kept = std::abs(term.share) < kRoundOff ? 0.0 : 1.0;
    const auto row = page.open("tr");
    page.element("td", term.label);
    page.element("td", in_words("_J", kept * term.energy), {{"class", "number"}});
    page.element("td", in_words("_share", kept * term.share), {{"class", "number"}});
  };
  for (const AuditTerm& term : audit) add_row(term);
  add_row(missing_of(audit));
}

}  // namespace

void add_measures(Html& page, const PageContent& run) {
  add_pile(page, run);
  add_speeds(page, run);
  add_waves(page, run);
  add_fly_rock(page, run);
  add_sizes(page, run);
  add_energy(page, run);
}

}  // namespace muckpile
