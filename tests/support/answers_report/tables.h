// SPDX-License-Identifier: GPL-2.0-or-later
// What runs of one blast, with one thing changed at a time, have given: a table of answers and a
// table of each scene's runs.
// Scope: reads RESULTS/NAME/CUT/summary.json of each run's cuts, whose mean counts; throws
// InputError, naming file and quantity, where a figure is missing, but for the end of the stemming,
// which may stay in its hole.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace muckpile::check {

/// Lines of words; empty lines and those that begin with # are left out.
[[nodiscard]] std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& file);

/// Of a run: a quantity of its summaries, or burden_speed_m_s, the way of the burden's mass centre
/// over the time, or load_work_J, the work of wave and gas.
[[nodiscard]] double figure_of(const std::filesystem::path& results, const std::string& run,
                               const std::string& quantity);

/// name,factor,value,base with a row for each "NAME FACTOR QUANTITY RUN BASE" of `answers`, where -
/// stands for none.
[[nodiscard]] std::string answers_table(const std::filesystem::path& answers,
                                        const std::filesystem::path& results);

/// CSV: a row for the run `base` and for each "NAME SCENE ..." of `runs` with that scene. Shares
/// are those of the explosive's energy [%]. stemming_out_ms is empty where the stemming stays in.
[[nodiscard]] std::string runs_csv(const std::filesystem::path& runs,
                                   const std::filesystem::path& results, const std::string& scene);

/// Markdown: the same rows, with the columns that a page shows.
[[nodiscard]] std::string runs_table(const std::filesystem::path& runs,
                                     const std::filesystem::path& results,
                                     const std::string& scene);

/// The page with that table between its line <!-- runs: SCENE --> and the next <!-- end of runs
/// -->. Throws InputError where it lacks one of the two.
[[nodiscard]] std::string with_table(const std::filesystem::path& page, const std::string& scene,
                                     const std::string& table);

}  // namespace muckpile::check
