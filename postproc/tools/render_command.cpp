// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command render of muckpile-post.
// Scope: see the header.
#include "render_command.h"

#include <memory>
#include <string>

#include "command_words.h"
#include "report/picture_report.h"
#include "report/reports.h"

namespace muckpile {
namespace {

struct PictureWords {
  std::string folder;
  PictureOptions picture;
  LineOptions line;  // of --from and --to
  bool along_line = false;
};

// Planes that the rock is cut along.
void add_sections(CLI::App* render, CLI::Option* mirror, PictureWords& words) {
  CLI::Option* section =
      render
          ->add_option("--section", words.picture.section,
                       "cut away the rock between the eye and the plane at this y [m]")
          ->check(any_number())
          ->excludes(mirror);
  CLI::Option* from =
      render
          ->add_option("--from", words.line.from,
                       "X Y of a point of a line in plan: cut away the rock between the eye and "
                       "the upright plane through it [m]")
          ->check(any_number())
          ->excludes(mirror)
          ->excludes(section);
  CLI::Option* to =
      render->add_option("--to", words.line.to, "X Y of another point of that line [m]")
          ->check(any_number())
          ->needs(from);
  from->needs(to);
  from->each([&words](const std::string&) { words.along_line = true; });
  render
      ->add_flag("--mine", words.line.mine,
                 "these points are east and north of the mine, not x and y of the run")
      ->needs(from);
}

void add_view(CLI::App* render, PictureOptions& picture) {
  render->add_option("--width", picture.width, "[px]")->check(CLI::Range(200, 8000));
  render->add_option("--height", picture.height, "[px]")->check(CLI::Range(200, 8000));
  render
      ->add_option("--azimuth", picture.azimuth,
                   "of the eye, from the throw direction towards -y [deg]")
      ->check(any_number());
  render
      ->add_option("--elevation", picture.elevation,
                   "of the eye [deg] (default: 28, of a crater 45)")
      ->check(between(1.0, 89.0));
  render->add_option("--zoom", picture.zoom, "the eye comes nearer by this factor")
      ->check(between(0.05, 100.0));
  render
      ->add_option("--focus", picture.focus,
                   "X Y Z in the middle of the picture [m] (default: of what it shows)")
      ->check(any_number());
}

}  // namespace

void add_render_command(CLI::App& app) {
  const auto o = std::make_shared<PictureWords>();
  CLI::App* render =
      add_command(app, "render", "pile3d.png: the pile in three dimensions", o->folder);
  add_colour(render, o->picture.colour_by);
  render
      ->add_option("--colour-range", o->picture.colour_range,
                   "LOW HIGH of the colours, where one block would take them all (default: that "
                   "of the blocks)")
      ->check(any_number());
  render
      ->add_option("--frames", o->picture.frames,
                   "also this many pictures over the run, pile3d_0000.png ...")
      ->check(CLI::Range(0, 9999));
  CLI::Option* mirror = render
                            ->add_option("--mirror", o->picture.mirror,
                                         "mirror images of a bench to show on each side of it")
                            ->check(CLI::Range(0, 5));
  add_sections(render, mirror, *o);
  CLI::Option* film = render->add_option(
      "--mp4", o->picture.film, "film of all snapshots, or of those of --frames; needs ffmpeg");
  render->add_option("--fps", o->picture.frames_per_second, "pictures per second of the film")
      ->check(CLI::Range(1, 60))
      ->needs(film);
  add_view(render, o->picture);
  render->callback([o] {
    const auto& range = o->picture.colour_range;
    if (range && !((*range)[0] < (*range)[1]))
      throw CLI::ValidationError("--colour-range", "LOW must be below HIGH");
    const ResultFolder folder(o->folder);
    if (o->along_line) return report_picture(folder, o->picture, o->line);
    report_picture(folder, o->picture);
  });
}

}  // namespace muckpile
