#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_warnings.sh LIGGGHTS_MUCKPILE: what a run of the rock of joined_rock.in warns of as it is set up, once, and what it leaves on a stop:
# no contact law, a time step that the joints do not bear. A sound run warns of nothing.
set -euo pipefail
program=$1
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

wrong=0
try() {  # try NAME STATUS: runs the script on standard input behind the rock
  { echo "variable dir index $here"; cat; } >in.try
  status=0
  "$program" -in in.try -log none >screen 2>&1 </dev/null || status=$?
  [[ $status -eq $2 ]] || { echo "$1: exit status $status, not $2"; tail -n 5 screen; wrong=1; }
}
says() {  # says NAME COUNT TEXT: on so many lines
  [[ $(grep -cF -- "$3" screen) -eq $2 ]] || { echo "$1: not $2 times: $3"; grep -E '^(WARNING|ERROR)' screen; wrong=1; }
}
no_law='WARNING: create_blocks: there is no pair_style: blocks that no joint holds pass through each other'
too_long="WARNING: fix muckpile/joint 'joints': the time step must be <= "

try "no contact law" 0 <<'END'
include ${dir}/joined_rock.in
pair_style none
atom_modify sort 0 0
timestep 1e-6
run 2
run 2
END
says "no contact law" 1 "$no_law"
says "no contact law" 0 "$too_long"

try "loose blocks without contact law" 0 <<'END'
include ${dir}/rock.in
pair_style none
atom_modify sort 0 0
run 0
END
says "loose blocks without contact law" 1 "$no_law"

try "asks for the bound with a long step" 0 <<'END'
include ${dir}/joined_rock.in
timestep 1e-3
run 0
run 0
variable bound equal f_joints[8]
variable step string ${bound}
timestep ${step}
run 5
END
says "asks for the bound with a long step" 1 "$too_long"
says "asks for the bound with a long step" 0 "$no_law"

# The step passes the bound in the middle: the state is kept.
try "step grows in a run" 1 <<'END'
include ${dir}/joined_rock.in
fix energy all muckpile/ledger
fix progress all muckpile/progress every 100 directory .
timestep 1e-6
run 10
timestep 1e-3
run 10 pre no
END
says "step grows in a run" 1 'State written to ./stopped.restart'
[[ -s stopped.restart ]] || { echo "no stopped.restart"; wrong=1; }

try "unstable on purpose" 0 <<'END'
variable step_check index 0
include ${dir}/joined_rock.in
thermo_modify lost ignore
timestep 1e-3
run 60
END
says "unstable on purpose" 0 "$too_long"

try "joints of another density" 0 <<'END'
include ${dir}/rock.in
fix joints all muckpile/joint youngs_modulus 55e9 poisson_ratio 0.25 density 1700 cohesion 4e6 friction_angle 50 tension 2e6
timestep 1e-6
run 0
run 0
END
says "joints of another density" 1 "WARNING: fix muckpile/joint 'joints': its density is not that of the blocks (58.8 % apart)"
try "joints of the same density" 0 <<'END'
include ${dir}/joined_rock.in
timestep 1e-6
run 0
END
says "joints of the same density" 0 "its density is not"

freeze="WARNING: fix freeze 'hold': takes the contacts of blocks"
try "a fix that holds spheres" 0 <<'END'
include ${dir}/joined_rock.in
region nowhere block 1.9 2 1.9 2 1.9 2 units box
group none region nowhere
timestep 1e-6
fix hold none freeze
run 0
END
says "a fix that holds spheres" 0 "$freeze"
try "a fix that holds blocks" 0 <<'END'
include ${dir}/joined_rock.in
timestep 1e-6
run 0
fix hold all freeze
run 0
run 0
END
says "a fix that holds blocks" 1 "$freeze"

wide="WARNING: create_blocks: the void of hole 1 is "
try "a void of the cylinder's volume" 0 <<'END'
include ${dir}/rock.in
END
says "a void of the cylinder's volume" 1 "void over the cylinder of its crushed zone: hole 1 1"
says "a void of the cylinder's volume" 0 "$wide"
try "a void that is too wide" 0 <<'END'
include ${dir}/engine.in
create_blocks rock density 2700 size uniform 0.78 block_min 0.78 block_max 0.78 spheres_per_block 1 sweeps 2 rings_from 2 hole 0 0 -0.5 0 0 0.5 0.4
END
says "a void that is too wide" 1 "$wide"

# The pulse is to be cut into five steps at least while it rises, and into any number once it has passed (8.6 rise times).
few_steps="WARNING: fix muckpile/blast 'anfo': the time step, 3e-05 s, is longer than a fifth of rise_time"
blast() {  # blast STEP LATER: runs until 1.2 ms, and on from there with another step
  try "blast $1 $2" 0 <<END
include \${dir}/joined_rock.in
fix anfo all muckpile/blast explosive_density 850 vod 5000 hole_diameter 0.09 poisson_ratio 0.25 vent_time 0.01 vent_decay 0.005 rise_time 1e-4
timestep $1
variable steps equal ceil(1.2e-3/$1)
run \${steps}
timestep $2
run 3
END
}
blast 2e-5 3e-5
says "steps of a fifth" 0 "is longer than a fifth of rise_time"
blast 3e-5 2e-5
says "steps of a third" 1 "$few_steps"

# With 20 steps of the blocks, some 1 ms, in one of the gas the audit of the explosive's energy misses 5 %, with those of the defaults 0.01 %.
for every in 2 20; do
  (cd "$root" && "$program" -in inputs/bench/in.bench -log none -var out "$out/bench" -var accuracy quick -var bench_height 3 -var burden 1.5 \
    -var hole_diameter 0.05 -var time_end 0.05 -var gas_every $every -var gas_step "$([[ $every == 20 ]] && echo 1 || echo 6e-5)") >screen 2>&1 </dev/null
  says "an audit with $every steps of the blocks in one of the gas" "$([[ $every == 20 ]] && echo 1 || echo 0)" \
    "WARNING: run_blast: the audit of the explosive's energy misses "
done
exit $wrong
