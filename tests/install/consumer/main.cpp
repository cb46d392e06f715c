// SPDX-License-Identifier: GPL-2.0-or-later
// The smallest user of an installed Muckpile: reads one number with a unit, and fails if it is
// wrong. Scope: links and runs; the unit tests check the physics.
#include <args/numbers.h>
#include <math/types.h>

int main() {
  const double burden =
      muckpile::parse_real("bench", "burden", "3.5", "m", muckpile::Range::positive());
  const muckpile::Vec3 face(burden, 0.0, 0.0);
  return face.norm() == 3.5 ? 0 : 1;
}
