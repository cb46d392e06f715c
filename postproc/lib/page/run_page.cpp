// SPDX-License-Identifier: GPL-2.0-or-later
// The page of a run.
// Scope: see the header.
#include "page/run_page.h"

#include <cmath>

#include "page/figures_table.h"
#include "page/html.h"
#include "page/page_parts.h"
#include "page/page_style.h"
#include "page/speed_chart.h"
#include "report/energy_audit.h"

namespace muckpile {
namespace {

using check::Json;

std::string title_of(const PageContent& run) {
  const std::string scene = run.folder.scene_word("case");
  std::string title = scene == "bench"    ? "Bench blast"
                      : scene == "crater" ? "Crater blast"
                      : scene == "heap"   ? "Heap of rock"
                                          : "Run";
  const char* separator = ": ";
  for (const auto& [key, name] :
       {std::pair("bench_height_m", "height "), std::pair("burden_m", "burden "),
        std::pair("spacing_m", "spacing "), std::pair("burial_depth_m", "burial depth "),
        std::pair("charge_mass_kg", "charge "), std::pair("explosive", "")}) {
    const std::string value = scene_value(run, key);
    if (value.empty()) continue;
    title += separator + (name + value);
    separator = ", ";
  }
  return title;
}

void add_warnings(Html& page, const PageContent& run) {
  const auto warn = [&](const std::string& text) {
    page.element("p", text, {{"class", "warning"}});
  };
  for (const char* key : {"still_note", "fragments_note"}) {
    if (const Json* note = find(run, key)) warn(in_words(key, *note));
  }
  for (const auto& [key, value] : run.summary.items()) {
    if (key.ends_with("_refused")) warn("Not measured: " + in_words(key, value));
  }
  const Json* inside = find(run, "blocks_in_solid");
  if (inside != nullptr && *inside != 0)
    warn(in_words("blocks_in_solid", *inside) +
         " blocks ended inside the floor or the solid rock.");
}

void add_key_figures(Html& page, const PageContent& run) {
  const auto list = page.open("dl", {{"class", "figures"}});
  for (const auto& [key, name] : key_figures()) {
    const Json* value = find(run, key);
    if (value == nullptr) continue;
    const auto box = page.open("div");
    page.element("dt", name);
    add_figure(page, "dd", key, *value);
  }
}

void add_pile(Html& page, const PageContent& run) {
  add_picture(page, run, "profile.png", "Section",
              "Section through a hole, with equal scales; table in profile.csv.");
  add_picture(page, run, "crater.png", "Section",
              "Section through the charge; table in crater.csv.");
  add_picture(page, run, "heap.png", "Section", "Section of the heap; table in heap.csv.");
  add_picture(page, run, "pile3d.png", "View",
              "The rock as it lies; the blue edges are the rock before the blast.");
  add_picture(page, run, "movement.png", "Movement",
              "From where to where the parts of the bench went; table in movement.csv.");
  add_picture(page, run, "survey.png", "Survey",
              "Surface of the run less the surveyed one; table in survey.csv.");
  add_picture(page, run, "damage.png", "Broken joints",
              "Broken share of the joints around the charges; table in damage.csv.");
  add_picture(page, run, "heights.png", "From above",
              "Heights of the pile and of the rock that stayed; table in heights.csv.");
  add_table(page, run,
            {{"blast_volume_m3", "Rock of the holes"},
             {"blast_specific_charge_kg_m3", "Explosive per rock of the holes"},
             {"front_row_throw_m", "Throw, rock of the first row"},
             {"last_row_throw_m", "Throw, rock of the last row"},
             {"hole_throw_least_m", "Throw, hole of the least"},
             {"hole_throw_most_m", "Throw, hole of the most"},
             {"moved_volume_m3", "Rock that was broken out"},
             {"pile_survey_swell", "Swell, survey from above"},
             {"backbreak_m", "Backbreak, largest"},
             {"backbreak_mean_m", "Backbreak, mean along the row"},
             {"toe_left_volume_m3", "Rock left in front of the last row"},
             {"survey_run_above_m3", "Run higher than the survey"},
             {"survey_run_below_m3", "Run lower than the survey"},
             {"survey_rms_difference_m", "Run and survey, RMS of the vertical difference"},
             {"largest_charge_within_8_ms_kg", "Explosive within 8 ms"}});
}

void add_speeds(Html& page, const PageContent& run) {
  page.element("h2", "Velocities");
  add_picture(page, run, "face_velocity.png", "Face",
              "Velocity of the face over height; tables in face_velocity.csv and rows.csv.");
  add_table(page, run,
            {{"face_velocity_m_s", "Face, fastest tenth of its height"},
             {"face_velocity_mean_m_s", "Face, middle half of the charge"},
             {"fastest_block_m_s", "Fastest block"}});
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
             {"rosin_rammler_n", "Rosin-Rammler fit, n"},
             {"rosin_rammler_rms_fraction", "Rosin-Rammler fit, RMS of the mass passing"},
             {"swebrec_x50_m", "Swebrec fit, x50"},
             {"swebrec_b", "Swebrec fit, b"},
             {"swebrec_rms_fraction", "Swebrec fit, RMS of the mass passing"},
             {"kuz_ram_x50_m", "Kuz-Ram (formula), x50"},
             {"kuz_ram_n", "Kuz-Ram (formula), n"}});
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
  constexpr double kRoundOff = 1e-9;  // of the explosive's energy
  for (const AuditTerm& term : audit) {
    const double kept = std::abs(term.share) < kRoundOff ? 0.0 : 1.0;
    const auto row = page.open("tr");
    page.element("td", term.label);
    page.element("td", in_words("_J", kept * term.energy), {{"class", "number"}});
    page.element("td", in_words("_share", kept * term.share), {{"class", "number"}});
  }
}

void add_design(Html& page, const PageContent& run) {
  page.element("h2", "Design");
  add_picture(page, run, "plan.png", "", "Plan: holes, and the milliseconds at which they fire.");
  add_rows(page, run.scene, provenance_keys());
}

void add_limits(Html& page, const PageContent& run) {
  page.element("h2", "What this page does not say");
  const auto list = page.open("ul");
  if (const Json* note = find(run, "still_note")) page.element("li", in_words("", *note));
  if (const Json* note = find(run, "kuz_ram_note"))
    page.element("li", "Kuz-Ram: " + in_words("", *note));
  if (const Json* note = find(run, "throw_max_note"))
    page.element("li", "Largest throw: " + in_words("", *note));
  if (const Json* note = find(run, "farthest_block_note"))
    page.element("li", "Farthest block: " + in_words("", *note));
  if (find(run, "face_velocity_m_s") != nullptr)
    page.element("li", "The face velocity is a lower bound: snapshots miss the peak.");
  page.element("li",
               "Block sizes are an input: nothing finer than a block is simulated, and only joints "
               "that held make larger pieces.");
  page.element("li", "One run of one seed: another seed gives another pile.");
  if (const Json* error = find(run, "energy_balance_error_worst"))
    page.element("li", "Energy that the books miss: at most " + in_words("_fraction", *error) +
                           " at any time.");
}

void add_provenance(Html& page, const PageContent& run) {
  page.element("h2", "Provenance");
  {
    const auto table = page.open("table");
    for (const auto& [key, value] : run.scene.items()) {
      if (key == "knobs" || (!provenance_keys().contains(key) && key != "seed")) continue;
      const auto row = page.open("tr");
      page.element("td", split_unit(key).name);
      const auto cell = page.open("td");
      page.element("code", value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
  const auto knobs = run.scene.find("knobs");
  if (knobs == run.scene.end() || !knobs->is_object()) return;
  const auto details = page.open("details");
  page.element("summary", "Knobs, as the run had them");
  const auto table = page.open("table");
  for (const auto& [key, value] : knobs->items()) {
    const auto row = page.open("tr");
    page.element("td", key);
    const auto cell = page.open("td");
    page.element("code", value.is_string() ? value.get<std::string>() : value.dump());
  }
}

void add_figure_rows(Html& page, const Json& object, const std::string& prefix) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      add_figure_rows(page, value, prefix + key + ".");
      continue;
    }
    const auto row = page.open("tr");
    {
      const auto cell = page.open("td");
      page.element("code", prefix + key);
    }
    add_figure(page, "td", prefix + key, value);
  }
}

void add_all_figures(Html& page, const PageContent& run) {
  const auto details = page.open("details");
  page.element("summary", "All figures of summary.json");
  const auto table = page.open("table");
  add_figure_rows(page, run.summary, "");
}

void add_head(Html& page, const PageContent& run) {
  const auto head = page.open("head");
  page.single("meta", {{"charset", "utf-8"}});
  page.single("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  // Nothing is fetched, whatever a text of the run holds.
  page.single("meta",
              {{"http-equiv", "Content-Security-Policy"},
               {"content", "default-src 'none'; img-src data:; style-src 'unsafe-inline'"}});
  page.element("title", title_of(run));
  page.raw(std::string("<style>") + kPageStyle + "</style>\n");
}

void add_body(Html& page, const PageContent& run) {
  const auto body = page.open("body");
  const auto main = page.open("main");
  page.element("h1", title_of(run));
  page.element("p",
               "Muckpile " + scene_value(run, "version") + ", run " + scene_value(run, "run_id"),
               {{"class", "quiet"}});
  add_warnings(page, run);
  add_key_figures(page, run);
  add_pile(page, run);
  add_speeds(page, run);
  add_waves(page, run);
  add_fly_rock(page, run);
  add_sizes(page, run);
  add_energy(page, run);
  add_design(page, run);
  add_limits(page, run);
  add_provenance(page, run);
  add_all_figures(page, run);
}

}  // namespace

std::string page_of(const ResultFolder& folder) {
  const PageContent run = page_content(folder);
  Html page;
  page.raw("<!DOCTYPE html>\n");
  {
    const auto html = page.open("html", {{"lang", "en"}});
    add_head(page, run);
    add_body(page, run);
  }
  return page.text();
}

}  // namespace muckpile
