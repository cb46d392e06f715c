// SPDX-License-Identifier: GPL-2.0-or-later
// Work of the first rank alone.
// Scope: see the header.
#include "fixes/engine/first_rank.h"

#include <comm.h>
#include <lammps.h>

#include <exception>
#include <utility>

#include "fixes/engine/exchange.h"
#include "fixes/engine/style_args.h"

namespace muckpile::engine {

void on_first_rank(LAMMPS_NS::LAMMPS& lmp, const std::function<void()>& body,
                   const std::function<std::string(const std::string&)>& told) {
  std::string fault;
  if (lmp.comm->me == 0) {
    try {
      body();
    } catch (const std::exception& error) {
      fault = error.what();
    }
  }
  fault = of_first_rank(std::move(fault), lmp.world);
  if (!fault.empty()) stop(lmp, told ? told(fault) : fault);
}

}  // namespace muckpile::engine
