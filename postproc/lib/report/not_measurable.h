// SPDX-License-Identifier: GPL-2.0-or-later
// A sound run whose scene a report has no measures for, as against a faulty one.
// Scope: tools/ gives it an exit code of its own, so that scripts can go on with other reports.
#pragma once

#include <string>

#include "args/input_error.h"
#include "io/result_folder.h"

namespace muckpile {

class NotMeasurable : public InputError {
 public:
  using InputError::InputError;
};

inline constexpr int kNotMeasurableExitCode = 3;

// The key of summary.json that says why a report was refused.
std::string refusal_key(const std::string& report);

// What an earlier call may have left must not pass for this run's: takes <report>.csv, <report>.png
// and the report's own keys of summary.json away, and writes the reason in their place.
void take_back(const ResultFolder& folder, const std::string& report,
               const nlohmann::ordered_json& own_keys, const NotMeasurable& why);

// Throws a NotMeasurable that says "<report>: <words>"; of a run that has ended all is taken back.
[[noreturn]] void refuse_to_measure(const ResultFolder& folder, const std::string& report,
                                    const std::string& words);

}  // namespace muckpile
