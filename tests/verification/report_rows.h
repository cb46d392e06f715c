// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of verification reports as text: one row of a page per case, CSV files with all of them.
// Scope: a row is a JSON object with case, quantity, value, unit, reference, error, tolerance
// (null: for information) and pass, as framework/report.h writes it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace muckpile {

using Json = nlohmann::ordered_json;

/// All rows as a CSV file: errors and bounds are shares, or the value where 0 is expected.
[[nodiscard]] std::string csv_of(const Json& rows);

/// One row for all: how many figures are within their bounds, the one nearest to its bound or
/// farthest outside, and a link to `file` with the words `text`.
[[nodiscard]] std::string case_row(const Json& rows, const std::string& text,
                                   const std::string& file);

/// The rows outside their bounds as a list, or that there are none.
[[nodiscard]] std::string not_met(const Json& rows);

}  // namespace muckpile
