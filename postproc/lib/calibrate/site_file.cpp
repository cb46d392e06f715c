// SPDX-License-Identifier: GPL-2.0-or-later
// A site file: fitted constants as a piece of an input script.
// Scope: see the header.
#include "calibrate/site_file.h"

#include <fstream>
#include <sstream>

#include "args/input_error.h"

namespace muckpile {

void write_site_file(const std::filesystem::path& path, const std::vector<std::string>& remarks,
                     const SiteConstants& constants, const std::vector<std::string>& beside) {
  std::ofstream out(path);
  for (const std::string& remark : remarks) out << "# " << remark << '\n';
  for (size_t k = 0; k < constants.size(); ++k)
    out << "variable " << constants[k].first << " index " << constants[k].second << "  # "
        << beside[k] << '\n';
  if (!out.flush()) refuse(path.string(), "cannot be written");
}

SiteConstants read_site_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) refuse(path.string(), "cannot be opened");
  SiteConstants constants;
  size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    std::string command, name, style, value, more;
    if (!(words >> command)) continue;
    words >> name >> style >> value;
    if (command != "variable" || style != "index" || value.empty() || words >> more)
      throw InputError(path.string() + ":" + std::to_string(number) +
                       ": must be 'variable NAME index VALUE', got '" + line + "'");
    constants.emplace_back(name, value);
  }
  if (constants.empty()) refuse(path.string(), "has no constant");
  return constants;
}

}  // namespace muckpile
