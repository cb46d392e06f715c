// SPDX-License-Identifier: GPL-2.0-or-later
// Points of a LAS file.
// Scope: see the header; its numbers are little-endian, as are this machine's.
#include "geometry/files/las_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

static_assert(std::endian::native == std::endian::little);

// Bytes from the file's beginning (LAS 1.4 R15, public header block).
constexpr size_t kMinorVersion = 25, kHeaderSize = 94, kFirstPoint = 96, kFormat = 104,
                 kRecordLength = 105, kLegacyCount = 107, kScales = 131, kOffsets = 155, kBox = 179,
                 kLeastHeader = 227, kCount14 = 247, kLeastHeader14 = 375;

template <class Number>
Number number_at(const std::string& bytes, size_t place) {
  Number value{};
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

size_t least_record(int format) {
  constexpr std::array<size_t, 9> kLengths{20, 28, 26, 34, 0, 0, 30, 36, 38};
  return format < static_cast<int>(kLengths.size()) ? kLengths.at(static_cast<size_t>(format)) : 0;
}

struct Header {
  size_t first = 0, length = 0, count = 0;  // bytes, bytes, points
  int format = 0;
  Vec3 scale, offset, low, high;
};

void require_begin(const std::string& path, const std::string& bytes) {
  if (!bytes.starts_with("LASF")) refuse(path, "is no LAS file: it does not begin with LASF");
  if (bytes.size() < kLeastHeader)
    refuse(path, "is cut: it has " + std::to_string(bytes.size()) + " bytes, its header alone " +
                     std::to_string(kLeastHeader));
  const int major = bytes[kMinorVersion - 1], minor = bytes[kMinorVersion];
  if (major != 1 || minor < 0 || minor > 4)
    refuse(path,
           "must be LAS 1.0 to 1.4, got " + std::to_string(major) + "." + std::to_string(minor));
}

int format_of(const std::string& path, const std::string& bytes) {
  const int format = number_at<std::uint8_t>(bytes, kFormat);
  if (format >= 64)
    refuse(path, "is compressed (LAZ); expand it to LAS, by las2las or pdal translate, say");
  if (least_record(format) == 0)
    refuse(path, "must have points of format 0 to 3 or 6 to 8, got " + std::to_string(format));
  return format;
}

Header header_of(const std::string& path, const std::string& bytes) {
  require_begin(path, bytes);
  Header h;
  h.format = format_of(path, bytes);
  h.first = number_at<std::uint32_t>(bytes, kFirstPoint);
  h.length = number_at<std::uint16_t>(bytes, kRecordLength);
  h.count = number_at<std::uint32_t>(bytes, kLegacyCount);
  const size_t header = number_at<std::uint16_t>(bytes, kHeaderSize);
  if (bytes[kMinorVersion] == 4) {
    if (bytes.size() < kLeastHeader14 || header < kLeastHeader14)
      refuse(path, "must have a header of 375 bytes, as LAS 1.4 has");
    h.count = number_at<std::uint64_t>(bytes, kCount14);
  }
  if (header < kLeastHeader || h.first < header)
    refuse(path, "has points that begin within its header: it is damaged");
  if (h.length < least_record(h.format))
    refuse(path, "must have at least " + std::to_string(least_record(h.format)) +
                     " bytes per point of format " + std::to_string(h.format) + ", got " +
                     std::to_string(h.length));
  if (bytes.size() < h.first || (bytes.size() - h.first) / h.length < h.count)
    refuse(path, "is cut: its header tells " + std::to_string(h.count) + " points, " +
                     std::to_string(bytes.size()) + " bytes hold fewer");
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    h.scale[k] = number_at<double>(bytes, kScales + 8 * axis);
    h.offset[k] = number_at<double>(bytes, kOffsets + 8 * axis);
    h.high[k] = number_at<double>(bytes, kBox + 16 * axis);
    h.low[k] = number_at<double>(bytes, kBox + 16 * axis + 8);
  }
  if (!h.scale.allFinite() || !h.offset.allFinite() || !(h.scale.minCoeff() > 0.0))
    refuse(path,
           "has scales or offsets that are no finite numbers, or no scale > 0: it is damaged");
  return h;
}

// Withheld, or noise by its class.
bool is_left_out(const std::string& bytes, size_t place, int format) {
  constexpr size_t kFlags = 15, kClass6 = 16;  // in format 0 to 5 both are in one byte
  const unsigned flags = number_at<std::uint8_t>(bytes, place + kFlags);
  const bool old = format < 6;
  const unsigned kind = old ? flags & 0x1FU : number_at<std::uint8_t>(bytes, place + kClass6);
  const bool withheld = (flags & (old ? 0x80U : 0x04U)) != 0;
  return withheld || kind == 7 || kind == 18;
}

Vec3 point_at(const std::string& bytes, size_t place, const Header& h) {
  Vec3 point;
  for (size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    point[k] = number_at<std::int32_t>(bytes, place + 4 * axis) * h.scale[k] + h.offset[k];
  }
  return point;
}

}  // namespace

std::vector<Vec3> read_las(const std::filesystem::path& path) {
  const std::string bytes = whole_file(path);
  const Header h = header_of(path.string(), bytes);
  const Vec3 room = 1.01 * h.scale;  // the box may be rounded
  std::vector<Vec3> points;
  points.reserve(h.count);
  for (size_t k = 0; k < h.count; ++k) {
    const size_t place = h.first + k * h.length;
    const Vec3 point = point_at(bytes, place, h);
    if (((point - h.low + room).array() < 0.0).any() ||
        ((h.high + room - point).array() < 0.0).any())
      refuse(path.string(), "point " + std::to_string(k + 1) +
                                " lies outside of the box that the header tells: one of them is "
                                "damaged");
    if (!is_left_out(bytes, place, h.format)) points.push_back(point);
  }
  if (points.size() < 3)
    refuse(path.string(),
           "must have three points at least that are neither withheld nor noise, "
           "got " +
               std::to_string(points.size()));
  return points;
}

}  // namespace muckpile
