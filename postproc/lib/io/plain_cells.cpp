// SPDX-License-Identifier: GPL-2.0-or-later
// The cells of blocks.vtk as the engine writes them.
// Scope: see the header.
#include "io/plain_cells.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <vector>

#include "io/line_pieces.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

bool is_between(char c) { return c == ' ' || c == '\n'; }

// The number of each piece's first word, and behind them how many words there are, if they are
// plain.
std::vector<size_t> first_words(const std::vector<std::string_view>& pieces) {
  std::vector<size_t> first(pieces.size() + 1, 0);
  in_parallel(pieces.size(), [&](size_t k) {
    first[k + 1] = static_cast<size_t>(std::ranges::count(pieces[k], ' ') +
                                       std::ranges::count(pieces[k], '\n'));
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

// The words of a piece into their places from `to` on. False if there are not `count` of them.
template <class Number>
bool read_piece(std::string_view text, Number* to, size_t count) {
  const char *at = text.data(), *end = at + text.size();
  for (; count > 0; ++to, --count) {
    const auto [stop, error] = std::from_chars(at, end, *to);
    if (error != std::errc() || stop == end || !is_between(*stop)) return false;
    if (!std::isfinite(static_cast<double>(*to))) return false;
    at = stop + 1;
  }
  return at == end;
}

template <class Number>
bool read_words(const std::vector<std::string_view>& pieces, const std::vector<size_t>& first,
                Number* to) {
  std::vector<char> plain(pieces.size(), 0);
  in_parallel(pieces.size(), [&](size_t k) {
    plain[k] = read_piece(pieces[k], to + first[k], first[k + 1] - first[k]) ? 1 : 0;
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
  // The lines before the one that begins with `words`, or nothing where no line does.
  std::string_view until(std::string_view words) {
    const size_t from = at_;
    if (!skip_behind(words)) return {};
    const std::string_view before = text_.substr(from, at_ - words.size() - from);
    return before.ends_with('\n') ? before : std::string_view();
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
  const std::vector<std::string_view> pieces = line_pieces(text);
  const std::vector<size_t> first = first_words(pieces);
  if (count == 0 || text.size() / 6 < count || first.back() != 3 * count) return false;
  points.resize(count);
  return read_words(pieces, first, points.front().data());
}

bool read_lists(std::string_view text, size_t cells, CellTable& table) {
  const std::vector<std::string_view> pieces = line_pieces(text);
  const std::vector<size_t> first = first_words(pieces);
  table.words.resize(first.back());
  return !table.words.empty() && read_words(pieces, first, table.words.data()) &&
         table.find_cells(cells);
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
