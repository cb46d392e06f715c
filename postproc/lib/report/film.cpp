// SPDX-License-Identifier: GPL-2.0-or-later
// A film of pictures, by the program ffmpeg.
// Scope: see the header; POSIX.
#include "report/film.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "args/input_error.h"

namespace muckpile {
namespace {

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

// Its exit status; -1 where it did not run or did not end by itself.
int run_program(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return -1;
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace

void require_ffmpeg() {
  if (is_installed("ffmpeg")) return;
  refuse("render",
         "--mp4 needs the program ffmpeg, which is not installed (Debian and Ubuntu: apt install "
         "ffmpeg); --frames N writes the pictures alone");
}

void make_film(const std::filesystem::path& folder, int frames, int frames_per_second,
               const std::filesystem::path& film) {
  // H.264 has an even number of pixels each way.
  const int status =
      run_program({"ffmpeg", "-y", "-nostdin", "-loglevel", "error", "-framerate",
                   std::to_string(frames_per_second), "-i", (folder / "pile3d_%04d.png").string(),
                   "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-frames:v", std::to_string(frames),
                   "-pix_fmt", "yuv420p", "-f", "mp4", film.string()});
  if (status != 0)
    refuse(film.string(), "cannot be written: ffmpeg ended with status " + std::to_string(status));
}

}  // namespace muckpile
