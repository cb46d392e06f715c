// SPDX-License-Identifier: GPL-2.0-or-later
// The state of a fix as a part of LIGGGHTS' restart file.
// Scope: global state; one writer (rank 0), every rank reads all of it. A part tells its stored
// types with their versions (state/part.h); one that this program would not write stops the run.
#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include "fixes/engine/style_args.h"
#include "state/part.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// Writes `part` as rank 0 has it, then `mine` of every rank. Collective; stops the run if that is
/// more than LIGGGHTS can read.
void write_part(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file, ByteWriter part,
                ByteWriter mine);

/// Reader of what write_part() wrote; `state` is what the engine hands to Fix::restart().
[[nodiscard]] ByteReader reader_of_part(const char* state);

/// State that is the same on all ranks.
template <class State>
void write_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file,
                 const State& state) {
  ByteWriter part;
  put_part(part, state);
  write_part(lmp, style, file, std::move(part), {});
}

/// State that is the same on all ranks, and behind it any number of values of type Share in `mine`.
template <class Share, class State>
void write_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file,
                 const State& state, ByteWriter mine) {
  ByteWriter part;
  put_types(part, stored_types<Share>());
  put_part(part, state);
  write_part(lmp, style, file, std::move(part), std::move(mine));
}

/// Reads what write_state() wrote; all ranks stop with a message if it is another state.
template <class State>
[[nodiscard]] State read_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style,
                               const char* state) {
  return or_engine_error(lmp, "read_restart: fix " + style, [&] {
    ByteReader in = reader_of_part(state);
    auto read = get_part<State>(in);
    in.require_end(Stored<State>::kName);
    return read;
  });
}

/// The same; `take` gets one share of a rank after the other, those of other ranks too.
template <class Share, class State, class Take>
void read_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style, const char* bytes, State& state,
                const Take& take) {
  or_engine_error(lmp, "read_restart: fix " + style, [&] {
    ByteReader in = reader_of_part(bytes);
    require_types(in, stored_types<Share>());
    state = get_part<State>(in);
    while (!in.empty()) take(in.get<Share>());
  });
}

/// This rank's part of a sum over ranks read from a file: all of it on rank 0, 0 elsewhere.
[[nodiscard]] double share_of_total(LAMMPS_NS::LAMMPS& lmp, double all);

}  // namespace muckpile::engine
