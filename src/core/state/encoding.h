// SPDX-License-Identifier: GPL-2.0-or-later
// How each kind of type lies in bytes: numbers, vectors, lists, texts, optional values, structs.
// Scope: field by field, so that no padding is written and equal values give equal bytes.
//
// Each kind has an Encoding: put() and get(); kLeast, the bytes that it takes at least; layout(),
// a word for it (below); and list(), which adds the stored types in it, inner ones first.
//
//   b1, i4, u8, f8   bool, int, unsigned, floating point, by their bytes     e1   enumeration
//   f8(3x1)          fixed vector or matrix, by columns                      text string
//   X[2], X[], X?    array, list (its length before it), optional value      name stored struct
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "math/types.h"
#include "state/bytes.h"
#include "state/stored.h"

namespace muckpile {

/// Word for a type in the list of layouts.
template <class T>
[[nodiscard]] std::string layout_of() {
  return Encoding<T>::layout();
}

/// The stored types in T, itself included, each once and behind those that it is made of.
template <class T>
[[nodiscard]] StoredTypes stored_types() {
  StoredTypes types;
  Encoding<T>::list(types);
  return types;
}

template <class T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T>
struct Encoding<T> {
  static constexpr std::size_t kLeast = sizeof(T);
  static void put(ByteWriter& out, const T& value) { out.put_bytes(&value, sizeof(value)); }
  static void get(ByteReader& in, T& value) { in.get_bytes(&value, sizeof(value)); }
  static std::string layout() {
    const char* kind = std::is_enum_v<T>             ? "e"
                       : std::is_floating_point_v<T> ? "f"
                       : std::is_signed_v<T>         ? "i"
                                                     : "u";
    return std::string(kind) + std::to_string(sizeof(T));
  }
  static void list(StoredTypes&) {}
};

template <>
struct Encoding<bool> {
  static constexpr std::size_t kLeast = 1;
  static void put(ByteWriter& out, bool value) { out.put<std::uint8_t>(value ? 1 : 0); }
  static void get(ByteReader& in, bool& value) {
    const auto byte = in.get<std::uint8_t>();
    if (byte > 1) in.fail(std::string("has a yes or no of value ") + std::to_string(byte));
    value = byte == 1;
  }
  static std::string layout() { return "b1"; }
  static void list(StoredTypes&) {}
};

template <class Number, int kRows, int kColumns>
requires(kRows > 0 && kColumns > 0) struct Encoding<Eigen::Matrix<Number, kRows, kColumns>> {
  using Matrix = Eigen::Matrix<Number, kRows, kColumns>;
  static constexpr std::size_t kLeast = sizeof(Number) * kRows * kColumns;
  static void put(ByteWriter& out, const Matrix& value) { out.put_bytes(value.data(), kLeast); }
  static void get(ByteReader& in, Matrix& value) { in.get_bytes(value.data(), kLeast); }
  static std::string layout() {
    return layout_of<Number>() + '(' + std::to_string(kRows) + 'x' + std::to_string(kColumns) + ')';
  }
  static void list(StoredTypes&) {}
};

template <class T, std::size_t kCount>
struct Encoding<std::array<T, kCount>> {
  static constexpr std::size_t kLeast = kCount * Encoding<T>::kLeast;
  static void put(ByteWriter& out, const std::array<T, kCount>& values) {
    for (const T& value : values) out.put(value);
  }
  static void get(ByteReader& in, std::array<T, kCount>& values) {
    for (T& value : values) in.get(value);
  }
  static std::string layout() { return layout_of<T>() + '[' + std::to_string(kCount) + ']'; }
  static void list(StoredTypes& types) { Encoding<T>::list(types); }
};

template <class T>
struct Encoding<std::vector<T>> {
  static constexpr std::size_t kLeast = sizeof(std::uint64_t);
  static void put(ByteWriter& out, const std::vector<T>& values) {
    out.put<std::uint64_t>(values.size());
    for (const T& value : values) out.put(value);
  }
  static void get(ByteReader& in, std::vector<T>& values) {
    values.resize(in.get_count(Encoding<T>::kLeast));
    for (T& value : values) in.get(value);
  }
  static std::string layout() { return layout_of<T>() + "[]"; }
  static void list(StoredTypes& types) { Encoding<T>::list(types); }
};

template <>
struct Encoding<std::string> {
  static constexpr std::size_t kLeast = sizeof(std::uint64_t);
  static void put(ByteWriter& out, const std::string& text) {
    out.put<std::uint64_t>(text.size());
    out.put_bytes(text.data(), text.size());
  }
  static void get(ByteReader& in, std::string& text) {
    text.resize(in.get_count(1));
    in.get_bytes(text.data(), text.size());
  }
  static std::string layout() { return "text"; }
  static void list(StoredTypes&) {}
};

template <class T>
struct Encoding<std::optional<T>> {
  static constexpr std::size_t kLeast = 1;
  static void put(ByteWriter& out, const std::optional<T>& value) {
    out.put(value.has_value());
    if (value) out.put(*value);
  }
  static void get(ByteReader& in, std::optional<T>& value) {
    value.reset();
    if (in.get<bool>()) in.get(value.emplace());
  }
  static std::string layout() { return layout_of<T>() + '?'; }
  static void list(StoredTypes& types) { Encoding<T>::list(types); }
};

/// Adds T to the list, unless it is there.
template <class T>
void list_stored(StoredTypes& types, const std::string& layout) {
  const auto same = [](const StoredType& type) { return type.name == Stored<T>::kName; };
  if (std::ranges::any_of(types, same)) return;
  types.push_back({std::string(Stored<T>::kName), Stored<T>::kVersion, layout, sizeof(T)});
}

template <class Fields>
struct FieldEncoding;

template <class... Field>
struct FieldEncoding<std::tuple<Field&...>> {
  static constexpr std::size_t kLeast = (std::size_t{0} + ... + Encoding<Field>::kLeast);
  static std::string layout() {
    std::string all;
    ((all.append(all.empty() ? "" : " ").append(layout_of<Field>())), ...);
    return all;
  }
  static void list(StoredTypes& types) { (Encoding<Field>::list(types), ...); }
};

template <StoredByFields T>
struct Encoding<T> {
  using Fields = FieldEncoding<decltype(Stored<T>::fields(std::declval<T&>()))>;
  static constexpr std::size_t kLeast = Fields::kLeast;
  static void put(ByteWriter& out, const T& value) {
    std::apply([&out](const auto&... field) { (out.put(field), ...); }, Stored<T>::fields(value));
  }
  static void get(ByteReader& in, T& value) {
    const ByteReader::Naming naming(in, Stored<T>::kName);
    std::apply([&in](auto&... field) { (in.get(field), ...); }, Stored<T>::fields(value));
  }
  static std::string layout() { return std::string(Stored<T>::kName); }
  static void list(StoredTypes& types) {
    Fields::list(types);
    list_stored<T>(types, Fields::layout());
  }
};

template <StoredByImage T>
struct Encoding<T> {
  using Image = typename Stored<T>::Image;
  static constexpr std::size_t kLeast = Encoding<Image>::kLeast;
  static void put(ByteWriter& out, const T& value) { out.put(Stored<T>::image(value)); }
  static void get(ByteReader& in, T& value) {
    const ByteReader::Naming naming(in, Stored<T>::kName);
    value = Stored<T>::of(in.get<Image>());
  }
  static std::string layout() { return std::string(Stored<T>::kName); }
  static void list(StoredTypes& types) {
    Encoding<Image>::list(types);
    list_stored<T>(types, layout_of<Image>());
  }
};

}  // namespace muckpile
