// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command render: the pile in three dimensions, with the rock's outline before the blast.
// Scope: one light, one ground plane at z = 0; the view frames all but the farthest hundredth of
// the rock.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "draw/axes.h"
#include "draw/png_file.h"
#include "draw/scene.h"
#include "draw/title.h"
#include "measure/columns.h"
#include "measure/fragments.h"
#include "report/block_colours.h"
#include "report/notes.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr Colour kGround{0.74F, 0.72F, 0.68F};
constexpr double kOpening = 30.0 * std::numbers::pi / 180.0;  // vertical angle of view [rad]

// Reflects y in the symmetry planes of a bench: copy 0 is the model, odd copies are mirror images.
class Reflection {
 public:
  Reflection(int copy, const Extent& extent)
      : odd_(copy % 2 != 0),
        shift_(copy * (extent.high.y() - extent.low.y())),
        twice_middle_(extent.low.y() + extent.high.y()) {}
  [[nodiscard]] Vec3 of(const Vec3& p) const {
    return {p.x(), (odd_ ? twice_middle_ - p.y() : p.y()) + shift_, p.z()};
  }
  [[nodiscard]] bool turns_over() const { return odd_; }

 private:
  bool odd_;
  double shift_, twice_middle_;
};

void add_blocks(const std::vector<StartBlock>& blocks, const Snapshot& snapshot,
                const BlockColours& colours, const Reflection& reflection, Scene& scene) {
  for (size_t b = 0; b < blocks.size(); ++b) {
    const std::vector<Vec3> vertices = moved_vertices(blocks[b], snapshot.states[b]);
    for (const std::vector<int>& face : blocks[b].shape.faces) {
      ScenePolygon polygon{{}, colours.of_block[b], static_cast<int>(b)};
      for (const int v : face)
        polygon.corners.push_back(reflection.of(vertices[static_cast<size_t>(v)]));
      if (reflection.turns_over()) std::ranges::reverse(polygon.corners);
      scene.polygons.push_back(std::move(polygon));
    }
  }
}

// The plane z = 0 outside the model's own ground plan, so that it does not hide rock below the
// floor.
void add_ground(const Extent& rock, double x_high, double margin, Scene& scene) {
  const double x0 = rock.low.x() - margin, x1 = rock.low.x(), x2 = rock.high.x(),
               x3 = x_high + margin;
  const double y0 = rock.low.y() - margin, y1 = rock.low.y(), y2 = rock.high.y(),
               y3 = rock.high.y() + margin;
  const auto add = [&](double xl, double yl, double xh, double yh) {
    scene.polygons.push_back(
        {{{xl, yl, 0}, {xh, yl, 0}, {xh, yh, 0}, {xl, yh, 0}}, kGround, kGroundObject});
  };
  add(x0, y0, x3, y1);
  add(x0, y2, x3, y3);
  add(x0, y1, x1, y2);
  add(x2, y1, x3, y2);
}

// Edges of the box around the rock before the blast, above the floor for a bench.
std::vector<SceneLine> ghost_of(const Extent& rock) {
  const double low = rock.high.z() > 0.0 ? std::max(0.0, rock.low.z()) : rock.low.z();
  const auto corner = [&](int k) {
    return Vec3(k & 1 ? rock.high.x() : rock.low.x(), k & 2 ? rock.high.y() : rock.low.y(),
                k & 4 ? rock.high.z() : low);
  };
  std::vector<SceneLine> edges;
  for (int from = 0; from < 8; ++from) {
    for (const int bit : {1, 2, 4}) {
      if ((from & bit) == 0) edges.push_back({corner(from), corner(from | bit)});
    }
  }
  return edges;
}

// Distance along x within which 99 % of the rock lies, at least the model's own.
double framed_x(const std::vector<StartBlock>& blocks, const Snapshot& last, double at_least) {
  std::vector<Piece> pieces;
  for (size_t b = 0; b < blocks.size(); ++b)
    pieces.push_back({last.states[b].centre.x(), blocks[b].mass});
  return std::max(at_least, size_at(passing_curve(std::move(pieces)), 0.99) + 1.0);
}

// An eye in the given direction from which the points fill the picture but for a margin.
Camera framing_camera(const std::vector<Vec3>& points, const PictureOptions& options,
                      const Canvas& canvas) {
  const double azimuth = options.azimuth * std::numbers::pi / 180.0;
  const double rise = options.elevation * std::numbers::pi / 180.0;
  const Vec3 to_eye(std::cos(rise) * std::cos(azimuth), -std::cos(rise) * std::sin(azimuth),
                    std::sin(rise));
  const Vec2 size(canvas.sample_width(), canvas.sample_height());
  Vec3 target = points.front();
  double distance = 0.0;
  for (const Vec3& p : points) distance = std::max(distance, 6.0 * (p - target).norm());
  const auto camera = [&] {
    return Camera::perspective(target + distance * to_eye, target, kOpening, canvas.sample_width(),
                               canvas.sample_height());
  };
  constexpr int kRounds = 12;  // each halves what is left of the error or better
  for (int round = 0; round < kRounds; ++round) {
    const Camera view = camera();
    Vec2 low = size, high = Vec2::Zero();
    for (const Vec3& p : points) {
      low = low.cwiseMin(view.place(p));
      high = high.cwiseMax(view.place(p));
    }
    const Vec2 filled = (high - low).cwiseQuotient(Vec2(0.90 * size.x(), 0.80 * size.y()));
    target = view.point(0.5 * (low + high), view.nearness(target));
    distance *= std::clamp(filled.maxCoeff(), 0.5, 2.0);
  }
  return camera();
}

class Picture {
 public:
  Picture(const std::vector<StartBlock>& blocks, const Snapshot& last,
          const PictureOptions& options)
      : blocks_(blocks),
        options_(options),
        rock_(extent_of(blocks, start_snapshot(blocks).states)) {
    whole_ = rock_;
    const double width = rock_.high.y() - rock_.low.y();
    whole_.low.y() -= options.mirror * width;
    whole_.high.y() += options.mirror * width;
    x_high_ = framed_x(blocks, last, rock_.high.x());
    for (const SceneLine& edge : ghost_of(whole_))
      framed_.push_back(edge.from), framed_.push_back(edge.to);
    for (const BlockState& state : last.states) {
      if (state.centre.x() > x_high_) continue;
      for (const int copy : {-options.mirror, options.mirror})
        framed_.push_back(Reflection(copy, rock_).of(state.centre));
    }
  }

  void write(const Snapshot& snapshot, const std::string& warning, std::optional<double> fastest,
             const std::filesystem::path& path) const {
    Canvas canvas(options_.width, options_.height, kWhite);
    const BlockColours colours = block_colours(options_.colour_by, blocks_, snapshot, fastest);
    Scene scene;
    scene.to_sun = Vec3(0.50, -0.45, 0.74).normalized();
    scene.hollow_size = 2.0 * mean_size();
    for (int copy = -options_.mirror; copy <= options_.mirror; ++copy) {
      add_blocks(blocks_, snapshot, colours, Reflection(copy, rock_), scene);
    }
    const double length = x_high_ - whole_.low.x();
    add_ground(whole_, x_high_, 60.0 * length, scene);
    scene.haze = 12.0 * length;
    scene.ghost_lines = ghost_of(whole_);
    draw_scene(scene, framing_camera(framed_, options_, canvas), canvas);
    draw_words(snapshot, warning, colours, canvas);
    write_png(canvas, path);
  }

 private:
  [[nodiscard]] double mean_size() const {
    double sum = 0.0;
    for (const StartBlock& block : blocks_) sum += block.size;
    return sum / static_cast<double>(blocks_.size());
  }

  void draw_words(const Snapshot& snapshot, const std::string& warning, const BlockColours& colours,
                  Canvas& canvas) const {
    char time[64];
    std::snprintf(time, sizeof time, "t = %.3f s", snapshot.time);
    draw_title({28.0, 46.0}, time, warning, 28.0, canvas);
    std::string words =
        std::to_string(blocks_.size()) + " blocks; blue: box around the rock before the blast";
    if (options_.mirror > 0) words += "; model repeated by mirror images at its symmetry planes";
    canvas.text({28.0, options_.height - 20.0}, words, 18.0, kInk);
    draw_legend(colours, {options_.width - 340.0, 18.0}, canvas);
  }

  const std::vector<StartBlock>& blocks_;
  const PictureOptions& options_;
  Extent rock_, whole_;
  std::vector<Vec3> framed_;  // what the picture is to show [m]
  double x_high_;
};

std::optional<double> fastest_of(const ResultFolder& folder, const std::vector<StartBlock>& blocks,
                                 const PictureOptions& options) {
  if (options.colour_by != ColourBy::kSpeed || options.frames == 0) return std::nullopt;
  double fastest = 0.0;
  for (const auto& path : folder.snapshots()) {
    for (const BlockState& s : read_snapshot(path, blocks).states)
      fastest = std::max(fastest, s.velocity.norm());
  }
  return fastest;
}

}  // namespace

void report_picture(const ResultFolder& folder, const PictureOptions& options) {
  const std::vector<StartBlock> blocks = folder.blocks();
  const std::vector<std::filesystem::path> snapshots = folder.snapshots();
  const Snapshot last = read_snapshot(snapshots.back(), blocks);
  const Picture picture(blocks, last, options);
  const std::optional<double> fastest = fastest_of(folder, blocks, options);
  const std::string warning = motion_warning(folder.is_still());
  picture.write(last, warning, fastest, folder.file("pile3d.png"));
  for (int frame = 0; frame < options.frames; ++frame) {
    const double share =
        options.frames > 1 ? static_cast<double>(frame) / (options.frames - 1) : 1.0;
    const auto which =
        static_cast<size_t>(std::lround(share * static_cast<double>(snapshots.size() - 1)));
    char name[32];
    std::snprintf(name, sizeof name, "pile3d_%04d.png", frame);
    const bool at_the_end = which + 1 == snapshots.size();
    picture.write(read_snapshot(snapshots[which], blocks), at_the_end ? warning : "", fastest,
                  folder.file(name));
  }
  folder.merge_into_summary(common_keys(folder));
}

}  // namespace muckpile
