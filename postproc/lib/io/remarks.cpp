// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers in the first line of a file of a run.
// Scope: see the header.
#include "io/remarks.h"

#include "args/input_error.h"

namespace muckpile {

std::optional<double> find_remark_number(const CsvTable& table, const std::string& file,
                                         std::string_view key) {
  const std::string wanted = std::string(key) + "=";
  for (const std::string_view remark : table.remarks()) {
    const size_t at = remark.find(wanted);
    if (at == std::string_view::npos) continue;
    const std::string_view value = remark.substr(at + wanted.size());
    return parse_number(value.substr(0, value.find(' ')), file + ": " + std::string(key));
  }
  return std::nullopt;
}

double remark_number(const CsvTable& table, const std::string& file, std::string_view key) {
  if (const auto found = find_remark_number(table, file, key)) return *found;
  throw InputError(file + ": the first line must hold '# step=<n> time_s=<t>'");
}

}  // namespace muckpile
