// SPDX-License-Identifier: GPL-2.0-or-later
// Figures in the logs of runs that peers.sh, scaling.sh and ladder.sh start, and the words that
// they start them with.
// Scope: one figure or row for each call, on standard output; exit status 1 and a message where it
// is not there. Commands stand in main().
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "args/numbers.h"
#include "format.h"

namespace muckpile::benchmark {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

std::vector<Words> lines_of(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot be opened");
  std::vector<Words> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(words_of(line));
  return lines;
}

double number(const std::string& word, const std::string& where) {
  return parse_real(where, "a figure", word, "", Range::any());
}

/// Counted from 1, as in a table.
const std::string& column(const Words& words, std::size_t number, const std::string& where) {
  if (number == 0 || number > words.size())
    throw std::runtime_error(where + ": a line has no word " + std::to_string(number));
  return words[number - 1];
}

/// CPU time of the stretch `name` [s]: as printed, "seconds NAME TIME", or of the two last lines
/// "ticks NAME" with /proc/PID/stat behind, whose fields 14 and 15 are user and system time.
void print_seconds(const Words& args) {
  const std::string &name = args[0], &log = args[1];
  const auto tick = static_cast<double>(sysconf(_SC_CLK_TCK));
  std::optional<double> first, seconds;
  for (const Words& line : lines_of(log)) {
    if (line.size() < 3 || line[1] != name) continue;
    if (line[0] == "seconds") seconds = number(line[2], log);
    if (line[0] != "ticks") continue;
    const double ticks = number(column(line, 16, log), log) + number(column(line, 17, log), log);
    if (first) seconds = (ticks - *first) / tick;
    first = first.value_or(ticks);
  }
  if (!seconds || *seconds <= 0.0)
    throw std::runtime_error(log + ": has no time of '" + name + "'");
  std::cout << formatted("%.12g", *seconds) << '\n';
}

/// Word K of the line behind the last one whose end is WORD: of thermo output.
void print_below(const Words& args) {
  const std::string& log = args[2];
  const auto k = static_cast<std::size_t>(number(args[1], "below"));
  std::optional<double> value;
  const std::vector<Words> lines = lines_of(log);
  for (std::size_t n = 0; n + 1 < lines.size(); ++n)
    if (!lines[n].empty() && lines[n].back().ends_with(args[0]))
      value = number(column(lines[n + 1], k, log), log);
  if (!value) throw std::runtime_error(log + ": has nothing below '" + args[0] + "'");
  std::cout << formatted("%.12g", *value) << '\n';
}

/// Word K of the first line that begins with WORD.
void print_beside(const Words& args) {
  const std::string& log = args[2];
  const auto k = static_cast<std::size_t>(number(args[1], "beside"));
  for (const Words& line : lines_of(log))
    if (!line.empty() && line[0] == args[0]) {
      std::cout << formatted("%.12g", number(column(line, k, log), log)) << '\n';
      return;
    }
  throw std::runtime_error(log + ": has no line '" + args[0] + "'");
}

/// Spheres of a LIGGGHTS dump (id, body, x, y, z, radius) as a data file of LAMMPS for clumps of
/// 2500 kg/m3 in a box of SIDE by SIDE by 10 m.
void print_lammps_data(const Words& args) {
  const std::vector<Words> lines = lines_of(args[1]);
  constexpr std::size_t kHead = 9;
  const std::string side = args[0];
  const std::size_t count = lines.size() > kHead ? lines.size() - kHead : 0;
  if (count == 0) throw std::runtime_error(args[1] + ": has no spheres");
  std::cout << "clumps\n\n"
            << count << " atoms\n1 atom types\n0 bonds\n0 bond types\n0 " << side << " xlo xhi\n0 "
            << side << " ylo yhi\n0 10 zlo zhi\n\nAtoms\n\n";
  for (std::size_t n = kHead; n < lines.size(); ++n) {
    const Words& w = lines[n];
    const double radius = number(column(w, 6, args[1]), args[1]);
    std::cout << w[0] << " 1 " << w[2] << ' ' << w[3] << ' ' << w[4] << ' '
              << formatted("%.6g", 2.0 * radius) << " 2500 " << w[1] << '\n';
  }
}

struct Scaled {
  std::string blocks, joints, create, steps, wall;
};

/// The last loop counts.
Scaled scaled_in(const std::string& log) {
  Scaled found;
  for (const Words& w : lines_of(log)) {
    if (w.size() > 6 && w[0] == "create_blocks:" && w[2] == "blocks,") {
      found.blocks = w[1];
      found.joints = w[5];
    }
    if (w.size() > 2 && std::ranges::search(w, Words{"largest", "initial", "sphere", "overlap"}))
      found.create = w[w.size() - 2];
    if (w.size() > 3 && w[0] == "Loop" && w[1] == "time") {
      found.wall = w[3];
      const auto steps = std::ranges::find(w, "steps");
      if (steps != w.end() && steps != w.begin()) found.steps = *(steps - 1);
    }
  }
  return found;
}

/// A row of scaling.csv, of FOLDER/log and of FOLDER/rank.*, each with "MEMORY USER", in kB and s.
void print_scaling(const Words& args) {
  const std::filesystem::path folder = args[2];
  const std::string log = (folder / "log").string();
  double all = 0.0, most = 0.0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.path().filename().string().starts_with("rank.")) continue;
    const std::vector<Words> lines = lines_of(entry.path().string());
    const std::string where = entry.path().string();
    if (lines.empty()) throw std::runtime_error(where + ": is empty");
    const double memory = number(column(lines.back(), 1, where), where);
    all += memory;
    most = std::max(most, memory);
  }
  const Scaled s = scaled_in(log);
  const double per_step = 1e6 * number(s.wall, log) / number(s.blocks, log) / number(s.steps, log);
  std::cout << args[0] << ',' << args[1] << ',' << s.blocks << ',' << s.joints << ',' << s.create
            << ',' << s.steps << ',' << s.wall << ',' << formatted("%.4g", per_step) << ','
            << formatted("%.0f", most / 1024.0) << ',' << formatted("%.0f", all / 1024.0) << '\n';
}

/// The knobs of blocks whose median, smallest and largest are FACTOR times those given; the
/// smallest are no wider than MOST, where that is given.
void print_sizes(const Words& args) {
  const auto of = [&](std::size_t k) { return number(args[k], "sizes"); };
  const double factor = of(3), most = args.size() > 4 ? of(4) : factor * of(1);
  std::cout << formatted("-var fragment_x50 %.4g", factor * of(0))
            << formatted(" -var block_min %.4g", std::min(factor * of(1), most))
            << formatted(" -var block_max %.4g\n", factor * of(2));
}

struct Command {
  const char* words;
  std::size_t least, most;
  void (*print)(const Words&);
};
const std::map<std::string, Command> kCommands{
    {"seconds", {"NAME LOG", 2, 2, print_seconds}},
    {"below", {"WORD K LOG", 3, 3, print_below}},
    {"beside", {"WORD K LOG", 3, 3, print_beside}},
    {"lammps_data", {"SIDE DUMP", 2, 2, print_lammps_data}},
    {"scaling", {"SIZE NP FOLDER", 3, 3, print_scaling}},
    {"sizes", {"MEDIAN SMALLEST LARGEST FACTOR [MOST]", 4, 5, print_sizes}}};

int usage() {
  for (const auto& [name, command] : kCommands)
    std::cerr << "log_figures " << name << ' ' << command.words << '\n';
  return 2;
}

}  // namespace
}  // namespace muckpile::benchmark

int main(int argc, char** argv) {
  using namespace muckpile::benchmark;
  const Words args(argv + std::min(argc, 2), argv + argc);
  const auto found = argc > 1 ? kCommands.find(argv[1]) : kCommands.end();
  if (found == kCommands.end() || args.size() < found->second.least ||
      args.size() > found->second.most)
    return usage();
  try {
    found->second.print(args);
  } catch (const std::exception& error) {
    std::cerr << "log_figures: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
