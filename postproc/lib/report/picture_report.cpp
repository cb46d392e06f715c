// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command render: the rock in three dimensions, with its outline before the blast.
// Scope: one light, one ground plane at z = 0; picture_scene.h and picture_view.h have the parts.
#include "report/picture_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "args/input_error.h"
#include "draw/axes.h"
#include "draw/png_file.h"
#include "draw/scene.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "io/muck.h"
#include "measure/section.h"
#include "measure/start_extent.h"
#include "report/block_colours.h"
#include "report/film.h"
#include "report/notes.h"
#include "report/picture_scene.h"
#include "report/picture_view.h"
#include "report/picture_words.h"
#include "report/plan_line_of.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr double kElevation = 28.0, kCraterElevation = 45.0;  // of the eye [deg]

class Picture {
 public:
  Picture(const ResultFolder& folder, const std::vector<StartBlock>& blocks, const Snapshot& last,
          const PictureOptions& options, const BlockFields& fields,
          const std::optional<PlanLine>& line)
      : blocks_(blocks),
        options_(options),
        fields_(fields),
        rock_(extent_at_start(blocks)),
        whole_(rock_),
        box_(framed_box(blocks, last)) {
    const bool crater = folder.scene_word("case") == "crater";
    to_eye_ = direction_of_eye(options.azimuth,
                               options.elevation.value_or(crater ? kCraterElevation : kElevation));
    const double width = rock_.high.y() - rock_.low.y();
    for (Extent* each : {&whole_, &box_}) {
      each->low.y() -= options.mirror * width;
      each->high.y() += options.mirror * width;
    }
    if (crater) framed_ = framed_crater(blocks, last);
    if (framed_.empty()) frame_all(last);
    if (options.section) {
      cut_ = cut_along({{0.0, *options.section}, {1.0, *options.section}}, to_eye_);
      cut_words_ = "rock in front of y = " + spelled(*options.section) + " m cut away";
    }
    if (line) {
      cut_ = cut_along(*line, to_eye_);
      cut_words_ = "cut " + words_of(*line);
    }
    if (cut_) require_rock_in(*cut_, last);
  }

  void write(const Snapshot& snapshot, const std::string& warning, const ValueRange& range,
             const std::filesystem::path& path) const {
    Canvas canvas(options_.width, options_.height, kWhite);
    const BlockColours colours =
        block_colours(fields_.of(options_.colour_by, snapshot), range, options_.colour_range);
    const View view = framing_view(framed_, to_eye_, options_, canvas);
    draw_scene(scene_of(snapshot, colours), view.camera, canvas);
    draw_words(words_for(snapshot, warning), colours, canvas);
    draw_scale_bar(view, canvas);
    write_png(canvas, path);
  }

 private:
  // A plane beside the rock would leave all of it, or nothing.
  void require_rock_in(const CutPlane& cut, const Snapshot& last) const {
    const auto meets = [&](const std::vector<BlockState>& states) {
      return !section_at(0.0, blocks_, seen_along(cut.line, states)).empty();
    };
    if (meets(start_snapshot(blocks_).states) || meets(last.states)) return;
    throw InputError("render: a cut must meet rock, which lies from x = " + spelled(rock_.low.x()) +
                     " to " + spelled(rock_.high.x()) + " m, y = " + spelled(rock_.low.y()) +
                     " to " + spelled(rock_.high.y()) + " m before the blast; got " + cut_words_);
  }

  // The box before the blast, and the rock but for what flew farthest.
  void frame_all(const Snapshot& last) {
    for (const SceneLine& edge : edges_of(whole_))
      framed_.push_back(edge.from), framed_.push_back(edge.to);
    for (const BlockState& state : last.states) {
      for (const int copy : {-options_.mirror, options_.mirror}) {
        const Vec3 place = Reflection(copy, rock_).of(state.centre);
        const bool near = (place.head<2>().array() >= box_.low.head<2>().array()).all() &&
                          (place.array() <= box_.high.array()).all();
        if (near) framed_.push_back(place);
      }
    }
  }

  [[nodiscard]] Scene scene_of(const Snapshot& snapshot, const BlockColours& colours) const {
    Scene scene;
    scene.to_sun = Vec3(0.50, -0.45, 0.74).normalized();
    scene.hollow_size = 2.0 * mean_size();
    for (int copy = -options_.mirror; copy <= options_.mirror; ++copy)
      add_blocks(blocks_, snapshot, colours.of_block, Reflection(copy, rock_), scene);
    const double length = box_.high.x() - whole_.low.x();
    add_ground(whole_, box_.high.x(), 60.0 * length, scene);
    scene.haze = 12.0 * length;
    scene.ghost_lines = edges_of(whole_);
    if (!cut_) return scene;
    cut_away(*cut_, scene);
    add_cut_faces(*cut_, blocks_, snapshot, colours.of_block, scene);
    return scene;
  }

  [[nodiscard]] double mean_size() const {
    double sum = 0.0;
    for (const StartBlock& block : blocks_) sum += block.size;
    return sum / static_cast<double>(blocks_.size());
  }

  [[nodiscard]] PictureWords words_for(const Snapshot& snapshot, const std::string& warning) const {
    char time[64];
    std::snprintf(time, sizeof time, "t = %.3f s", snapshot.time);
    PictureWords words{
        time,
        warning,
        {std::to_string(blocks_.size()) + " blocks", "blue: box around the rock before the blast"}};
    if (rock_blocks(blocks_) < blocks_.size())
      words.caption.emplace_back("grey-green: muck that lay in front");
    if (options_.mirror > 0)
      words.caption.emplace_back("model repeated by mirror images at its symmetry planes");
    if (!cut_words_.empty()) words.caption.push_back(cut_words_);
    return words;
  }

  const std::vector<StartBlock>& blocks_;
  const PictureOptions& options_;
  const BlockFields& fields_;
  Extent rock_, whole_;       // before the blast; the latter with its mirror images
  Extent box_;                // with where the rock went
  Vec3 to_eye_;               // unit
  std::vector<Vec3> framed_;  // what the picture is to show [m]
  std::optional<CutPlane> cut_;
  std::string cut_words_;  // that say so
};

// The pictures over the run.
class Frames {
 public:
  Frames(const ResultFolder& folder, const std::vector<StartBlock>& blocks,
         const PictureOptions& options)
      : blocks_(blocks), options_(options), snapshots_(folder.snapshots()) {}

  [[nodiscard]] bool any() const { return options_.frames > 0 || !options_.film.empty(); }

  // A film shows every snapshot where no number is given.
  [[nodiscard]] int count() const {
    return options_.frames > 0 ? options_.frames : static_cast<int>(snapshots_.size());
  }

  // Over the whole run, so that all pictures share one legend.
  [[nodiscard]] ValueRange range(const BlockFields& fields) const {
    if (!any() || options_.colour_range) return std::nullopt;
    return fields.range_of_run(options_.colour_by);
  }

  // pile3d_0000.png ... in a folder.
  void write(const Picture& picture, const std::string& warning, const ValueRange& range,
             const std::filesystem::path& into) const {
    const int all = count();
    for (int frame = 0; frame < all; ++frame) {
      const double share = all > 1 ? static_cast<double>(frame) / (all - 1) : 1.0;
      const auto which =
          static_cast<size_t>(std::lround(share * static_cast<double>(snapshots_.size() - 1)));
      char name[32];
      std::snprintf(name, sizeof name, "pile3d_%04d.png", frame);
      const bool at_the_end = which + 1 == snapshots_.size();
      picture.write(read_snapshot(snapshots_[which], blocks_), at_the_end ? warning : "", range,
                    into / name);
    }
  }

 private:
  const std::vector<StartBlock>& blocks_;
  const PictureOptions& options_;
  std::vector<std::filesystem::path> snapshots_;
};

// Pictures that only the film is made of.
class FilmFolder {
 public:
  explicit FilmFolder(std::filesystem::path path) : path_(std::move(path)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~FilmFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  FilmFolder(const FilmFolder&) = delete;
  FilmFolder& operator=(const FilmFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Where the blocks of the last picture are, and what their colours show.
void write_table(const ResultFolder& folder, const std::vector<StartBlock>& blocks,
                 const Snapshot& last, const BlockField& field) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("pile3d.csv"),
                with_mine_columns("block,x_m,y_m,z_m," + field.column, frame));
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& at = last.states[b].centre;
    const auto name = field.names.find(static_cast<int>(field.values[b]));
    csv.row_named(std::to_string(blocks[b].id), {at.x(), at.y(), at.z()}, field.values[b],
                  name == field.names.end() ? "" : name->second, mine_place(frame, at.x(), at.y()));
  }
}

void draw_pictures(const ResultFolder& folder, const PictureOptions& options,
                   const std::optional<PlanLine>& line) {
  if (!options.film.empty()) require_ffmpeg();
  const std::vector<StartBlock>& blocks = folder.blocks();
  const Snapshot last = read_snapshot(folder.snapshots().back(), blocks);
  const BlockFields fields(folder, blocks);
  const Picture picture(folder, blocks, last, options, fields, line);
  const Frames frames(folder, blocks, options);
  const std::string warning = motion_warning(folder.is_still());
  const ValueRange range = frames.range(fields);
  picture.write(last, warning, range, folder.file("pile3d.png"));
  write_table(folder, blocks, last, fields.of(options.colour_by, last));
  if (options.frames > 0) frames.write(picture, warning, range, folder.file(""));
  if (!options.film.empty() && options.frames > 0) {
    make_film(folder.file(""), frames.count(), options.frames_per_second, options.film);
  } else if (!options.film.empty()) {
    const FilmFolder pictures(folder.file(".film"));
    frames.write(picture, warning, range, pictures.path());
    make_film(pictures.path(), frames.count(), options.frames_per_second, options.film);
  }
  folder.merge_into_summary(common_keys(folder));
}

}  // namespace

void report_picture(const ResultFolder& folder, const PictureOptions& options) {
  draw_pictures(folder, options, std::nullopt);
}

void report_picture(const ResultFolder& folder, const PictureOptions& options,
                    const LineOptions& line) {
  draw_pictures(folder, options, plan_line_of(folder, line, "render"));
}

}  // namespace muckpile
