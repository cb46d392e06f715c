// SPDX-License-Identifier: GPL-2.0-or-later
// The cells of blocks.vtk as the engine writes them.
// Scope: see the header.
#include "io/plain_cells.h"

#include <algorithm>
#include <charconv>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>
#include <utility>

#include "geometry/files/cell_file.h"
#include "io/line_pieces.h"
#include "io/plain_number.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

constexpr int kPolyhedron = 42;       // VTK's type of cell
constexpr size_t kMostFaces = 65535;  // more are refused by name elsewhere

bool skip(FileWindow& in, std::string_view words) {
  if (!in.text().starts_with(words)) return false;
  in.skip(words.size());
  return true;
}

bool skip_line(FileWindow& in) {
  const size_t end = in.text().find('\n');
  if (end == std::string_view::npos) return false;
  in.skip(end + 1);
  return true;
}

bool read_count(FileWindow& in, size_t& value) {
  const std::string_view text = in.text();
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  in.skip(static_cast<size_t>(stop - text.data()));
  return error == std::errc();
}

size_t lines_of(std::string_view text) {
  return static_cast<size_t>(std::ranges::count(text, '\n'));
}

// The first `lines` of a text.
std::string_view first_lines(std::string_view text, size_t lines) {
  size_t length = 0;
  for (; lines > 0; --lines) length = text.find('\n', length) + 1;
  return text.substr(0, length);
}

// Of what the window holds, the whole lines, `most` of them at most, in pieces.
struct Pieces {
  Pieces(std::string_view text, size_t most) {
    text = text.substr(0, text.rfind('\n') + 1);
    texts = line_pieces(text);
    std::vector<size_t> counts(texts.size(), 0);
    in_parallel(texts.size(), [&](size_t k) { counts[k] = lines_of(texts[k]); });
    for (size_t k = 0; k < texts.size() && lines < most; ++k) {
      if (counts[k] > most - lines) {
        counts[k] = most - lines;
        texts[k] = first_lines(texts[k], counts[k]);
      }
      before.push_back(lines);
      lines += counts[k];
      bytes += texts[k].size();
    }
  }
  std::vector<std::string_view> texts;
  std::vector<size_t> before;  // lines before each piece; as many as there are pieces to read
  size_t lines = 0, bytes = 0;
};

// Calls read(text, number of its first line) for the next `lines` lines, some of them to a text, on
// all cores. False where it is false for one of them.
template <class Read>
bool read_texts(FileWindow& in, size_t lines, Read&& read) {
  for (size_t done = 0; done < lines;) {
    in.fill();
    const Pieces pieces(in.text(), lines - done);
    if (pieces.lines == 0) return false;
    std::vector<char> plain(pieces.before.size(), 0);
    in_parallel(plain.size(), [&](size_t k) {
      plain[k] = read(pieces.texts[k], done + pieces.before[k]) ? 1 : 0;
    });
    if (std::ranges::find(plain, 0) != plain.end()) return false;
    done += pieces.lines;
    in.skip(pieces.bytes);
  }
  in.fill();
  return true;
}

// The same for each line: `line` begins with it, and read() goes behind its end.
template <class Read>
bool read_lines(FileWindow& in, size_t lines, Read&& read) {
  return read_texts(in, lines, [&](std::string_view text, size_t number) {
    const char *line = text.data(), *end = line + text.size();
    for (; line != end; ++number)
      if (!read(line, end, number)) return false;
    return true;
  });
}

bool read_points(FileWindow& in, std::vector<Vec3>& points) {
  size_t count = 0;
  if (!read_count(in, count) || !skip(in, " double\n")) return false;
  if (count == 0 || in.file_size() / 6 < count) return false;
  points.resize(count);
  return read_lines(in, count, [&](const char*& at, const char* end, size_t line) {
    Vec3& p = points[line];
    return read_number(at, end, p.x(), ' ') && read_number(at, end, p.y(), ' ') &&
           read_number(at, end, p.z(), '\n');
  });
}

// Faces of the cells of some lines.
class CellLines {
 public:
  // Goes behind a cell's line. False where it is no plain one.
  bool read(const char*& at, const char* end, std::span<const Vec3> points) {
    Cell cell{corners_.size(), ends_.size(), 0, {}};
    if (!read_faces(at, end, cell)) return false;
    const std::span<int> corners = std::span(corners_).subspan(cell.corner);
    const auto [lowest, highest] = std::ranges::minmax(corners);
    if (lowest < 0 || static_cast<size_t>(highest) >= points.size()) return false;
    cell.points =
        points.subspan(static_cast<size_t>(lowest), static_cast<size_t>(highest - lowest) + 1);
    if (cell.points.size() > corners.size()) return false;
    for (int& corner : corners) corner -= lowest;
    if (!have_all(corners, cell.points.size())) return false;
    turn_outwards(cell);
    cells_.push_back(cell);
    return true;
  }
  void clear() { corners_.clear(), ends_.clear(), cells_.clear(); }
  [[nodiscard]] size_t size() const { return cells_.size(); }
  [[nodiscard]] FlatPolyhedron shape(size_t k) const {
    const Cell& cell = cells_[k];
    const auto ends = std::span(ends_).subspan(cell.end, cell.faces);
    return {cell.points,
            {std::span(corners_).subspan(cell.corner, static_cast<size_t>(ends.back())), ends}};
  }

 private:
  struct Cell {
    size_t corner, end, faces;  // where its lists begin
    std::span<const Vec3> points;
  };

  // The line's words are their count, the count of faces, and for each that of its corners and
  // these.
  bool read_faces(const char*& at, const char* end, Cell& cell) {
    size_t left = 0;
    const auto next = [&](auto& word) {
      return left > 0 && read_number(at, end, word, --left == 0 ? '\n' : ' ');
    };
    if (!read_number(at, end, left, ' ') || !next(cell.faces)) return false;
    if (cell.faces == 0 || cell.faces > kMostFaces) return false;
    for (size_t face = 0; face < cell.faces; ++face) {
      size_t count = 0;
      if (!next(count) || count < 3) return false;
      for (; count > 0; --count)
        if (!next(corners_.emplace_back())) return false;
      ends_.push_back(static_cast<int>(corners_.size() - cell.corner));
    }
    return left == 0;
  }
  // Whether each of the numbers below `count` is a corner.
  bool have_all(std::span<const int> corners, size_t count) {
    used_.assign(count, 0);
    for (const int corner : corners) used_[static_cast<size_t>(corner)] = 1;
    return std::ranges::find(used_, 0) == used_.end();
  }
  void turn_outwards(const Cell& cell) {
    int begin = 0;
    for (const int end : std::span(ends_).subspan(cell.end, cell.faces)) {
      const auto face = std::span(corners_).subspan(cell.corner + static_cast<size_t>(begin),
                                                    static_cast<size_t>(end - begin));
      if (faces_inwards(cell.points, face)) std::ranges::reverse(face);
      begin = end;
    }
  }

  std::vector<int> corners_, ends_;  // ends counted from a cell's first corner
  std::vector<Cell> cells_;
  std::vector<char> used_;
};

// What the shapes of a file lie in.
class ShapeMemory {
 public:
  std::vector<Vec3> points;
  // `lines` is a copy, as long as what it holds.
  const CellLines& keep(CellLines lines) {
    const std::lock_guard lock(one_by_one_);
    return lines_.emplace_back(std::move(lines));
  }

 private:
  std::mutex one_by_one_;
  std::deque<CellLines> lines_;
};

bool read_shapes(FileWindow& in, const std::shared_ptr<ShapeMemory>& memory,
                 std::vector<BlockShape>& shapes) {
  size_t cells = 0, words = 0;
  if (!read_count(in, cells) || !skip(in, " ") || !read_count(in, words) || !skip(in, "\n"))
    return false;
  if (cells == 0 || in.file_size() / 4 < cells) return false;
  shapes.resize(cells);
  return read_texts(in, cells, [&](std::string_view text, size_t number) {
    thread_local CellLines lines;
    lines.clear();
    for (const char *at = text.data(), *end = at + text.size(); at != end;)
      if (!lines.read(at, end, memory->points)) return false;
    const CellLines& kept = memory->keep(lines);
    for (size_t k = 0; k < kept.size(); ++k) shapes[number + k] = {kept.shape(k), memory};
    return true;
  });
}

bool read_types(FileWindow& in, size_t cells) {
  size_t types = 0;
  if (!read_count(in, types) || types != cells || !skip(in, "\n")) return false;
  return read_lines(in, cells, [](const char*& at, const char* end, size_t) {
    int type = 0;
    return read_number(at, end, type, '\n') && type == kPolyhedron;
  });
}

}  // namespace

std::optional<std::vector<BlockShape>> read_plain_cells(FileWindow& in) {
  const auto memory = std::make_shared<ShapeMemory>();
  std::vector<BlockShape> shapes;
  in.fill();
  const bool plain = skip(in, "# vtk DataFile Version 3.0\n") && skip_line(in) &&
                     skip(in, "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS ") &&
                     read_points(in, memory->points) && skip(in, "CELLS ") &&
                     read_shapes(in, memory, shapes) && skip(in, "CELL_TYPES ") &&
                     read_types(in, shapes.size());
  if (!plain) return std::nullopt;
  return shapes;
}

}  // namespace muckpile
