// SPDX-License-Identifier: GPL-2.0-or-later
// Snapshots as the engine writes them.
// Scope: see the header.
#include "io/plain_snapshot.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "io/line_pieces.h"
#include "io/plain_number.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

constexpr std::string_view kHeader =
    "id,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,fragment_id,"
    "broken_fraction\n";
constexpr size_t kNumbers = 13;  // between id and fragment: place, rotation, velocity, spin
constexpr size_t kBeforeVelocity = 7;

struct PlainRow {
  double numbers[kNumbers], broken;
  int fragment;
};

// What stands behind the id, with the line end.
bool read_row(const char*& at, const char* end, PlainRow& row) {
  for (double& number : row.numbers)
    if (!read_number(at, end, number, ',')) return false;
  return read_number(at, end, row.fragment, ',') && read_number(at, end, row.broken, '\n');
}

// Eight bytes at a time, as rows are too short for a loop that the compiler makes wide: each byte
// of `sums` counts the commas at one of eight places, up to 255 of them.
std::ptrdiff_t commas_between(const char* at, const char* end) {
  constexpr std::uint64_t kOnes = 0x0101010101010101, kLow = 0x7F * kOnes;
  constexpr std::ptrdiff_t kTogether = 8 * 255;
  std::ptrdiff_t commas = 0;
  while (end - at >= 8) {
    const char* const stop = at + std::min(kTogether, (end - at) / 8 * 8);
    std::uint64_t sums = 0, bytes = 0;
    for (; at != stop; at += 8) {
      std::memcpy(&bytes, at, 8);
      bytes ^= ',' * kOnes;                               // 0 where a comma is
      bytes = ~(((bytes & kLow) + kLow) | bytes | kLow);  // then 0x80, 0 elsewhere
      sums += bytes >> 7;
    }
    for (; sums != 0; sums >>= 8) commas += static_cast<std::ptrdiff_t>(sums & 0xFF);
  }
  for (; at != end; ++at) commas += *at == ',' ? 1 : 0;
  return commas;
}

// Where a row ends, whatever is in its fields; null where it has another number of them.
const char* end_of_row(const char* at, const char* end) {
  const void* const found = std::memchr(at, '\n', static_cast<size_t>(end - at));
  if (found == nullptr) return nullptr;
  const char* const line_end = static_cast<const char*>(found);
  const bool whole = commas_between(at, line_end) == static_cast<std::ptrdiff_t>(kNumbers) + 1;
  return whole ? line_end : nullptr;
}

// Of a row that has all its fields.
bool read_velocity(const char* at, const char* line_end, Vec3& velocity) {
  for (size_t commas = 0; commas < kBeforeVelocity; ++at) commas += *at == ',' ? 1 : 0;
  return read_number(at, line_end, velocity.x(), ',') &&
         read_number(at, line_end, velocity.y(), ',') &&
         read_number(at, line_end, velocity.z(), ',');
}

class RowReader {
 public:
  RowReader(const std::vector<int>& ids, double unit_tolerance, const WantedStates& wanted,
            std::vector<BlockState>& states)
      : ids_(ids),
        first_(ids.empty() ? 0 : ids.front()),
        unit_tolerance_(unit_tolerance),
        wanted_(wanted),
        states_(states),
        seen_(ids.size(), 0) {}

  bool read(std::string_view rows) {
    const char *at = rows.data(), *end = at + rows.size();
    PlainRow row{};
    int id = 0;
    for (size_t hint = 0; at != end;) {
      if (!read_number(at, end, id, ',')) return false;
      const auto block = find(id, hint);
      if (!block || std::atomic_ref<char>(seen_[*block]).exchange(1) != 0) return false;
      const bool wanted = wanted_.of.empty() || wanted_.of[*block] != 0;
      if (wanted && wanted_.parts == StateParts::kAll) {
        if (!read_row(at, end, row) || !put(row, states_[*block])) return false;
      } else {
        const char* const line_end = end_of_row(at, end);
        if (line_end == nullptr) return false;
        if (wanted && !read_velocity(at, line_end, states_[*block].velocity)) return false;
        at = line_end + 1;
      }
      hint = *block + 1;
    }
    return true;
  }
  [[nodiscard]] bool has_seen_all() const { return std::ranges::find(seen_, 0) == seen_.end(); }

 private:
  // Ids mostly have no gaps, or rows follow each other as the blocks do.
  [[nodiscard]] std::optional<size_t> find(int id, size_t hint) const {
    const auto place = static_cast<size_t>(static_cast<long long>(id) - first_);
    if (place < ids_.size() && ids_[place] == id) return place;
    if (hint < ids_.size() && ids_[hint] == id) return hint;
    const auto found = std::ranges::lower_bound(ids_, id);
    if (found == ids_.end() || *found != id) return std::nullopt;
    return static_cast<size_t>(found - ids_.begin());
  }
  [[nodiscard]] bool put(const PlainRow& row, BlockState& state) const {
    const auto& n = row.numbers;
    const Quat rotation(n[3], n[4], n[5], n[6]);
    if (std::abs(rotation.norm() - 1.0) > unit_tolerance_) return false;
    state = {{n[0], n[1], n[2]},    rotation.normalized(), {n[7], n[8], n[9]},
             {n[10], n[11], n[12]}, row.fragment,          row.broken};
    return true;
  }

  const std::vector<int>& ids_;
  int first_;
  double unit_tolerance_;
  WantedStates wanted_;
  std::vector<BlockState>& states_;
  std::vector<char> seen_;
};

}  // namespace

bool read_plain_rows(std::string_view rows, const std::vector<int>& ids, double unit_tolerance,
                     const WantedStates& wanted, std::vector<BlockState>& states) {
  if (!rows.starts_with(kHeader)) return false;
  const std::vector<std::string_view> pieces = line_pieces(rows.substr(kHeader.size()));
  RowReader reader(ids, unit_tolerance, wanted, states);
  std::vector<char> plain(pieces.size(), 0);
  in_parallel(pieces.size(),
              [&](size_t piece) { plain[piece] = reader.read(pieces[piece]) ? 1 : 0; });
  return std::ranges::find(plain, 0) == plain.end() && reader.has_seen_all();
}

}  // namespace muckpile
