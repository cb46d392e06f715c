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
#include "measure/columns.h"
#include "measure/fragments.h"
#include "report/block_colours.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr Colour kGround{0.80F, 0.77F, 0.71F};
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
    scene.polygons.push_back({{{xl, yl, 0}, {xh, yl, 0}, {xh, yh, 0}, {xl, yh, 0}}, kGround, -1});
  };
  add(x0, y0, x3, y1);
  add(x0, y2, x3, y3);
  add(x0, y1, x1, y2);
  add(x2, y1, x3, y2);
}

void add_ghost(const Extent& rock, Scene& scene) {
  const double floor = std::min(0.0, rock.high.z() - 1e-9);
  const double low = rock.high.z() > 0.5 ? floor : rock.low.z();
  const auto corner = [&](int k) {
    return Vec3(k & 1 ? rock.high.x() : rock.low.x(), k & 2 ? rock.high.y() : rock.low.y(),
                k & 4 ? rock.high.z() : low);
  };
  for (int from = 0; from < 8; ++from) {
    for (const int bit : {1, 2, 4}) {
      if ((from & bit) == 0) scene.ghost_lines.push_back({corner(from), corner(from | bit)});
    }
  }
}

// Distance along x within which 99 % of the rock lies, at least the model's own.
double framed_x(const std::vector<StartBlock>& blocks, const Snapshot& last, double at_least) {
  std::vector<Piece> pieces;
  for (size_t b = 0; b < blocks.size(); ++b)
    pieces.push_back({last.states[b].centre.x(), blocks[b].mass});
  return std::max(at_least, size_at(passing_curve(std::move(pieces)), 0.99) + 1.0);
}

// Nearest eye on the given ray from which the whole box is inside 92 % of the picture.
Camera framing_camera(const Vec3& low, const Vec3& high, const PictureOptions& options,
                      const Canvas& canvas) {
  const double azimuth = options.azimuth * std::numbers::pi / 180.0,
               rise = options.elevation * std::numbers::pi / 180.0;
  const Vec3 to_eye(std::cos(rise) * std::cos(azimuth), -std::cos(rise) * std::sin(azimuth),
                    std::sin(rise));
  const Vec3 middle = 0.5 * (low + high);
  const double w = canvas.sample_width(), h = canvas.sample_height();
  const auto camera_at = [&](double distance) {
    return Camera::perspective(middle + distance * to_eye, middle, kOpening, canvas.sample_width(),
                               canvas.sample_height());
  };
  double distance = 0.6 * (high - low).norm();
  for (bool all = false; !all; distance *= 1.03) {
    const Camera camera = camera_at(distance);
    all = true;
    for (int k = 0; k < 8 && all; ++k) {
      const Vec3 corner(k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(),
                        k & 4 ? high.z() : low.z());
      const Vec2 p = camera.place(corner) - Vec2(0.5 * w, 0.5 * h);
      all = camera.sees(corner) && std::abs(p.x()) < 0.46 * w && std::abs(p.y()) < 0.43 * h;
    }
  }
  return camera_at(distance);
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
  }

  void write(const Snapshot& snapshot, std::optional<double> fastest,
             const std::filesystem::path& path) const {
    Canvas canvas(options_.width, options_.height, kWhite);
    const BlockColours colours = block_colours(options_.colour_by, blocks_, snapshot, fastest);
    Scene scene;
    scene.to_sun = Vec3(0.45, -0.35, 0.80).normalized();
    scene.hollow_size = 2.0 * mean_size();
    for (int copy = -options_.mirror; copy <= options_.mirror; ++copy) {
      add_blocks(blocks_, snapshot, colours, Reflection(copy, rock_), scene);
    }
    add_ground(whole_, x_high_, 2.0 * (x_high_ - whole_.low.x()), scene);
    add_ghost(whole_, scene);
    Vec3 low = whole_.low, high = whole_.high;
    low.z() = std::max(low.z(), high.z() > 0.5 ? 0.0 : low.z());
    high.x() = x_high_;
    draw_scene(scene, framing_camera(low, high, options_, canvas), canvas);
    draw_words(snapshot, colours, canvas);
    write_png(canvas, path);
  }

 private:
  [[nodiscard]] double mean_size() const {
    double sum = 0.0;
    for (const StartBlock& block : blocks_) sum += block.size;
    return sum / static_cast<double>(blocks_.size());
  }

  void draw_words(const Snapshot& snapshot, const BlockColours& colours, Canvas& canvas) const {
    char time[64];
    std::snprintf(time, sizeof time, "t = %.3f s", snapshot.time);
    canvas.text({28.0, 46.0}, time, 28.0, kInk);
    std::string words = std::to_string(blocks_.size()) + " blocks; blue: outline before the blast";
    if (options_.mirror > 0) words += "; model repeated by mirror images at its symmetry planes";
    canvas.text({28.0, options_.height - 20.0}, words, 18.0, kInk);
    draw_legend(colours, {options_.width - 340.0, 18.0}, canvas);
  }

  const std::vector<StartBlock>& blocks_;
  const PictureOptions& options_;
  Extent rock_, whole_;
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
  picture.write(last, fastest, folder.file("pile3d.png"));
  for (int frame = 0; frame < options.frames; ++frame) {
    const double share =
        options.frames > 1 ? static_cast<double>(frame) / (options.frames - 1) : 1.0;
    const auto which =
        static_cast<size_t>(std::lround(share * static_cast<double>(snapshots.size() - 1)));
    char name[32];
    std::snprintf(name, sizeof name, "pile3d_%04d.png", frame);
    picture.write(read_snapshot(snapshots[which], blocks), fastest, folder.file(name));
  }
  folder.merge_into_summary(common_keys(folder));
}

}  // namespace muckpile
