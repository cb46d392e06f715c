// SPDX-License-Identifier: GPL-2.0-or-later
// perf_post MUCKPILE_POST PERF_POST_RUN FOLDER [BLOCKS]: clock and memory of what measures and
// draws a run of 195,000 blocks and 30 snapshots, beside their bounds; prints JSON.
// Scope: one run of each command, files in memory. Exit status 1 where one takes more than twice
// its bound or more memory than the bound, as bounds are for a machine that does nothing else; with
// fewer BLOCKS none is bounded.
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "timing.h"

namespace muckpile::perf {
namespace {

constexpr double kMemory = 2.147483648;  // 2 GiB [GB]
constexpr int kFilmFrames = 10;

struct Used {
  double clock, processor;  // [s]
  double memory;            // [GB]
};

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Used run(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const auto begin = std::chrono::steady_clock::now();
  pid_t child = 0;
  int status = -1;
  rusage used{};
  // What the programs print belongs behind our own standard output.
  posix_spawn_file_actions_t to_errors;
  posix_spawn_file_actions_init(&to_errors);
  posix_spawn_file_actions_adddup2(&to_errors, STDERR_FILENO, STDOUT_FILENO);
  const int fault = posix_spawnp(&child, argv[0], &to_errors, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&to_errors);
  if (fault != 0 || wait4(child, &status, 0, &used) != child || !WIFEXITED(status) ||
      WEXITSTATUS(status) != 0)
    throw std::runtime_error(words[0] + " " + words[1] + " failed");
  const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - begin;
  return {clock.count(), seconds(used.ru_utime) + seconds(used.ru_stime),
          1024e-9 * static_cast<double>(used.ru_maxrss)};
}

bool has_ffmpeg() {
  try {
    return run({"ffmpeg", "-loglevel", "quiet", "-version"}).clock > 0.0;
  } catch (const std::runtime_error&) {
    return false;
  }
}

struct Command {
  const char* name;
  std::vector<std::string> words;
  double bound;  // [s]; 0: none
};

std::vector<Command> commands(const std::string& folder) {
  std::vector<Command> all{{"profile", {"profile", folder}, 3.0},
                           {"render", {"render", folder}, 10.0},
                           {"all, with the page of report", {"all", folder}, 30.0}};
  std::vector<std::string> film{"render", folder, "--frames", std::to_string(kFilmFrames)};
  if (has_ffmpeg()) film.insert(film.end(), {"--mp4", folder + "/film.mp4"});
  all.push_back({"film of 10 pictures, with pile3d.png", std::move(film), 0.0});
  return all;
}

nlohmann::ordered_json row_of(const Command& command, const Used& used) {
  nlohmann::ordered_json row{{"command", command.name}, {"clock_s", used.clock}};
  if (command.bound > 0.0) row["bound_s"] = command.bound;
  row["processor_s"] = used.processor;
  row["memory_GB"] = used.memory;
  row["memory_bound_GB"] = kMemory;
  return row;
}

// Whether all commands kept to twice their bounds.
bool measure(const std::string& post, const std::string& maker, const std::string& folder,
             const std::string& blocks) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  run(blocks.empty() ? std::vector<std::string>{maker, folder}
                     : std::vector<std::string>{maker, folder, blocks});
  nlohmann::ordered_json result{{"what", "muckpile-post on a made-up bench run"},
                                {"blocks", blocks.empty() ? "200000" : blocks},
                                {"processor", processor()}};
  bool kept = true;
  for (const Command& command : commands(folder)) {
    std::vector<std::string> words = command.words;
    words.insert(words.begin(), post);
    const Used used = run(std::move(words));
    result["commands"].push_back(row_of(command, used));
    const bool slow = command.bound > 0.0 && used.clock > 2.0 * command.bound;
    if (!slow && used.memory <= kMemory) continue;
    kept = false;
    std::cerr << "perf_post: " << command.name << ": " << used.clock << " s, at most "
              << 2.0 * command.bound << "; " << used.memory << " GB, at most " << kMemory << '\n';
  }
  std::cout << result.dump(2) << '\n';
  std::filesystem::remove_all(folder);
  return kept || !blocks.empty();
}

}  // namespace
}  // namespace muckpile::perf

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("perf_post MUCKPILE_POST PERF_POST_RUN FOLDER [BLOCKS]\n", stderr);
    return 2;
  }
  try {
    return muckpile::perf::measure(argv[1], argv[2], argv[3], argc > 4 ? argv[4] : "") ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "perf_post: %s\n", error.what());
    return 2;
  }
}
