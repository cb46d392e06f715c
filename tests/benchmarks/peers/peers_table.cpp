// SPDX-License-Identifier: GPL-2.0-or-later
// Speeds of the codes that peers.sh compares, as a table for the page and as CSV.
// Scope: peers_table RAW OUT; RAW is a table of scene, code, law, particles, links, steps and CPU
// seconds with a row per round, of which the least time counts. Writes OUT/peers.csv and peers.md.
#include <algorithm>
#include <iostream>
#include <vector>

#include "../format.h"
#include "args/csv_table.h"

namespace muckpile::benchmark {
namespace {

struct Speed {
  std::string scene, code, law;
  double particles, links;
  double step;  // CPU time of one [s]
};

// In the order in which scenes and codes come first.
std::vector<Speed> least(const CsvTable& raw) {
  std::vector<Speed> all;
  const auto number = [&](std::size_t row, const char* name) {
    return raw.number(row, raw.column(name));
  };
  const auto word = [&](std::size_t row, const char* name) {
    return std::string(raw.word(row, raw.column(name)));
  };
  for (std::size_t row = 0; row < raw.rows(); ++row) {
    const Speed speed{word(row, "scene"),   word(row, "code"),
                      word(row, "law"),     number(row, "particles"),
                      number(row, "links"), number(row, "seconds") / number(row, "steps")};
    const auto same = std::ranges::find_if(all, [&](const Speed& other) {
      return other.scene == speed.scene && other.code == speed.code;
    });
    if (same == all.end())
      all.push_back(speed);
    else if (speed.step < same->step)
      *same = speed;
  }
  return all;
}

// Per particle and, where there are links, per link; "" where there is nothing to divide by.
std::vector<std::string> fields_of(const Speed& speed, const std::vector<Speed>& all) {
  const auto own = std::ranges::find_if(all, [&](const Speed& other) {
    return other.scene == speed.scene && other.code == "Muckpile";
  });
  const auto ratio = [](double value, double to) {
    return to > 0.0 ? formatted("%.2f", value / to) : std::string();
  };
  const auto per_particle = [](const Speed& s) { return s.step / s.particles; };
  const auto per_link = [](const Speed& s) { return s.links > 0.0 ? s.step / s.links : 0.0; };
  const bool has_own = own != all.end(), has_links = speed.links > 0.0;
  return {speed.scene,
          speed.code,
          speed.law,
          formatted("%.0f", speed.particles),
          formatted("%.0f", speed.links),
          formatted("%.0f", 1.0 / speed.step),
          formatted("%.3f", 1e6 * per_particle(speed)),
          has_own ? ratio(per_particle(speed), per_particle(*own)) : "",
          has_links ? formatted("%.0f", 1e9 * per_link(speed)) : "",
          has_links && has_own ? ratio(per_link(speed), per_link(*own)) : ""};
}

std::string joined(const std::vector<std::string>& fields, const std::string& between) {
  std::string text = fields.front();
  for (std::size_t k = 1; k < fields.size(); ++k) text += between + fields[k];
  return text;
}

void write_tables(const CsvTable& raw, const std::filesystem::path& out) {
  std::string csv =
      "scene,code,law,particles,links,steps_per_s,us_per_particle_step,over_muckpile,"
      "ns_per_link_step,over_muckpile_per_link\n";
  std::string page =
      "| scene | code | law | blocks, clumps or spheres | bonds or contacts | steps/s | us per "
      "block-step | over Muckpile | ns per bond- or contact-step | over Muckpile |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  const std::vector<Speed> all = least(raw);
  for (const Speed& speed : all) {
    const std::vector<std::string> fields = fields_of(speed, all);
    csv += joined(fields, ",") + "\n";
    page += "| " + joined(fields, " | ") + " |\n";
  }
  write_text(out / "peers.csv", csv);
  write_text(out / "peers.md", page);
}

}  // namespace
}  // namespace muckpile::benchmark

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " RAW OUT\n";
    return 2;
  }
  try {
    muckpile::benchmark::write_tables(muckpile::CsvTable::read(argv[1]), argv[2]);
  } catch (const std::exception& error) {
    std::cerr << "peers_table: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
