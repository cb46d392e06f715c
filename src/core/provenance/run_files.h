// SPDX-License-Identifier: GPL-2.0-or-later
// What a run's files say of themselves: the id of their run, and the step of a snapshot.
// Scope: the text of names and lines; no file is opened.
#pragma once

#include <string>
#include <string_view>

namespace muckpile {

/// Whether a text is as Fingerprint::text() gives it, 16 hexadecimal digits in lower case.
[[nodiscard]] bool is_run_id(std::string_view text);

/// The word that marks a line with the id of its run: "run=0123456789abcdef".
[[nodiscard]] std::string run_mark(std::string_view id);

/// The id in the first such mark among the words of a line; "" if there is none.
[[nodiscard]] std::string run_id_in(std::string_view line);

/// Of the joints that hold at the end of a run.
inline constexpr const char* kJointsFile = "joints.csv";

enum class SnapshotForm { csv, packed };

/// "blocks_000001000.csv" for step 1000; packed rows (state/packed_rows.h) are in ".bin".
[[nodiscard]] std::string snapshot_name(long long step, SnapshotForm form = SnapshotForm::csv);

/// By the ending of a name that has a step.
[[nodiscard]] SnapshotForm snapshot_form(std::string_view name);

/// The step in the name of a snapshot of either form, with any number of digits; -1 for any other
/// name.
[[nodiscard]] long long snapshot_step(std::string_view name);

/// "impulses_000001000.csv": what has pushed each block up to the snapshot of step 1000.
[[nodiscard]] std::string impulses_name(long long step);

}  // namespace muckpile
