// SPDX-License-Identifier: GPL-2.0-or-later
// The cells of blocks.vtk as the engine writes them.
// Scope: see the header.
#include "io/plain_cells.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

struct Piece {
  std::string_view text;  // whole words, each with what stands behind it
  size_t first = 0;       // number of the first of them
};

bool is_between(char c) { return c == ' ' || c == '\n'; }

std::vector<Piece> pieces_of(std::string_view text) {
  constexpr size_t kPiece = 1 << 20;  // bytes
  std::vector<Piece> pieces;
  while (!text.empty()) {
    size_t length = std::min(kPiece, text.size());
    while (length < text.size() && !is_between(text[length - 1])) ++length;
    pieces.push_back({text.substr(0, length), 0});
    text.remove_prefix(length);
  }
  return pieces;
}

// How many words there are, if they are plain; each piece learns its first.
size_t count_words(std::vector<Piece>& pieces) {
  std::vector<size_t> words(pieces.size());
  in_parallel(pieces.size(), [&](size_t k) {
    words[k] = static_cast<size_t>(std::ranges::count(pieces[k].text, ' ') +
                                   std::ranges::count(pieces[k].text, '\n'));
  });
  size_t sum = 0;
  for (size_t k = 0; k < pieces.size(); ++k) {
    pieces[k].first = sum;
    sum += words[k];
  }
  return sum;
}

// All words of a piece into their places from `to` on, of which there are `room`.
template <class Number>
bool read_piece(std::string_view text, Number* to, size_t room) {
  const char *at = text.data(), *end = at + text.size();
  for (; at != end; ++to, --room) {
    const auto [stop, error] = std::from_chars(at, end, *to);
    if (room == 0 || error != std::errc() || stop == end || !is_between(*stop)) return false;
    if (!std::isfinite(static_cast<double>(*to))) return false;
    at = stop + 1;
  }
  return true;
}

template <class Number>
bool read_words(const std::vector<Piece>& pieces, size_t words, Number* to) {
  std::vector<char> plain(pieces.size(), 0);
  in_parallel(pieces.size(), [&](size_t k) {
    const size_t end = k + 1 < pieces.size() ? pieces[k + 1].first : words;
    plain[k] = read_piece(pieces[k].text, to + pieces[k].first, end - pieces[k].first) ? 1 : 0;
  });
  return std::ranges::find(plain, 0) == plain.end();
}

// A text from its front to its back.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}
  [[nodiscard]] size_t at() const { return at_; }
  bool skip(std::string_view words) {
    if (!text_.substr(at_).starts_with(words)) return false;
    at_ += words.size();
    return true;
  }
  bool skip_line() { return skip_behind("\n"); }
  bool number(size_t& value) {
    const char *from = text_.data() + at_, *end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(from, end, value);
    at_ += static_cast<size_t>(stop - from);
    return error == std::errc();
  }
  // What stands before the line that begins with `words`.
  std::string_view until(std::string_view words) {
    const size_t from = at_;
    return skip_behind(words) ? text_.substr(from, at_ - words.size() - from) : std::string_view();
  }

 private:
  bool skip_behind(std::string_view words) {
    const size_t found = text_.find(words, at_);
    if (found == std::string_view::npos) return false;
    at_ = found + words.size();
    return true;
  }

  std::string_view text_;
  size_t at_ = 0;
};

bool read_points(std::string_view text, size_t count, std::vector<Vec3>& points) {
  std::vector<Piece> pieces = pieces_of(text);
  if (count == 0 || text.size() / 6 < count || count_words(pieces) != 3 * count) return false;
  points.resize(count);
  return read_words(pieces, 3 * count, points.front().data());
}

bool read_lists(std::string_view text, size_t cells, CellTable& table) {
  std::vector<Piece> pieces = pieces_of(text);
  const size_t words = count_words(pieces);
  table.words.resize(words);
  return words > 0 && read_words(pieces, words, table.words.data()) && table.find_cells(cells);
}

bool read_types(Cursor& cursor, size_t cells, CellTable& table) {
  for (size_t type = 0; cells > 0; --cells) {
    if (!cursor.number(type) || type > 255 || !cursor.skip("\n")) return false;
    table.types.push_back(static_cast<int>(type));
  }
  return true;
}

}  // namespace

std::optional<CellTable> read_plain_cells(std::string_view text, size_t& length) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));  // points lie one behind the other
  Cursor cursor(text);
  CellTable table;
  size_t points = 0, cells = 0, words = 0, types = 0;
  const bool plain =
      cursor.skip("# vtk DataFile Version 3.0\n") && cursor.skip_line() &&
      cursor.skip("ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS ") && cursor.number(points) &&
      cursor.skip(" double\n") && read_points(cursor.until("CELLS "), points, table.points) &&
      cursor.number(cells) && cursor.skip(" ") && cursor.number(words) && cursor.skip("\n") &&
      read_lists(cursor.until("CELL_TYPES "), cells, table) && cursor.number(types) &&
      types == cells && cells > 0 && cursor.skip("\n") && read_types(cursor, cells, table);
  if (!plain) return std::nullopt;
  length = cursor.at();
  return table;
}

}  // namespace muckpile
