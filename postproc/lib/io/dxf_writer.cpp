// SPDX-License-Identifier: GPL-2.0-or-later
// Drawings in DXF: lines and outlines out.
// Scope: see the header; release 12.
#include "io/dxf_writer.h"

#include <algorithm>
#include <cctype>

#include "args/input_error.h"

namespace muckpile {
namespace {

std::string layer_name(std::string name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  std::ranges::replace_if(
      name, [&](unsigned char c) { return !fits(c); }, '_');
  return name;
}

}  // namespace

DxfWriter::DxfWriter(const std::filesystem::path& path) : out_(path) {
  out_.precision(12);  // coordinates of a mine grid to the millimetre
  out_ << "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  if (!out_) refuse(path.string(), "cannot be written");
}

DxfWriter::~DxfWriter() { out_ << "0\nENDSEC\n0\nEOF\n"; }

void DxfWriter::line(const std::string& layer, const Vec3& from, const Vec3& to) {
  begin("LINE", layer);
  place(10, from);
  place(11, to);
}

void DxfWriter::outline(const std::string& layer, const std::vector<Vec3>& corners) {
  constexpr int kClosed = 1, kInSpace = 8, kOfLineInSpace = 32;
  begin("POLYLINE", layer);
  out_ << "66\n1\n70\n" << (kClosed | kInSpace) << '\n';
  place(10, Vec3::Zero());
  for (const Vec3& corner : corners) {
    begin("VERTEX", layer);
    place(10, corner);
    out_ << "70\n" << kOfLineInSpace << '\n';
  }
  begin("SEQEND", layer);
}

void DxfWriter::text(const std::string& layer, const Vec3& where, double height,
                     const std::string& words) {
  begin("TEXT", layer);
  place(10, where);
  out_ << "40\n" << height << "\n1\n" << words << '\n';
}

void DxfWriter::begin(const char* kind, const std::string& layer) {
  out_ << "0\n" << kind << "\n8\n" << layer_name(layer) << '\n';
}

void DxfWriter::place(int code, const Vec3& point) {
  for (int axis = 0; axis < 3; ++axis) out_ << code + 10 * axis << '\n' << point[axis] << '\n';
}

}  // namespace muckpile
