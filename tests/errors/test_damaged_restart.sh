#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_damaged_restart.sh LIGGGHTS_MUCKPILE RESEAL_RESTART: writes a restart file of the rock of joined_rock.in, and reads it whole, with other bytes here and there,
# cut short at many lengths, and in place of it a file that is none. Only the whole one may be read; each other must be refused
# by its name, without a crash. So must parts of another version be, under a seal that fits, and a file without a block, of a run that
# has burst. Two equal runs write equal files. A name with * means the file of the latest step.
set -euo pipefail
program=$1
reseal=$2
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

cat >write.in <<END
variable dir index $here
variable bodies index multisphere/muckpile
include $here/joined_rock.in
fix load all muckpile/blast explosive_density 850 vod 5000 hole_diameter 0.09 poisson_ratio 0.25 vent_time 0.01 vent_decay 0.005
thermo_modify lost ignore
timestep \${step}
run \${steps}
write_restart \${file}
END
cat >read.in <<END
atom_style granular
atom_modify map array
newton off
boundary f f f
communicate single vel yes
hard_particles yes
read_restart \${file}
pair_style muckpile/block
pair_coeff * *
fix bodies all multisphere/muckpile
fix joints all muckpile/joint youngs_modulus 55e9 poisson_ratio 0.25 density 2700 cohesion 4e6 friction_angle 50 tension 2e6
fix load all muckpile/blast explosive_density 850 vod 5000 hole_diameter 0.09 poisson_ratio 0.25 vent_time 0.01 vent_decay 0.005
timestep 1e-6
run 2
END
write_file() {  # write_file FILE STEP STEPS [STEP_CHECK]
  "$program" -in write.in -log none -var file "$1" -var step "$2" -var steps "$3" -var step_check "${4:-2500}" >screen || { tail -n 5 screen; exit 1; }
}
write_file whole.restart 1e-6 2

read_file() {  # read_file FILE
  status=0
  timeout -k 5 30 "$program" -in read.in -log none -var file "$1" >screen 2>&1 || status=$?
}
tried=0 wrong=0
refused() {  # refused WHAT: of spoilt.restart
  read_file spoilt.restart
  tried=$((tried + 1))
  [[ $status -eq 1 ]] && grep -q "^ERROR: read_restart: .*'spoilt.restart'" screen && return
  echo "$1: exit status $status, $(grep '^ERROR' screen || tail -n 1 screen)"
  wrong=1
}

read_file whole.restart
[[ $status -eq 0 ]] && grep -q '^Loop time' screen || { echo "the whole file is not read"; tail -n 5 screen; exit 1; }
size=$(stat -c %s whole.restart)
for place in 0 40 300 900 $((size / 4)) $((size / 2)) $((size * 3 / 4)) $((size - 100)) $((size - 20)) $((size - 4)); do
  cp whole.restart spoilt.restart
  printf '\377\001\377' | dd of=spoilt.restart bs=1 seek="$place" conv=notrunc status=none
  refused "three other bytes at $place of $size"
done
for length in 0 1 100 400 800 1600 $((size / 4)) $((size / 2)) $((size - 300)) $((size - 24)) $((size - 1)); do
  head -c "$length" whole.restart >spoilt.restart
  refused "the first $length bytes of $size"
done
cat whole.restart whole.restart >spoilt.restart
refused "the file twice"
cp read.in spoilt.restart
refused "an input script"
rm spoilt.restart
refused "no file"
mkdir spoilt.restart
refused "a folder"
rmdir spoilt.restart
read_file 'spoilt.*.restart'
[[ $status -eq 1 ]] && grep -qF "ERROR: read_restart: there is no file 'spoilt.*.restart'" screen ||
  { echo "no file fits the *: exit status $status, $(grep '^ERROR' screen || tail -n 1 screen)"; wrong=1; }
cp whole.restart spoilt.7.restart && cp whole.restart spoilt.900.restart && cp read.in spoilt.1000.restart.old && cp read.in spoilt.last.restart
read_file 'spoilt.*.restart'
[[ $status -eq 0 ]] || { echo "the latest of whole files: exit status $status, $(grep '^ERROR' screen || tail -n 1 screen)"; wrong=1; }
printf '\377\001\377' | dd of=spoilt.900.restart bs=1 seek=900 conv=notrunc status=none
read_file 'spoilt.*.restart'
[[ $status -eq 1 ]] && grep -q "^ERROR: read_restart: 'spoilt.900.restart' is damaged" screen ||
  { echo "the latest is damaged: exit status $status, $(grep '^ERROR' screen || tail -n 1 screen)"; wrong=1; }
mv whole.restart first.restart
write_file whole.restart 1e-6 2
cmp whole.restart first.restart || { echo "two equal runs write unequal files"; wrong=1; }

# Files of another version: whole, with a seal that fits, but with another byte within a part's head.
other_version() {  # other_version WORD BYTES_BEHIND MESSAGE: the byte that far behind the first WORD becomes 9
  local place
  cp whole.restart spoilt.restart
  place=$(grep -obUa -m 1 "$1" whole.restart | head -n 1 | cut -d : -f 1)
  printf '\011' | dd of=spoilt.restart bs=1 seek=$((place + ${#1} + $2)) conv=notrunc status=none
  "$reseal" spoilt.restart
  read_file spoilt.restart
  [[ $status -eq 1 ]] && grep -qF "ERROR: read_restart: fix $3" screen ||
    { echo "$1 of another version: exit status $status, $(grep '^ERROR' screen || tail -n 1 screen)"; wrong=1; }
}
other_version network_totals 0 "muckpile/joint: 'network_totals': version 2 expected, version 9 in the file"
other_version blast_state 0 "muckpile/blast: 'blast_state': version 2 expected, version 9 in the file"
other_version block_record 0 "muckpile/blocks: 'block_record': version 2 expected, version 9 in the file"
other_version boundary_face 12 "muckpile/blocks: 'boundary_face': version 2 expected, with the fields "
other_version MuckPart -1 "muckpile/blocks: the file is of an earlier version of Muckpile, or of another program"
write_file empty.restart 1e-3 50 0
read_file empty.restart
[[ $status -eq 1 ]] && grep -q '^ERROR: read_restart: all .* blocks had left the simulation box' screen ||
  { echo "no block: exit status $status, $(grep '^ERROR' screen || tail -n 1 screen)"; wrong=1; }
echo "$tried spoilt files"
exit $wrong
