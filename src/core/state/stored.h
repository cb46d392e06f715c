// SPDX-License-Identifier: GPL-2.0-or-later
// What is stored of a type, under which name and version.
// Scope: a type says it beside itself, by a specialisation of Stored.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace muckpile {

/// To be specialised for each struct that is stored:
///
///   template <>
///   struct Stored<Hole> {
///     static constexpr std::string_view kName = "hole";
///     static constexpr int kVersion = 1;
///     static auto fields(auto& hole) { return std::tie(hole.toe, hole.collar, hole.radius); }
///   };
///
/// The version rises whenever the fields, their order or their meaning change.
///
/// A type that cannot hand out its fields by reference has, instead of fields(), a type `Image`
/// that is stored in its place, `static Image image(const T&)` and `static T of(const Image&)`.
template <class T>
struct Stored;

template <class T>
concept StoredByFields = requires(T& value) {
  Stored<T>::fields(value);
};

template <class T>
concept StoredByImage = requires {
  typename Stored<T>::Image;
};

/// A stored type as the list of all of them tells it.
struct StoredType {
  std::string name;
  int version = 0;
  std::string layout;    ///< of its fields, in order; see layout_of() in state/encoding.h
  std::size_t size = 0;  ///< sizeof(T): grows with a field that fields() has left out
};
using StoredTypes = std::vector<StoredType>;

}  // namespace muckpile
