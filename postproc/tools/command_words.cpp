// SPDX-License-Identifier: GPL-2.0-or-later
// Words that several sub-commands have.
// Scope: see the header.
#include "command_words.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <functional>

#include "args/numbers.h"
#include "args/suggestion.h"
#include "report/block_fields.h"

namespace muckpile {

CLI::App* add_command(CLI::App& app, const char* name, const char* help, std::string& folder) {
  CLI::App* command = app.add_subcommand(name, help);
  command->add_option("folder", folder, "result folder of the run; it holds dump/")->required();
  return command;
}

namespace {

std::string printable(std::string message) {
  constexpr std::size_t kMost = 800;
  if (message.size() > kMost) {
    std::size_t end = kMost;  // not within a character of UTF-8
    while (end > 0 && (static_cast<unsigned char>(message[end]) & 0xC0u) == 0x80u) --end;
    message = message.substr(0, end) + " ...";
  }
  for (char& c : message)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0 && c != '\n') c = '?';
  return message;
}

CLI::Validator finite(const std::function<bool(double)>& allowed, const std::string& rule,
                      const char* name) {
  const auto wrong = [allowed, rule](const std::string& word) -> std::string {
    double number = 0.0;
    const bool read = CLI::detail::lexical_cast(word, number) && std::isfinite(number);
    return read && allowed(number) ? "" : "must be " + rule + ", got '" + word + "'";
  };
  return {wrong, name};
}

}  // namespace

void tell(const std::exception& fault) {
  std::fprintf(stderr, "muckpile-post: %s\n", printable(fault.what()).c_str());
}

CLI::Validator above_zero() {
  return finite([](double number) { return number > 0.0; }, "> 0", "POSITIVE");
}

CLI::Validator at_least_zero() {
  return finite([](double number) { return number >= 0.0; }, ">= 0", "NONNEGATIVE");
}

CLI::Validator between(double least, double most) {
  return finite([least, most](double number) { return number >= least && number <= most; },
                "from " + number_text(least) + " to " + number_text(most), "RANGE");
}

CLI::Validator any_number() {
  return finite([](double) { return true; }, "a finite number", "NUMBER");
}

void add_measure(CLI::App* command, MeasureOptions& options) {
  command
      ->add_option("--moved", options.least_move,
                   "a block that moved less than this stayed [m] (default: mean block size; of a "
                   "crater: 0, its own size alone counts)")
      ->check(at_least_zero());
  command
      ->add_option("--cell", options.cell,
                   "width of the measuring columns [m] (default: 1/4 of mean block size)")
      ->check(above_zero());
}

void add_colour(CLI::App* command, std::string& colour) {
  command
      ->add_option("--colour", colour, "what the colours of blocks show: " + joined(field_names()))
      ->check(wrong_field);
}

}  // namespace muckpile
