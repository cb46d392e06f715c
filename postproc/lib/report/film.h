// SPDX-License-Identifier: GPL-2.0-or-later
// A film of pictures, by the program ffmpeg.
// Scope: H.264 in an MP4 file; ffmpeg is run, not linked.
#pragma once

#include <filesystem>

namespace muckpile {

// Throws InputError, with what to install, where there is no ffmpeg in PATH.
void require_ffmpeg();

// Of <folder>/pile3d_0000.png and those that follow, `frames` in all: later ones may be left there
// from an earlier call. Throws InputError where ffmpeg fails; it has
// told why on standard error.
void make_film(const std::filesystem::path& folder, int frames, int frames_per_second,
               const std::filesystem::path& film);

}  // namespace muckpile
