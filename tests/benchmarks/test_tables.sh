#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_tables.sh PERF_TABLE LADDER_REPORT PEERS_TABLE TURNS_TABLE LOG_FIGURES: the tables of the benchmark page, from made-up figures whose ratios are seen at a glance;
# what is not there is told of by its file.
set -euo pipefail
perf_table=$(readlink -f "$1") ladder_report=$(readlink -f "$2") peers_table=$(readlink -f "$3") turns_table=$(readlink -f "$4")
figures=$(readlink -f "$5")
source "$(dirname "${BASH_SOURCE[0]}")/../support/script.sh"
cd "$out"

is() {  # is FILE: as on standard input
  diff "$1" - || fail "$1 is not as it should be"
}

refuses() {  # refuses TEXT COMMAND...
  ! output=$("${@:2}" 2>&1) || fail "accepted: ${*:2}"
  grep -qF -- "$1" <<<"$output" || fail "does not tell '$1': ${*:2}"
}

# Figures of perf programs

cat >blocks.json <<'EOT'
{"processor": "p", "target_ns_per_sphere": 10.0,
 "runs": [{"blocks": 200, "spheres_per_block": 5, "step": {"ns_per_sphere": 13.0369}}]}
EOT
cat >contacts.json <<'EOT'
{"rebuild_target_s": 0.15, "touching": {"core_rebuild": {"total_s": 1}, "engine": {"rebuild_wall_s": 0.04091, "contacts": 7}}}
EOT
"$perf_table" . blocks contacts >perf.csv
is perf.csv <<'EOT'
program,scene,figure,value
perf_blocks,"target",target_ns_per_sphere,10
perf_blocks,"step, 200 blocks of 5 spheres",ns_per_sphere,13
perf_contacts,"target",rebuild_target_s,0.15
perf_contacts,"touching",rebuild_wall_s,0.0409
EOT
refuses "./facets.json: cannot be opened" "$perf_table" . facets

# Two builds in turns: the ratio of a turn is 1.1, 0.9 and 1.2 for the steps, whatever the machine's speed in that turn; a figure that the old build
# lacks and a target are left out.

one_turn() {  # one_turn SIDE TURN NS MORE
  mkdir -p "$1"
  echo "{\"target_ns_per_sphere\": 10, \"runs\": [{\"blocks\": 200, \"step\": {\"ns_per_sphere\": $3}}]$4}" >"$1/blocks_$2.json"
}
one_turn old 1 10 "" && one_turn old 2 20 "" && one_turn old 3 40 ""
one_turn new 1 11 ', "cpu_s": 1' && one_turn new 2 18 ', "cpu_s": 1' && one_turn new 3 48 ', "cpu_s": 1'
"$turns_table" . 3 blocks >turns.md
is turns.md <<'EOT'
| program | figure | old | new | new over old | of the turns |
|---|---|---|---|---|---|
| blocks | runs/0/step/ns_per_sphere | 20 | 18 | 1.100 | 0.900 to 1.200 |
EOT
refuses "old/blocks_4.json: cannot be opened" "$turns_table" . 4 blocks
refuses "TURNS must be at least 1" "$turns_table" . 0 blocks

# The ladder

one_run() {  # one_run NAME FACE_VELOCITY THROW CPU_USER CPU_SYSTEM
  mkdir -p "runs/$1"
  echo "{\"blocks\": 100, \"steps\": 50, \"face_velocity_m_s\": $2, \"throw_cg_m\": $3, \"beyond_toe_fraction\": 0.5, \"joints_broken_fraction\": 1}" \
    >"runs/$1/summary.json"
  echo "$4 $5" >"runs/$1/seconds"
}
one_run finest 10 20 90 10
one_run standard 11 20 9 1
one_run seed_2 12 18 10 1
one_run seed_3 13 22 11 1
one_run large 10.0001 25 4.5 0.5
ladder=("finest|finest|all, at once|-var a 1" "standard|standard|seed 1|" "seed_2|standard|seed 2|-var seed 2" "seed_3|standard|seed 3|-var seed 3"
  "large|block size|x 1.4|-var b 2")
printf '%s\n' "${ladder[@]}" | "$ladder_report" . 7
is ladder.csv <<'EOT'
name,knob,setting,blocks,steps,cpu_s,face_velocity_m_s,throw_cg_m,beyond_toe_fraction,joints_broken_fraction
finest,finest,all; at once,100,50,100,10,20,0.5,1
standard,standard,seed 1,100,50,10,11,20,0.5,1
seed_2,standard,seed 2,100,50,11,12,18,0.5,1
seed_3,standard,seed 3,100,50,12,13,22,0.5,1
large,block size,x 1.4,100,50,5,10.0001,25,0.5,1
EOT
sed -n '4p;$p' ladder.md >rows.md
is rows.md <<'EOT'
| standard | seed 1 | 50 | 10.0 | 11 (+10.0 %) | 20 (+0.0 %) |
| block size | x 1.4 | 50 | 5.0 | 10 (+0.0 %) | 25 (+25.0 %) |
EOT
# Standard deviation with n - 1: of 11, 12 and 13 it is 1, of 18, 20 and 22 it is 2.
is scatter.md <<'EOT'
| quantity | mean of 3 seeds | standard deviation |
|---|---|---|
| face_velocity_m_s | 12 | 1 (8.3 %) |
| throw_cg_m | 20 | 2 (10.0 %) |
| beyond_toe_fraction | 0.5 | 0 (0.0 %) |
| joints_broken_fraction | 1 | 0 (0.0 %) |
EOT
# Two knobs and four quantities; a distance of 0.001 % is drawn at 0.01 %.
[[ $(grep -c '"plot"' cases/ladder.json) -eq 8 ]] || fail "not eight curves"
tr -d ' \n' <cases/ladder.json | grep -qF '"label":"blocksize","style":"points","colour":1,"points":[[5.0,0.01]]' || fail "no point of the large blocks"
rm runs/seed_2/seconds
refuses "seed_2/seconds: cannot be opened" "$ladder_report" . 7 < <(printf '%s\n' "${ladder[@]}")
sed -i 's/"throw_cg_m": 20/"throw_cg_m": null/' runs/standard/summary.json
refuses "standard/summary.json: has no number 'throw_cg_m'" "$ladder_report" . 7 < <(printf '%s\n' "${ladder[@]}")
refuses "there is no run 'finest'" "$ladder_report" . 7 < <(printf '%s\n' "${ladder[@]:4}")

# Other codes: the least of the rounds counts.

cat >raw.csv <<'EOT'
scene,code,law,particles,links,steps,seconds
rock,Muckpile,joints,1000,4000,100,2
rock,Other,springs,2000,4000,100,8
fall,Muckpile,none,1000,0,100,1
rock,Muckpile,joints,1000,4000,100,1
EOT
"$peers_table" raw.csv .
is peers.csv <<'EOT'
scene,code,law,particles,links,steps_per_s,us_per_particle_step,over_muckpile,ns_per_link_step,over_muckpile_per_link
rock,Muckpile,joints,1000,4000,100,10.000,1.00,2500,1.00
rock,Other,springs,2000,4000,12,40.000,4.00,20000,8.00
fall,Muckpile,none,1000,0,100,10.000,1.00,,
EOT
tail -n 1 peers.md >rows.md
is rows.md <<'EOT'
| fall | Muckpile | none | 1000 | 0 | 100 | 10.000 | 1.00 |  |  |
EOT
sed '2s/,2$//' raw.csv >short.csv
refuses "short.csv:2" "$peers_table" short.csv .

# Figures of logs.

gives() {  # gives TEXT WORD...: log_figures WORD...
  [[ $("$figures" "${@:2}") == "$1" ]] || fail "log_figures ${*:2} gives '$("$figures" "${@:2}")', not '$1'"
}
tick=$(getconf CLK_TCK)
stat() { echo "ticks $1 123 (liggghts-muck) R 1 2 3 4 5 6 7 8 9 10 $2 $3 0 0"; }  # stat NAME USER SYSTEM
{
  stat fall $tick 0
  stat fall $((3 * tick)) $((tick / 2))
  echo 'seconds rock 2.25'
  printf 'Step Atoms f_joint[1] f_joint[2] \n10 8 40 5 \nStep Atoms touches \n 20 8 66 \nStep Atoms touches\n 30 8 70\natoms 12 bonds 34\n'
} >peer.log
gives 2.5 seconds fall peer.log
gives 2.25 seconds rock peer.log
gives 40 below 'joint[2]' 3 peer.log
gives 70 below touches 3 peer.log
gives 34 beside atoms 4 peer.log
refuses "peer.log: has no time of 'pile'" "$figures" seconds pile peer.log
refuses "peer.log: has nothing below 'Bonds'" "$figures" below Bonds 3 peer.log
refuses "peer.log: a line has no word 9" "$figures" beside atoms 9 peer.log
refuses "peer.log: has no line 'bonds'" "$figures" beside bonds 2 peer.log
{ for ((k = 0; k < 9; ++k)); do echo head; done; echo '7 3 0.5 0.25 1.5 0.0499'; } >start.txt
"$figures" lammps_data 2.5 start.txt >start.data
is start.data <<'EOT'
clumps

1 atoms
1 atom types
0 bonds
0 bond types
0 2.5 xlo xhi
0 2.5 ylo yhi
0 10 zlo zhi

Atoms

7 1 0.5 0.25 1.5 0.0998 2500 3
EOT
mkdir size1
echo '2048 1.0' >size1/rank.0
echo '4096 2.0' >size1/rank.1
printf '%s\n' 'create_blocks: 1000 blocks, 5000 spheres, 7000 joints, 9 supported' '  largest initial sphere overlap 0.61 of a radius; 4.84 s' \
  'Loop time of 9.5 on 2 procs for 10 steps with 5000 atoms' 'Loop time of 2 on 2 procs for 100 steps with 5000 atoms' >size1/log
gives "1,2,1000,7000,4.84,100,2,20,4,6" scaling 1 2 size1
sed -i '/^Loop/d' size1/log
refuses "size1/log: a figure must be a number" "$figures" scaling 1 2 size1
gives "-var fragment_x50 0.245 -var block_min 0.126 -var block_max 0.35" sizes 0.35 0.18 0.50 0.7 0.19
gives "-var fragment_x50 0.49 -var block_min 0.19 -var block_max 0.7" sizes 0.35 0.18 0.50 1.4 0.19
