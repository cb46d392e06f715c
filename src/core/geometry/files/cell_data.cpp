// SPDX-License-Identifier: GPL-2.0-or-later
// Named numbers of the cells of a file.
// Scope: see the header.
#include "geometry/files/cell_data.h"

#include "args/input_error.h"

namespace muckpile {
namespace {

std::vector<double> read_scalars(TextWords& text, std::size_t cells, const std::string& where) {
  (void)text.line();  // type and the number of components, which may be left out
  const std::string_view table = text.word();
  if (table != "LOOKUP_TABLE" || text.word().empty())
    throw InputError(where + "LOOKUP_TABLE expected, got '" + std::string(table) + "'");
  std::vector<double> values(cells);
  for (std::size_t k = 0; k < cells; ++k)
    if (!text.number(values[k]))
      throw InputError(where + "must have a number for each of " + std::to_string(cells) +
                       " cells, got " + std::to_string(k));
  return values;
}

}  // namespace

CellData read_cell_data(TextWords& text, std::size_t cells, const std::string& file) {
  std::size_t count = 0;
  if (text.word() != "CELL_DATA" || !text.number(count) || count != cells)
    throw InputError(file + ": 'CELL_DATA " + std::to_string(cells) +
                     "' expected behind the cells");
  CellData data;
  for (std::string word(text.word()); !word.empty(); word = text.word()) {
    const std::string name(text.word());
    if (word != "SCALARS" || name.empty())
      throw InputError(file + ": 'SCALARS' and a name expected, got '" + word + "'");
    data[name] = read_scalars(text, cells, file + ": " + name + ": ");
  }
  return data;
}

const std::vector<double>& cell_array(const CellData& data, const char* name,
                                      const std::string& file) {
  const auto found = data.find(name);
  if (found == data.end())
    throw InputError(file + ": has no cell data '" + std::string(name) + "'");
  return found->second;
}

}  // namespace muckpile
