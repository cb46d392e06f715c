// SPDX-License-Identifier: GPL-2.0-or-later
// From where a picture of the rock is seen, and what it is to show.
// Scope: perspective; the frame is that of the last snapshot, so that frames of a film share it.
#pragma once

#include <string>
#include <vector>

#include "draw/camera.h"
#include "draw/canvas.h"
#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/columns.h"
#include "report/options.h"

namespace muckpile {

// The box of the rock before the blast, as far as the rock lies afterwards but for the few blocks
// that flew farthest.
Extent framed_box(const std::vector<StartBlock>& blocks, const Snapshot& last);

// Points that the picture of a crater must show: rim, pit and the ejecta that lie next to it. Empty
// where no rock was broken out.
std::vector<Vec3> framed_crater(const std::vector<StartBlock>& blocks, const Snapshot& last);

// Unit vector from the rock to the eye.
Vec3 direction_of_eye(double azimuth_deg, double elevation_deg);

struct View {
  Camera camera;
  Vec3 target;  // in the middle of the picture [m]
};

// From a direction, such that the points fill the picture but for a margin; then zoom and focus of
// the options.
View framing_view(const std::vector<Vec3>& points, const Vec3& to_eye,
                  const PictureOptions& options, const Canvas& canvas);

// A bar of a round length, true at the depth of the view's target, in the lower right corner.
void draw_scale_bar(const View& view, Canvas& canvas);

}  // namespace muckpile
