// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles of an STL file.
// Scope: see the header; numbers of a binary file are little-endian, as is this machine.
#include "geometry/files/stl_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/rounded_text.h"

namespace muckpile {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr size_t kHeader = 80, kCount = 4, kRecord = 50;  // bytes of a binary file
constexpr double kCoarsest = 0.05;                        // rounding of a coordinate [m]

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse(path.string(), "cannot be opened");
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

void require_area(const StlTriangle& t, const std::string& where) {
  constexpr double kFlat = 1e-12;  // twice the area over the square of an edge
  const Vec3 a = t[1] - t[0], b = t[2] - t[0];
  const double edge = std::max({a.squaredNorm(), b.squaredNorm(), (a - b).squaredNorm()});
  if (a.cross(b).norm() > kFlat * edge) return;
  std::ostringstream corner;
  corner << t[0].x() << ", " << t[0].y() << ", " << t[0].z();
  throw InputError(where + "the triangle at (" + corner.str() +
                   ") has no area; clean the mesh, or give its points as .xyz");
}

// The lines of a text file, which may hold several solids: facet, outer loop, three times vertex,
// endloop, endfacet.
class StlText {
 public:
  StlText(std::string path, const std::string& text) : path_(std::move(path)), in_(text) {}

  std::vector<StlTriangle> triangles(bool first_only) {
    for (std::string line; std::getline(in_, line);) {
      ++number_;
      std::istringstream words(line);
      std::string word;
      if (words >> word) take(word, words);
      if (first_only && word == "endsolid") break;
    }
    if (in_solid_)
      refuse(path_, "ends at line " + std::to_string(number_) + " without endsolid: it is cut");
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] std::string where() const { return path_ + ":" + std::to_string(number_) + ": "; }

  void take(const std::string& word, std::istringstream& words) {
    if (!in_solid_) {
      if (word != "solid" && number_ != 1)  // "solidpile" begins a file, too
        throw InputError(where() + "must begin with solid after endsolid, got '" + word + "'");
      in_solid_ = true;
    } else if (word == "vertex") {
      add_corner(words);
    } else if (word == "facet") {
      require_closed(word);
      in_facet_ = true;
      corners_ = 0;
    } else if (word == "endfacet") {
      if (corners_ != 3)
        throw InputError(where() + "a facet must have three vertices, got " +
                         std::to_string(corners_));
      require_area(triangle_, where());
      triangles_.push_back(triangle_);
      in_facet_ = false;
    } else if (word == "endsolid") {
      require_closed(word);
      in_solid_ = false;
    } else if (word != "outer" && word != "endloop") {
      throw InputError(where() + "must begin with a word of an STL file, got '" + word + "'");
    }
  }

  void require_closed(const std::string& word) const {
    if (in_facet_) throw InputError(where() + word + " before the endfacet of the facet before");
  }

  void add_corner(std::istringstream& words) {
    std::vector<std::string> numbers;
    for (std::string each; words >> each;) numbers.push_back(each);
    if (numbers.size() != 3)
      throw InputError(where() + "vertex must have three numbers, got " +
                       std::to_string(numbers.size()));
    if (corners_ == 3) throw InputError(where() + "a facet must have three vertices, got more");
    for (size_t axis = 0; axis < 3; ++axis)
      triangle_.at(corners_)[static_cast<Eigen::Index>(axis)] =
          parse_number(numbers[axis], where() + "vertex");
    ++corners_;
  }

  std::string path_;
  std::istringstream in_;
  size_t number_ = 0;  // of the line
  size_t corners_ = 0;
  bool in_solid_ = false, in_facet_ = false;
  StlTriangle triangle_;
  std::vector<StlTriangle> triangles_;
};

// A text file may be named "solid" only, and a binary header may begin with that word, too.
bool is_text(const std::string& bytes) {
  return bytes.starts_with("solid") && bytes.find('\0') == std::string::npos;
}

void require_fine(float value, double unit, const std::string& where) {
  if (!std::isfinite(value)) throw InputError(where + "has a corner that is no finite number");
  const float size = std::abs(value);
  const double step = unit * (std::nextafter(size, std::numeric_limits<float>::infinity()) - size);
  if (step <= kCoarsest) return;
  throw InputError(where + "has a coordinate of " + rounded_text(value) +
                   ", which a binary STL holds to " + rounded_text(step) +
                   " m only; export it from an origin near the pile, or as .xyz");
}

std::vector<StlTriangle> triangles_of_bytes(const std::string& path, const std::string& bytes,
                                            double unit) {
  if (bytes.size() < kHeader + kCount)
    refuse(path, "is no STL file: neither its text nor as long as a binary one's header");
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader, kCount);
  const size_t expected = kHeader + kCount + kRecord * count;
  if (bytes.size() != expected)
    refuse(path, "must have " + std::to_string(expected) + " bytes for its " +
                     std::to_string(count) + " triangles, got " + std::to_string(bytes.size()) +
                     "; it is cut, or no STL file");
  std::vector<StlTriangle> triangles(count);
  for (size_t k = 0; k < count; ++k) {
    constexpr size_t kNormal = 12;  // bytes before the corners
    float numbers[9];
    std::memcpy(numbers, bytes.data() + kHeader + kCount + kRecord * k + kNormal, sizeof numbers);
    const std::string where = path + ": triangle " + std::to_string(k + 1) + ": ";
    for (size_t n = 0; n < 9; ++n) {
      require_fine(numbers[n], unit, where);
      triangles[k].at(n / 3)[static_cast<Eigen::Index>(n % 3)] = static_cast<double>(numbers[n]);
    }
    require_area(triangles[k], where);
  }
  return triangles;
}

std::vector<StlTriangle> triangles_in(const std::filesystem::path& path, double unit,
                                      bool first_only) {
  const std::string bytes = bytes_of(path);
  if (bytes.empty()) refuse(path.string(), "is empty");
  std::vector<StlTriangle> triangles = is_text(bytes)
                                           ? StlText(path.string(), bytes).triangles(first_only)
                                           : triangles_of_bytes(path.string(), bytes, unit);
  if (triangles.empty()) refuse(path.string(), "has no triangles");
  for (StlTriangle& triangle : triangles)
    for (Vec3& corner : triangle) corner *= unit;
  return triangles;
}

}  // namespace

std::vector<StlTriangle> read_stl(const std::filesystem::path& path, double unit) {
  return triangles_in(path, unit, false);
}

std::vector<StlTriangle> read_first_solid(const std::filesystem::path& path, double unit) {
  return triangles_in(path, unit, true);
}

}  // namespace muckpile
