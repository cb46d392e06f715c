// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of a snapshot as bytes.
// Scope: see the header.
#include "state/packed_rows.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "args/input_error.h"

namespace muckpile {
namespace {

static_assert(std::endian::native == std::endian::little, "rows are written as they are kept");

constexpr std::string_view kHeader =
    "packed i4 id f8 x_m y_m z_m i4/2147483647 qw qx qy qz f4 vx_m_s vy_m_s vz_m_s wx_rad_s "
    "wy_rad_s wz_rad_s i4 fragment_id f4 broken_fraction\n";

/// A float of a turn would move the far corner of a large fragment too far.
constexpr double kTurnUnit = 2147483647.0;

struct Row {
  std::int32_t id;
  std::array<double, 3> centre;
  std::array<std::int32_t, 4> turn;  // w, x, y, z in kTurnUnit
  std::array<float, 6> motion;       // velocity and spin
  std::int32_t fragment;
  float broken_share;
};
constexpr std::size_t kRowBytes = sizeof(Row::id) + sizeof(Row::centre) + sizeof(Row::turn) +
                                  sizeof(Row::motion) + sizeof(Row::fragment) +
                                  sizeof(Row::broken_share);

/// Calls f for each part of the row, in order: a struct may have gaps, the file has none.
template <class AnyRow, class F>
void each_part(AnyRow& row, F f) {
  f(row.id);
  f(row.centre);
  f(row.turn);
  f(row.motion);
  f(row.fragment);
  f(row.broken_share);
}

bool is_sound(const BlockRow& row) {
  constexpr double kUnit = 1e-4;  // 31 bits leave a unit quaternion within 1e-9
  return row.centre.allFinite() && row.velocity.allFinite() && row.spin.allFinite() &&
         std::abs(row.turn.norm() - 1.0) <= kUnit && std::isfinite(row.broken_share);
}

}  // namespace

std::string_view packed_header() { return kHeader; }

void pack(const BlockRow& row, std::string& rows) {
  const Quat q = row.turn.normalized();
  const auto in_units = [](double share) {
    return static_cast<std::int32_t>(std::lround(share * kTurnUnit));
  };
  const auto f = [](double number) { return static_cast<float>(number); };
  const Vec3 &c = row.centre, &v = row.velocity, &w = row.spin;
  const Row kept{row.id,
                 {c.x(), c.y(), c.z()},
                 {in_units(q.w()), in_units(q.x()), in_units(q.y()), in_units(q.z())},
                 {f(v.x()), f(v.y()), f(v.z()), f(w.x()), f(w.y()), f(w.z())},
                 row.fragment,
                 f(row.broken_share)};
  each_part(kept, [&](const auto& part) {
    rows.append(reinterpret_cast<const char*>(&part), sizeof(part));
  });
}

PackedRows::PackedRows(std::string_view text, std::string file)
    : rows_(text), file_(std::move(file)) {
  if (!rows_.starts_with(kHeader))
    refuse(file_, "the second line of packed rows must name their numbers; the file is damaged");
  rows_.remove_prefix(kHeader.size());
  if (rows_.size() % kRowBytes != 0)
    refuse(file_,
           "the last of its packed rows of " + std::to_string(kRowBytes) + " bytes is cut short");
}

std::size_t PackedRows::count() const { return rows_.size() / kRowBytes; }

BlockRow PackedRows::at(std::size_t row) const {
  Row kept;
  const char* from = rows_.data() + row * kRowBytes;
  each_part(kept, [&](auto& part) {
    std::memcpy(&part, from, sizeof(part));
    from += sizeof(part);
  });
  const auto& c = kept.centre;
  const auto& q = kept.turn;
  const auto& m = kept.motion;
  BlockRow block{kept.id,
                 Vec3(c[0], c[1], c[2]),
                 Quat(q[0] / kTurnUnit, q[1] / kTurnUnit, q[2] / kTurnUnit, q[3] / kTurnUnit),
                 Vec3(m[0], m[1], m[2]),
                 Vec3(m[3], m[4], m[5]),
                 kept.fragment,
                 kept.broken_share};
  if (!is_sound(block))
    throw InputError(where(row) +
                     "numbers must be finite and qw, qx, qy, qz a unit quaternion; the file is "
                     "damaged");
  block.turn.normalize();
  return block;
}

std::string PackedRows::where(std::size_t row) const {
  return file_ + ": row " + std::to_string(row + 1) + ": ";
}

}  // namespace muckpile
