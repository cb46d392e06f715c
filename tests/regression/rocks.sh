#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# rocks.sh LIGGGHTS_MUCKPILE: every rock of inputs/common/rocks is whole, agrees with itself and lies within what is published of its kind; it
# stands in the table of docs/rocks.md; -var wins over it; a rock of one's own is one more file.
set -euo pipefail
program=$(readlink -f "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
source "$root/tests/support/check_figures.sh"

cat >"$out/in.rock" <<'END'
variable fragment_x50 index 0.26
include inputs/common/rock.in
variable block_min index 0.18
variable p_wave equal sqrt(${youngs_modulus}*(1-${poisson_ratio})/((1+${poisson_ratio})*(1-2*${poisson_ratio})*${rock_density}))
variable s_wave equal sqrt(${youngs_modulus}/(2*(1+${poisson_ratio})*${rock_density}))
variable line equal 2*${cohesion}*cos(${friction_angle}*PI/180)/(1-sin(${friction_angle}*PI/180))/${ucs}
variable brittleness equal ${ucs}/${tensile_strength}
print '{"p_wave": ${p_wave}, "s_wave": ${s_wave}, "line": ${line}, "brittleness": ${brittleness}, "effusivity": ${effusivity},' file ${out}/rock.json
print '"tension": ${tension}, "cohesion": ${cohesion}, "tensile_strength": ${tensile_strength}, "rock_density": ${rock_density},' append ${out}/rock.json
print '"friction_angle": ${friction_angle}, "residual_friction": ${residual_friction}, "rate_exponent": ${rate_exponent},' append ${out}/rock.json
print '"energy_tension": ${fracture_energy_tension}, "energy_shear": ${fracture_energy_shear}}' append ${out}/rock.json
END

wrong=0
read_rock() {  # read_rock NAME [-var NAME VALUE]...: $out/rock.json, in the present folder
  rm -f "$out/rock.json"
  "$program" -in "$out/in.rock" -log none -var out "$out" -var rock "$1" "${@:2}" >"$out/screen" 2>&1 </dev/null ||
    fail "$1 was not read"
}
within() {  # within ROCK FIGURE LEAST MOST
  check_figures bounds "$1: $2" "$out/rock.json:$2" --at-least "$3" --at-most "$4" || wrong=1
}
is() {  # is ROCK FIGURE VALUE: to the digits that LIGGGHTS prints
  check_figures near "$1: $2" "$out/rock.json:$2" "$3" 1e-6 --share || wrong=1
}
value() { sed -nE "s/^variable $2 +index ([^ ]+).*/\1/p" "inputs/common/rocks/$1.in"; }  # value ROCK KNOB: as its file has it

cd "$root"
number=0
for file in inputs/common/rocks/*.in; do
  rock=$(basename "$file" .in)
  number=$((number + 1))
  read_rock "$rock"
  # Bounds that hold for all of these rocks; sources in docs/rocks.md.
  within "$rock" p_wave 2000 6500
  within "$rock" s_wave 1000 4000
  within "$rock" rock_density 2000 3100
  within "$rock" residual_friction 25 40
  within "$rock" friction_angle 25 55
  within "$rock" brittleness 8 25
  within "$rock" effusivity 1600 4500
  row="| \`$rock\` | $(value "$rock" rock_density) |"
  for knob in youngs_modulus poisson_ratio ucs tensile_strength cohesion friction_angle residual_friction toughness shear_toughness conductivity heat_capacity; do
    row+=" $(value "$rock" $knob) |"
  done
  grep -qF -- "$row" docs/rocks.md || { echo "docs/rocks.md has no row: $row"; wrong=1; }
  [[ $rock != rock_mass ]] || continue
  within "$rock" line 0.85 1.15  # Mohr-Coulomb's line meets the compressive strength
  is "$rock" tension "$(value "$rock" tensile_strength)"
  within "$rock" energy_tension 100 1000
  within "$rock" energy_shear 100 2000
done
[[ $number -ge 6 ]] || { echo "$number rocks found"; wrong=1; }

# Worked by hand: granite in blocks of 0.26 m. Fines: 0.5 x 3 x (2600^0.25 - 1) = 9.2112; 1.6e6^2 x 0.9375 / 55e9 = 43.636 J/m2, shear four times
# that: 43.636 x 10.2112 = 445.58, 43.636 x 13.2112 = 576.49.
read_rock granite
check_figures near "energy in tension" "$out/rock.json:energy_tension" 445.58 1e-4 --share || wrong=1
check_figures near "energy in shear" "$out/rock.json:energy_shear" 576.49 1e-4 --share || wrong=1

read_rock granite -var cohesion 5e6 -var tensile_strength 12e6 -var fracture_energy_tension 7
is "granite with knobs" cohesion 5e6
is "granite with knobs" tension 12e6
is "granite with knobs" energy_tension 7
read_rock rock_mass
is rock_mass tension 2e6
is rock_mass cohesion 4e6
within rock_mass energy_tension 0 0
within rock_mass rate_exponent 0 0
read_rock rock_mass -var tension 3e6
is "rock_mass with tension" tension 3e6

# A rock of one's own.
mkdir -p "$out/own/inputs/common/rocks"
cp inputs/common/rock.in "$out/own/inputs/common/"
sed 's/^variable ucs .*/variable ucs index 190e6/; s/^variable cohesion .*/variable cohesion index 34e6/' inputs/common/rocks/granite.in \
  >"$out/own/inputs/common/rocks/north_quarry.in"
cd "$out/own"
read_rock north_quarry
is north_quarry cohesion 34e6
within north_quarry line 0.95 1.05
# One that lacks a number is refused by its name.
for knob in $(sed -nE 's/^variable ([a-z_]+) .*/\1/p' inputs/common/rocks/north_quarry.in); do
  sed "/^variable $knob /d" inputs/common/rocks/north_quarry.in >inputs/common/rocks/lacking.in
  ! "$program" -in "$out/in.rock" -log none -var out "$out" -var rock lacking >"$out/screen" 2>&1 </dev/null || fail "a rock without $knob was taken"
  grep -q "ERROR: input: the variable $knob is not set" "$out/screen" || fail "that $knob lacks is not named"
done
exit $wrong
