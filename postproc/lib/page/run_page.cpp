// SPDX-License-Identifier: GPL-2.0-or-later
// The page of a run.
// Scope: see the header.
#include "page/run_page.h"

#include <cmath>

#include "explosive/energy_audit.h"
#include "page/figures_table.h"
#include "page/html.h"
#include "page/page_measures.h"
#include "page/page_parts.h"
#include "page/page_style.h"
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

/// Of a share of energy that books miss.
bool closes(const Json& error) { return std::abs(error.get<double>()) <= kEnergyCloses; }

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
  const auto warn_of_energy = [&](const char* key, const std::string& what) {
    const Json* error = find(run, key);
    if (error != nullptr && error->is_number() && !closes(*error))
      warn(what + ": " + in_words("_fraction", *error) + " are missing, at most " +
           in_words("_fraction", kEnergyCloses) + " should be.");
  };
  warn_of_energy("energy_audit_error", "Audit of the explosive's energy");
  warn_of_energy("energy_balance_error_worst", "Balance of energy, of the largest energy seen");
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

void add_design(Html& page, const PageContent& run) {
  page.element("h2", "Design");
  add_picture(page, run, "plan.png", "", "Plan: holes, and the milliseconds at which they fire.");
  add_picture(page, run, "burden.png", "",
              "Burden of each hole along its charge; table in burden.csv.");
  add_rows(page, run.scene, provenance_keys());
}

/// Between which bounds the gas of the charges works, and what the books of its energy miss.
void add_gas_limits(Html& page, const PageContent& run) {
  for (const AuditTerm& term : energy_audit(run.folder)) {
    if (!(term.share > 0.0)) continue;
    if (term.key == "rock_heat")
      page.element("li", "Gas gave " + in_words("_share", term.share) +
                             " of the explosive's energy to the rock as heat, most of it by an "
                             "assumed grain of crushed rock: in a small bench the gas works twice "
                             "as much without (crushed_grain 0).");
    if (term.key == "vented")
      page.element("li", "Gas let into the open took " + in_words("_share", term.share) +
                             " of the explosive's energy with it: what it may push there is left "
                             "out, or ends with the voids that keep it.");
  }
  if (const Json* error = find(run, "energy_audit_error"); error != nullptr && closes(*error))
    page.element("li", "The audit of the explosive's energy misses " +
                           in_words("_fraction", *error) + " of it.");
}

void add_limits(Html& page, const PageContent& run) {
  page.element("h2", "What this page does not say");
  const auto list = page.open("ul");
  if (const Json* note = find(run, "still_note")) page.element("li", in_words("", *note));
  if (const Json* note = find(run, "kuz_ram_note"))
    page.element("li", "Kuz-Ram: " + in_words("", *note));
  if (const Json* note = find(run, "fines_law_note"))
    page.element("li", "Fines: " + in_words("", *note));
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
  add_gas_limits(page, run);
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

// Nothing where there is no word.
std::string word_before(const std::string& before, const std::string& word) {
  return word.empty() ? word : before + word;
}

void add_body(Html& page, const PageContent& run) {
  const auto body = page.open("body");
  const auto main = page.open("main");
  page.element("h1", title_of(run));
  page.element("p",
               "Muckpile" + word_before(" ", scene_value(run, "version")) +
                   word_before(", run ", scene_value(run, "run_id")),
               {{"class", "quiet"}});
  add_warnings(page, run);
  add_key_figures(page, run);
  add_measures(page, run);
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
