// SPDX-License-Identifier: GPL-2.0-or-later
// Frames of a text dump (dump custom), which LIGGGHTS and LAMMPS write alike.
// Scope: see the header.
#include "text_dump.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace muckpile::crosscheck {

std::vector<Frame> read_dump(const std::filesystem::path& path, std::size_t columns) {
  std::ifstream in(path);
  const auto line = [&] {
    std::string text;
    if (!std::getline(in, text)) throw std::runtime_error(path.string() + ": ends within a frame");
    return text;
  };
  std::vector<Frame> frames;
  for (std::string head; std::getline(in, head);) {  // ITEM: TIMESTEP
    Frame frame;
    frame.step = std::stol(line());
    line();
    const std::size_t count = std::stoul(line());
    for (int k = 0; k < 5; ++k) line();  // the box and the names of the columns
    for (std::size_t r = 0; r < count; ++r) {
      std::istringstream words(line());
      std::vector<double> row;
      for (double value = 0.0; words >> value;) row.push_back(value);
      if (row.size() != columns || !words.eof())
        throw std::runtime_error(path.string() + ": bad row in the frame of step " +
                                 std::to_string(frame.step));
      frame.rows.push_back(std::move(row));
    }
    frames.push_back(std::move(frame));
  }
  if (frames.empty()) throw std::runtime_error(path.string() + ": holds no frame");
  return frames;
}

}  // namespace muckpile::crosscheck
