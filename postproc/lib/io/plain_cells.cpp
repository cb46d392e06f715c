// SPDX-License-Identifier: GPL-2.0-or-later
// The cells of blocks.vtk as the engine writes them.
// Scope: see the header.
#include "io/plain_cells.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "geometry/files/cell_file.h"
#include "io/line_pieces.h"
#include "io/plain_number.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

constexpr int kPolyhedron = 42;  // VTK's type of cell

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

// Calls read(line, number of the line) for each of the next `lines` lines, on all cores; `line`
// begins with the line, and read() goes behind its end. False where it is false for one of them.
template <class Read>
bool read_lines(FileWindow& in, size_t lines, Read&& read) {
  for (size_t done = 0; done < lines;) {
    in.fill();
    const Pieces pieces(in.text(), lines - done);
    if (pieces.lines == 0) return false;
    std::vector<char> plain(pieces.before.size(), 0);
    in_parallel(plain.size(), [&](size_t k) {
      const char *at = pieces.texts[k].data(), *end = at + pieces.texts[k].size();
      size_t line = done + pieces.before[k];
      for (; at != end; ++line)
        if (!read(at, end, line)) return;
      plain[k] = 1;
    });
    if (std::ranges::find(plain, 0) != plain.end()) return false;
    done += pieces.lines;
    in.skip(pieces.bytes);
  }
  in.fill();
  return true;
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

// The words of a cell's line behind their count. False where there are not as many.
bool read_words(const char*& at, const char* end, std::vector<int>& words) {
  size_t count = 0;
  if (!read_number(at, end, count, ' ') || count == 0 || static_cast<size_t>(end - at) < count)
    return false;
  words.resize(count);
  for (size_t k = 0; k + 1 < count; ++k)
    if (!read_number(at, end, words[k], ' ')) return false;
  return read_number(at, end, words.back(), '\n');
}

bool read_shapes(FileWindow& in, const std::vector<Vec3>& points, std::vector<Polyhedron>& shapes) {
  size_t cells = 0, words = 0;
  if (!read_count(in, cells) || !skip(in, " ") || !read_count(in, words) || !skip(in, "\n"))
    return false;
  if (cells == 0 || in.file_size() / 4 < cells) return false;
  shapes.resize(cells);
  return read_lines(in, cells, [&](const char*& at, const char* end, size_t line) {
    thread_local std::vector<int> list;
    if (!read_words(at, end, list)) return false;
    shapes[line] = cell_of(list, kPolyhedron, points, line);
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

std::optional<std::vector<Polyhedron>> read_plain_cells(FileWindow& in) {
  std::vector<Vec3> points;
  std::vector<Polyhedron> shapes;
  in.fill();
  const bool plain = skip(in, "# vtk DataFile Version 3.0\n") && skip_line(in) &&
                     skip(in, "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS ") &&
                     read_points(in, points) && skip(in, "CELLS ") &&
                     read_shapes(in, points, shapes) && skip(in, "CELL_TYPES ") &&
                     read_types(in, shapes.size());
  if (!plain) return std::nullopt;
  return shapes;
}

}  // namespace muckpile
