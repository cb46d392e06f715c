// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons of rock of holes: from the run to a table.
// Scope: see the header.
#include "report/hole_outlines.h"

#include <filesystem>

#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "measure/start_extent.h"

namespace muckpile {

std::vector<HolePolygon> hole_outlines(const ResultFolder& folder, const BenchScene& bench,
                                       const std::vector<StartBlock>& blocks) {
  if (!std::filesystem::exists(folder.dump("holes.csv"))) return {};
  const HoleTable table = hole_table_of(folder);
  const std::vector<double> masses(table.decks().size(), 0.0);
  const Extent rock = extent_at_start(blocks);
  return hole_polygons(pattern_holes(table, masses, bench.burden), bench.planes,
                       {0.5 * bench.height, rock.low.head<2>(), rock.high.head<2>()});
}

void write_hole_outlines(const ResultFolder& folder, const std::vector<HolePolygon>& outlines,
                         double height) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("hole_polygons.csv"),
                with_mine_columns("hole,x_m,y_m,z_m,part", frame));
  const std::string* last = nullptr;
  int part = 0;
  for (const HolePolygon& outline : outlines) {
    part = last != nullptr && *last == outline.hole ? part + 1 : 1;
    last = &outline.hole;
    for (const Vec2& p : outline.corners)
      csv.row_at(outline.hole, {p.x(), p.y(), height, static_cast<double>(part)},
                 mine_place(frame, p.x(), p.y()));
  }
}

}  // namespace muckpile
