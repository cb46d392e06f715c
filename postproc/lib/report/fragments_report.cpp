// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command fragments: size curve of the broken-out rock and a table of all fragments.
// Scope: size is volume^(1/3); blocks are the finest pieces that the model knows.
#include <algorithm>
#include <cmath>

#include "draw/axes.h"
#include "draw/png_file.h"
#include "draw/title.h"
#include "io/csv_writer.h"
#include "measure/fragments.h"
#include "report/notes.h"
#include "report/reports.h"
#include "report/run_data.h"

namespace muckpile {
namespace {

std::vector<SizePoint> pile_curve(const std::vector<Fragment>& fragments) {
  std::vector<Piece> pieces;
  for (const Fragment& f : fragments) {
    if (f.in_pile) pieces.push_back({f.size, f.mass});
  }
  return passing_curve(std::move(pieces));
}

std::vector<SizePoint> block_curve(const RunData& run) {
  std::vector<Piece> pieces;
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    if (run.moved[b] != 0) pieces.push_back({run.blocks[b].size, run.blocks[b].mass});
  }
  return passing_curve(std::move(pieces));
}

void write_tables(const ResultFolder& folder, const std::vector<SizePoint>& curve,
                  const std::vector<Fragment>& fragments) {
  CsvWriter sizes(folder.file("fragments.csv"), "size_m,mass_fraction_passing");
  for (const SizePoint& point : curve) sizes.row({point.size, point.passing});
  CsvWriter list(folder.file("fragments_list.csv"),
                 "fragment_id,blocks,volume_m3,size_m,mass_kg,x_m,y_m,z_m,displacement_m,in_pile");
  for (const Fragment& f : fragments) {
    list.row({static_cast<double>(f.id), static_cast<double>(f.blocks), f.volume, f.size, f.mass,
              f.last.x(), f.last.y(), f.last.z(), (f.last - f.start).norm(),
              f.in_pile ? 1.0 : 0.0});
  }
}

// A passing curve rises at each size by the mass of the pieces of that size.
std::vector<Vec2> steps(const std::vector<SizePoint>& curve, const AxisRange& x) {
  std::vector<Vec2> points{{x.low, 0.0}};
  for (const SizePoint& p : curve) {
    points.emplace_back(p.size, points.back().y());
    points.emplace_back(p.size, 100.0 * p.passing);
  }
  points.emplace_back(x.high, 100.0);
  return points;
}

std::string title_of(double single_share) {
  return is_the_input(single_share) ? std::string("Broken-out rock, ") + kBlockSizesNote
                                    : "Size of the broken-out rock";
}

Canvas draw_curves(const std::vector<SizePoint>& fragments, const std::vector<SizePoint>& blocks,
                   const std::string& title, const std::string& warning) {
  constexpr int kWidth = 1200, kHeight = 760;
  Canvas canvas(kWidth, kHeight, kWhite);
  draw_title({105.0, 48.0}, title, warning, 30.0, canvas);
  if (fragments.empty()) {
    canvas.text({105.0, 100.0}, "no rock was broken out", 22.0, kInk);
    return canvas;
  }
  const AxisRange x{0.8 * std::min(fragments.front().size, blocks.front().size),
                    1.25 * fragments.back().size};
  const Axes axes({105.0, 120.0}, {kWidth - 30.0, kHeight - 85.0}, x, {0.0, 100.0},
                  Scale::kLogarithmic);
  axes.draw_grid(canvas);
  canvas.polyline(axes.places(steps(blocks, x)), 2.0, kGrey);
  canvas.polyline(axes.places(steps(fragments, x)), 3.5, kBench);
  std::string numbers;
  for (const int percent : {20, 50, 80}) {
    const double size = size_at(fragments, 0.01 * percent);
    const Vec2 guide[] = {axes.place(x.low, percent), axes.place(size, percent),
                          axes.place(size, 0.0)};
    canvas.dashes(guide, 1.6, 7.0, kSignal);
    numbers +=
        (numbers.empty() ? "P" : " · P") + std::to_string(percent) + " " + spelled(size) + " m";
  }
  axes.draw_frame(canvas, "size = volume^(1/3) [m]", "mass passing [%]");
  canvas.text({105.0, 92.0}, numbers, 22.0, kSignal);
  canvas.line({620.0, 84.0}, {664.0, 84.0}, 3.5, kBench);
  canvas.text({672.0, 91.0}, "fragments", 20.0, kInk);
  canvas.line({820.0, 84.0}, {864.0, 84.0}, 2.0, kGrey);
  canvas.text({872.0, 91.0}, "blocks, if every joint broke", 20.0, kInk);
  return canvas;
}

}  // namespace

void report_fragments(const ResultFolder& folder, const MeasureOptions& measure) {
  const RunData run(folder, measure);
  const std::vector<Fragment> fragments = fragments_of(run.blocks, run.last, run.moved);
  const std::vector<SizePoint> curve = pile_curve(fragments), blocks = block_curve(run);
  write_tables(folder, curve, fragments);
  const double single = single_block_share(fragments);
  write_png(draw_curves(curve, blocks, title_of(single), motion_warning(run.still)),
            folder.file("fragments.png"));
  double mass = 0.0;
  for (const Fragment& f : fragments) mass += f.in_pile ? f.mass : 0.0;
  nlohmann::ordered_json keys = common_keys(folder);
  keys["fragment_p20_m"] = size_at(curve, 0.2);
  keys["fragment_p50_m"] = size_at(curve, 0.5);
  keys["fragment_p80_m"] = size_at(curve, 0.8);
  keys["fragment_largest_m"] = size_at(curve, 1.0);
  keys["block_p50_m"] = size_at(blocks, 0.5);
  keys["fragments_single_block_share"] = single;
  keys["fragments_note"] = nullptr;
  if (is_the_input(single)) keys["fragments_note"] = kBlockSizesNote;
  keys["fragments_in_pile"] = std::ranges::count_if(fragments, &Fragment::in_pile);
  keys["pile_mass_kg"] = mass;
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
