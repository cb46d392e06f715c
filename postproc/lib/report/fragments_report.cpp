// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command fragments: size curves of the broken-out rock, fits to them, and a table of all
// fragments.
// Scope: by sieve size and by volume^(1/3); blocks are the finest pieces that the model knows.
#include <algorithm>
#include <cmath>
#include <map>

#include "draw/png_file.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "measure/sieve_size.h"
#include "parallel/in_parallel.h"
#include "report/boulders_plot.h"
#include "report/fines_report.h"
#include "report/fragments_plot.h"
#include "report/kuz_ram_of_run.h"
#include "report/notes.h"
#include "report/reports.h"
#include "report/run_data.h"

namespace muckpile {
namespace {

// A fragment of the pile with its sieve size; NaN for the rock that stayed, which no one sieves.
struct SizedFragment {
  Fragment fragment;
  double sieve;  // [m]
};

// Sieve sizes of the blocks that were broken out, NaN of the others.
std::vector<double> block_sieves(const RunData& run) {
  std::vector<double> sizes(run.blocks.size(), std::nan(""));
  each_in_parallel(run.blocks.size(), [&](size_t b) {
    if (run.moved[b] != 0) sizes[b] = sieve_size(run.blocks[b]);
  });
  return sizes;
}

// The blocks of each fragment, by its id.
std::map<int, std::vector<size_t>> members_of(const Snapshot& last) {
  std::map<int, std::vector<size_t>> members;
  for (size_t b = 0; b < last.states.size(); ++b) members[last.states[b].fragment].push_back(b);
  return members;
}

double sieve_of(const std::vector<size_t>& members, const RunData& run,
                const std::vector<double>& blocks) {
  constexpr int kOutline = 500, kStarts = 200;  // directions: widths within a hundredth or two
  static const std::vector<Vec3> starts = spread_directions(kStarts);
  if (members.size() == 1) return blocks[members.front()];
  std::vector<Vec3> points;
  for (const size_t b : members) {
    const std::vector<Vec3> corners = moved_vertices(run.blocks[b], run.last.states[b]);
    points.insert(points.end(), corners.begin(), corners.end());
  }
  return sieve_size(outermost(points, kOutline), starts);
}

std::vector<SizedFragment> sized_fragments(const RunData& run, const std::vector<double>& blocks) {
  const auto members = members_of(run.last);
  std::vector<SizedFragment> sized;
  for (const Fragment& f : fragments_of(run.blocks, run.last, run.moved))
    sized.push_back({f, std::nan("")});
  each_in_parallel(sized.size(), [&](size_t k) {
    const Fragment& f = sized[k].fragment;
    if (f.in_pile) sized[k].sieve = sieve_of(members.at(f.id), run, blocks);
  });
  return sized;
}

FragmentCurves curves_of(const RunData& run, const std::vector<SizedFragment>& fragments,
                         const std::vector<double>& block_sizes) {
  std::vector<Piece> sieve, volume, block_sieve, block_volume;
  for (const auto& [f, size] : fragments) {
    if (!f.in_pile) continue;
    sieve.push_back({size, f.mass});
    volume.push_back({f.size, f.mass});
  }
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (run.moved[b] == 0) continue;
    block_sieve.push_back({block_sizes[b], run.blocks[b].mass});
    block_volume.push_back({run.blocks[b].size, run.blocks[b].mass});
  }
  FragmentCurves curves{passing_curve(sieve),
                        passing_curve(volume),
                        passing_curve(block_sieve),
                        passing_curve(block_volume),
                        {},
                        {},
                        {}};
  curves.rosin_rammler = fit_rosin_rammler(curves.sieve);
  curves.swebrec = fit_swebrec(curves.sieve);
  return curves;
}

void write_list(const ResultFolder& folder, const char* name,
                const std::vector<SizedFragment>& fragments, double least_sieve) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter list(folder.file(name),
                 with_mine_points("fragment_id,blocks,volume_m3,size_m,sieve_m,mass_kg,x_m,y_m,z_m,"
                                  "displacement_m,in_pile",
                                  frame, {""}));
  for (const auto& [f, sieve] : fragments) {
    if (least_sieve > 0.0 && !(sieve > least_sieve)) continue;
    list.row_at(
        {static_cast<double>(f.id), static_cast<double>(f.blocks), f.volume, f.size, sieve, f.mass,
         f.last.x(), f.last.y(), f.last.z(), (f.last - f.start).norm(), f.in_pile ? 1.0 : 0.0},
        mine_points(frame, {f.last}));
  }
}

// At sizes of the sieve curve; beyond the blocks' own range fits and formula are no simulation.
void write_sieve(const std::filesystem::path& path, const FragmentCurves& curves) {
  CsvWriter csv(path,
                "sieve_m,mass_fraction_passing,rosin_rammler_fit,swebrec_fit,kuz_ram_formula");
  const auto passing = [](const auto& law, double size) {
    return law ? law->curve().passing(size) : std::nan("");
  };
  for (const SizePoint& point : curves.sieve) {
    csv.row({point.size, point.passing, passing(curves.rosin_rammler, point.size),
             passing(curves.swebrec, point.size), passing(curves.kuz_ram, point.size)});
  }
}

void write_tables(const ResultFolder& folder, const FragmentCurves& curves,
                  const std::vector<SizedFragment>& fragments, const FragmentOptions& options) {
  CsvWriter sizes(folder.file("fragments.csv"), "size_m,mass_fraction_passing");
  for (const SizePoint& point : curves.by_volume) sizes.row({point.size, point.passing});
  write_sieve(folder.file("sieve.csv"), curves);
  write_list(folder, "fragments_list.csv", fragments, 0.0);
  if (options.boulder) {
    write_list(folder, "boulders.csv", fragments, *options.boulder);
  } else {
    for (const char* name : {"boulders.csv", "boulders.png"})
      std::filesystem::remove(folder.file(name));
  }
}

void write_boulders(const ResultFolder& folder, const RunData& run,
                    const std::vector<SizedFragment>& fragments, double least, double mass_share) {
  const auto members = members_of(run.last);
  std::vector<Boulder> boulders;
  for (const auto& [f, sieve] : fragments)
    if (sieve > least) boulders.push_back({members.at(f.id), sieve, f.last});
  write_png(draw_boulders(run, std::move(boulders), least, mass_share),
            folder.file("boulders.png"));
}

std::string title_of(double single_share) {
  return is_the_input(single_share) ? std::string("Broken-out rock, ") + kBlockSizesNote
                                    : "Size of the broken-out rock";
}

nlohmann::ordered_json size_keys(const FragmentCurves& c) {
  nlohmann::ordered_json keys;
  keys["fragment_p20_m"] = size_at(c.by_volume, 0.2);
  keys["fragment_p50_m"] = size_at(c.by_volume, 0.5);
  keys["fragment_p80_m"] = size_at(c.by_volume, 0.8);
  keys["fragment_largest_m"] = size_at(c.by_volume, 1.0);
  keys["block_p50_m"] = size_at(c.block_volume, 0.5);
  keys["sieve_p20_m"] = size_at(c.sieve, 0.2);
  keys["sieve_p50_m"] = size_at(c.sieve, 0.5);
  keys["sieve_p80_m"] = size_at(c.sieve, 0.8);
  keys["sieve_largest_m"] = size_at(c.sieve, 1.0);
  keys["block_sieve_finest_m"] = size_at(c.block_sieve, 0.0);
  keys["block_sieve_coarsest_m"] = size_at(c.block_sieve, 1.0);
  const auto fit = [&](const std::string& name, const char* shape,
                       const std::optional<SizeFit>& of) {
    keys[name + "_x50_m"] = of ? of->x50 : std::nan("");
    keys[name + "_" + shape] = of ? of->shape : std::nan("");
    keys[name + "_x50_error_m"] = of ? of->x50_error : std::nan("");
    keys[name + "_" + shape + "_error"] = of ? of->shape_error : std::nan("");
    keys[name + "_rms_fraction"] = of ? of->rms : std::nan("");
  };
  fit("rosin_rammler", "n", c.rosin_rammler);
  fit("swebrec", "b", c.swebrec);
  return keys;
}

nlohmann::ordered_json pile_keys(const std::vector<SizedFragment>& fragments,
                                 const FragmentOptions& options) {
  double mass = 0.0, boulder_mass = 0.0;
  int count = 0, boulders = 0;
  for (const auto& [f, sieve] : fragments) {
    if (!f.in_pile) continue;
    mass += f.mass;
    ++count;
    if (!options.boulder || !(sieve > *options.boulder)) continue;
    boulder_mass += f.mass;
    ++boulders;
  }
  nlohmann::ordered_json keys;
  keys["fragments_in_pile"] = count;
  keys["pile_mass_kg"] = mass;
  if (!options.boulder) return keys;
  keys["boulder_sieve_m"] = *options.boulder;
  keys["boulders"] = boulders;
  keys["boulder_mass_fraction"] = boulder_mass / mass;
  return keys;
}

nlohmann::ordered_json fines_of(const ResultFolder& folder, const RunData& run,
                                const std::vector<SizedFragment>& sized,
                                const FragmentOptions& options) {
  std::vector<Fragment> fragments;
  std::vector<double> sieves;
  for (const auto& [fragment, sieve] : sized) {
    fragments.push_back(fragment);
    sieves.push_back(sieve);
  }
  return write_fines(folder, run, fragments, sieves, options);
}

}  // namespace

void report_fragments(const ResultFolder& folder, const MeasureOptions& measure,
                      const FragmentOptions& options) {
  const RunData run(folder, measure);
  const std::vector<double> blocks = block_sieves(run);
  const std::vector<SizedFragment> fragments = sized_fragments(run, blocks);
  FragmentCurves curves = curves_of(run, fragments, blocks);
  const KuzRamOfRun formula = kuz_ram_of(folder, options);
  curves.kuz_ram = formula.curve;
  write_tables(folder, curves, fragments, options);
  const double single = single_block_share(fragments_of(run.blocks, run.last, run.moved));
  write_png(draw_fragments(curves, title_of(single), motion_warning(run.still)),
            folder.file("fragments.png"));
  nlohmann::ordered_json keys = common_keys(folder);
  keys.update(size_keys(curves));
  keys["kuz_ram_x50_m"] = formula.curve ? formula.curve->x50 : std::nan("");
  keys["kuz_ram_n"] = formula.curve ? formula.curve->n : std::nan("");
  keys["kuz_ram_note"] = formula.note;
  keys["fragments_single_block_share"] = single;
  keys["fragments_note"] = nullptr;
  if (is_the_input(single)) keys["fragments_note"] = kBlockSizesNote;
  keys.update(pile_keys(fragments, options));
  if (options.boulder)
    write_boulders(folder, run, fragments, *options.boulder, keys["boulder_mass_fraction"]);
  keys.update(fines_of(folder, run, fragments, options));
  std::vector<std::string> dropped = fines_keys();
  for (const char* key : {"boulder_sieve_m", "boulders", "boulder_mass_fraction"})
    dropped.emplace_back(key);
  folder.merge_into_summary(keys, dropped);
}

}  // namespace muckpile
