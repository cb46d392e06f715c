#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The entry script: every wrong word is refused by name, only missing packages are installed, a run
# passes its values on, and a failure of any part is the failure of the whole.
# Scope: fake apt-get, cmake, mpirun and muckpile-post record how they are called.
# shellcheck disable=SC2016  # the bodies of the fakes expand when they run
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/script.sh"
source "$here/fake_tree.sh"
engine_ok="mkdir -p results/demo/dump; echo '{\"case\": \"bench\"}' >results/demo/dump/scene.json"
healthy() {
  fake_tools
  fake bin/mpirun "$engine_ok"
  fake build/release/postproc/tools/muckpile-post "touch results/demo/summary.json results/demo/profile.png; echo throw_cg_m 8.5"
}

healthy
must_refuse "unknown command 'rnu'" rnu
must_refuse "run needs an input" run
must_refuse "run needs an input, e.g. inputs/bench/in.bench; got an empty word" run ""
must_refuse "cannot read the input 'inputs/none'" run inputs/none
must_refuse "-np must be a whole number >= 1, got '0'" run inputs/demo/in.demo -np 0
must_refuse "-np must be a whole number >= 1, got 'two'" run inputs/demo/in.demo -np two
must_refuse "-np must be a whole number >= 1, got ''" run inputs/demo/in.demo -np
must_refuse "unknown option '-n'" run inputs/demo/in.demo -n 2
must_refuse "run takes one input" run inputs/demo/in.demo 12
must_refuse "-var needs a name and a value" run inputs/demo/in.demo -var bench_height
must_refuse "-var needs a name and a value, got the option -out behind 'bench_height'" run inputs/demo/in.demo -var bench_height -out here
# Every option that run or sweep reads.
options=$(sed -nE 's/^ +(-[a-z]+)\).*/\1/p' src/app/run/{run_input,sweep}.sh | sort -u)
[[ $(wc -l <<<"$options") -ge 7 ]] || problem "options read: $options"
for option in $options; do
  must_refuse "-var needs a name and a value, got the option $option behind 'bench_height'" run inputs/demo/in.demo -var bench_height "$option" here
done
must_refuse "-var takes name and value as two words, got 'bench_height=10': -var bench_height 10" run inputs/demo/in.demo -var bench_height=10 -out here
must_refuse "has no variable 'bench_heigth'; did you mean 'bench_height'? (it has: bench_height from go_on mode patience rock_density)" \
  run inputs/demo/in.demo -var bench_heigth 10
must_refuse "-var bench_height needs one value" run inputs/demo/in.demo -var bench_height ''
must_refuse "computes 'step' itself" run inputs/demo/in.demo -var step 2
must_refuse "-var go_on 1 needs -var from FILE" run inputs/demo/in.demo -var go_on 1
must_refuse "-var from FILE needs -var go_on 1" run inputs/demo/in.demo -var from a.restart
must_refuse "use -out DIR" run inputs/demo/in.demo -var out here
must_refuse "splits names at blanks" run inputs/demo/in.demo -out 'a b'
for letter in % '*' \$ ';' '&' '|' '(' ')' '<' '>' "'" '"' '`' \\; do
  must_refuse "for something else; choose another -out than 'a${letter}b'" run inputs/demo/in.demo -out "a${letter}b"
done
must_refuse "-var bench_height is given twice" run inputs/demo/in.demo -var bench_height 10 -var patience 2 -var bench_height 12
for word in -np -out; do must_refuse "$word is given twice" run inputs/demo/in.demo "$word" 1 "$word" 2; done
must_refuse "-np must be at most" run inputs/demo/in.demo -np 99999
must_refuse "-np must be at most" run inputs/demo/in.demo -np 99999999999999999999

must_refuse "-var mode must be one of slow, got 'fast'" run inputs/demo/in.demo -var mode fast

mkdir quarry && touch quarry/rock.in
printf 'include ${place}/rock.in\ninclude inputs/common/rock.in\nvariable place index inputs/common\nvariable solid string under_the_pit\nvariable out index x\n' \
  >inputs/demo/in.place
printf 'variable solid index none\n' >>inputs/common/rock.in
must_refuse "computes 'solid' itself (variable solid string)" run inputs/demo/in.place -var solid none
must_refuse "(it has: from go_on mode patience place rock_density)" run inputs/demo/in.place -var bench 1
must_work run inputs/demo/in.place -var place anywhere

must_work help
for words in help -h --help 'run --help' 'run inputs/demo/in.demo -np 1 -h' 'test --help' 'build -help' 'verify --help' 'benchmark -h' 'install-deps --help'; do
  read -ra words <<<"$words"
  must_work "${words[@]}"
  grep -qF './muckpile run INPUT' <<<"$output" || problem "no help by: ${words[*]}"
  [[ ! -e calls ]] || problem "more than help by: ${words[*]}"
done
must_work run inputs/demo/in.demo -np 1 -var bench_height 10 -var rock_density 2.6e3
called '^mpirun -np 1 .*-in inputs/demo/in.demo .*-var out results/demo -var bench_height 10 -var rock_density 2.6e3$'
called '^muckpile-post all results/demo$'
must_work run inputs/demo/in.demo -np 1 -vtk
called '^muckpile-post all results/demo --vtk$'
! grep -q '^apt-get' calls || problem "apt-get ran though nothing is missing"
grep -qE 'throw_cg_m +8.5' <<<"$output" || problem "the key figures are not shown"

echo old >results/demo/dump/blocks_000000009.csv
must_work run inputs/demo/in.demo -var go_on 1 -var from a.restart -var patience 8
called '-var go_on 1 -var from a.restart -var patience 8$'
[[ -e results/demo/dump/blocks_000000009.csv ]] || problem "a run that goes on lost what was there"

(
  flock 9
  must_refuse "another run writes to 'results/demo'" run inputs/demo/in.demo
) 9>results/demo/.lock
must_work run inputs/demo/in.demo
must_work run inputs/demo/in.demo -out -x
called '-var out ./-x$'

# 5 is another run's; the seal stands in the last 24 bytes.
interrupt() {  # interrupt END [BEFORE]: the engine writes 77, ending so, and stops
  rm -rf results/demo
  fake bin/mpirun "${2-}printf 'state%s$1%016d' '' 0 >restart_forced_liggghts_77.data
    echo \"interrupted: the state is in 'restart_forced_liggghts_77.data'\" >results/demo/log.liggghts"
}
touch -d '1 hour' restart_forced_liggghts_5.data
interrupt MuckSeal
call run inputs/demo/in.demo
told '-var go_on 1 -var from results/demo/dump/interrupted.restart goes on'
[[ -s results/demo/dump/interrupted.restart && -e restart_forced_liggghts_5.data ]] || problem "the state of an interrupted run is not kept"
interrupt MuckSeal
call run inputs/demo/in.demo -var go_on 1 -var from a.restart
told '-var from results/demo/dump/interrupted.restart in place of those given goes on'
printf 'variable out index x\n' >inputs/demo/in.once
interrupt MuckSeal
call run inputs/demo/in.once
told 'its state is in results/demo/dump/interrupted.restart'
! grep -qF 'go_on' <<<"$output" || problem "an input that cannot go on is said to"
interrupt MuckSeal 'mkdir -p results/demo/muck/dump; echo scene >results/demo/muck/dump/scene.json; '
call run inputs/demo/in.demo
told 'interrupted in the pour of the muck; the same command with -var pour_from results/demo/muck/dump/interrupted.restart goes on'
[[ -s results/demo/muck/dump/interrupted.restart ]] || problem "the state of an interrupted pour is not kept"
printf 'variable pour_from index none\nvariable muck index none\nvariable out index x\n' >inputs/demo/in.muck
call run inputs/demo/in.muck -var pour_from results/demo/muck/dump/interrupted.restart -out results/demo
[[ -s results/demo/muck/dump/scene.json ]] || problem "a pour that goes on lost what was there"
must_refuse "muck must be outside of 'results/demo'" run inputs/demo/in.muck -var muck results/demo/muck -out results/demo
must_refuse "muck must be outside of 'results/demo'" run inputs/demo/in.muck -var muck results/demo/dump/.. -out results/demo
interrupt other
call run inputs/demo/in.demo
told 'has lost its end'
! grep -q '^muckpile-post' calls || problem "an interrupted run was post-processed"
[[ ! -e results/demo/dump/interrupted.restart ]] || problem "a file cut short is kept"

# What a run before left in its log is not this one's; restart_forced_liggghts_5.data may be another's.
echo "interrupted: the state is in 'restart_forced_liggghts_5.data'" >results/demo/log.liggghts
fake bin/mpirun 'exit 1'
call run inputs/demo/in.demo
! grep -qF 'interrupted' <<<"$output" || problem "a run that failed is called interrupted"
[[ -e restart_forced_liggghts_5.data ]] || problem "the state of another run is taken"

printf 'variable out index x\ndump ${out}/dump ${out}/frames.txt\n' >inputs/demo/in.dumps
# Old results: replaced when the new run has started, else as they were.
results=(dump/{a.restart,b.restart,blocks.vtk,blocks_000000000.csv,blocks_000000100.csv,blocks_000000200.bin,history.csv,run.json,scene.json,floor.stl,behind.stl,gas.csv,gauges.csv,holes.csv,burden.csv,gas_after_restart.csv,ground.stl,gate.stl,interrupted.restart,stopped.restart}
  vtk/{blocks.pvd,blocks_0.vtu} {profile,movement,polygons,rows,heights,face_velocity,waves,ppv,survey,damage,crater,heap,fragments,energy,plan}.{csv,png} {flyrock,sieve,boulders,fragments_list,model_moved,polygons_moved,energy_holes,hole_polygons}.csv {movement,polygons}.dxf report.html pile3d.csv pile3d.png pile3d_0001.png
  summary.json log.liggghts)
results+=(muck/dump/{blocks.vtk,blocks_000000300.csv,history.csv,scene.json,run.json,gate.stl,interrupted.restart} muck/{heap.csv,heap.png,summary.json})
# Whatever muckpile-post writes must be known to the script.
mapfile -t reported < <(grep -rhoE '[.>]file\("[a-z0-9_]+\.[a-z]+"\)' "$(dirname "$script")/postproc/lib" | sed -E 's/.*"(.*)".*/\1/' | sort -u)
[[ ${#reported[@]} -ge 10 ]] || problem "muckpile-post's files are not found"
results+=("${reported[@]}")
own_files=(notes.txt dump/survey.csv dump/keep_0.5s.restart dump/blocks_mine.csv dump/notes.json)
old_results() {  # in results/demo, and a file that is not the run's
  local file
  rm -rf results/demo
  mkdir -p results/demo/{dump,vtk,muck/dump}
  for file in "${results[@]}"; do echo "old $file" >"results/demo/$file"; done
  for file in "${own_files[@]}"; do echo mine >"results/demo/$file"; done
}
contents() { (cd results/demo && find . -type f ! -name .lock -print0 | sort -z | xargs -0 grep -H ''); }
must_be_whole() { [[ $(contents) == "$whole" ]] || problem "old results are not whole: $1"$'\n'"$(diff <(contents) <(echo "$whole"))"; }
old_results
whole=$(contents)
writes='echo new >results/demo/dump/'  # writes FILE: a body of a fake

set_up="printf 'step,time_s,run_id\n0,0,new\n' >results/demo/dump/history.csv; ${writes}blocks_000000000.csv"  # all that it shows is step 0
steps="$set_up; echo 200,1e-3,new >>results/demo/dump/history.csv"

healthy
old_results
call run inputs/demo/in.demo -var bench_height 3,x -np 99999
must_be_whole "refused by the script"
fake bin/mpirun "${writes}scene.json; ${writes}gas.csv; echo ERROR >results/demo/log.liggghts; exit 1"
call run inputs/demo/in.demo -var bench_height 3,x
[[ $status -eq 1 ]] || problem "a refused run must end with status 1"
told "before its first step; see the message above; what 'results/demo' held is back in its place"
must_be_whole "refused by the engine"
fake bin/mpirun 'echo asked >>calls; ls results/demo results/demo/* >>calls; exit 1'
call run inputs/demo/in.demo
! grep -qE 'history.csv|profile|a.restart|scene.json' calls || problem "the engine finds old results in its folder"
must_be_whole "refused by the engine"

fake bin/mpirun "$engine_ok; $steps"
must_work run inputs/demo/in.demo
[[ $(contents | grep -v '^./profile.png' | grep old) == '' ]] || problem "old results stay beside new ones: $(contents)"
[[ $(contents | grep -c ':mine$') -eq ${#own_files[@]} && ! -e results/demo/.previous ]] || problem "what is not of a run must stay, .previous go"
old_results
fake bin/mpirun "$engine_ok"  # ends well, without a snapshot
must_work run inputs/demo/in.demo
! contents | grep -q old || problem "old results stay beside new ones"
old_results
fake bin/mpirun "$set_up; exit 1"
call run inputs/demo/in.demo
told 'before its first step'
must_be_whole "of a run that stopped in its set-up"
for first in "$steps" "$set_up; ${writes}blocks_000000100.csv" "$set_up; ${writes}stopped.restart"; do
  old_results
  fake bin/mpirun "$first; exit 1"
  call run inputs/demo/in.demo
  told 'see the message above or results/demo/log.liggghts'
  ! contents | grep -q old || problem "old results stay beside those of a run that stopped"
done
old_results
fake bin/mpirun 'echo x >results/demo/frames.txt'  # ends well, and writes outside of dump/
must_work run inputs/demo/in.dumps
! contents | grep -q old || problem "old results stay beside what a run wrote outside of dump/"

old_results
fake bin/mpirun 'cat results/demo/dump/holes.csv results/demo/dump/gas.csv >>calls; exit 1'
printf 'variable table index none\nvariable out index x\nread "results/demo/dump/gas.csv"  # results/demo/dump/a.restart\n' >inputs/demo/in.table
call run inputs/demo/in.table -var table results/demo/dump/holes.csv
called '^old dump/holes.csv$'
called '^old dump/gas.csv$'
must_be_whole "of which a refused run read some"
fake bin/mpirun "test ! -e results/demo/dump/a.restart && { $steps; $engine_ok; }"
must_work run inputs/demo/in.table -var table results/demo/dump/holes.csv
[[ $(cat results/demo/dump/holes.csv) == 'old dump/holes.csv' ]] || problem "a file that the new run read is gone"

# A script that is killed leaves old results set aside: all of them, or some.
for signal in USR1 PIPE KILL; do
  old_results
  fake bin/mpirun "kill -$signal \$PPID; sleep 0.2; exit 1"
  call run inputs/demo/in.demo
  [[ -d results/demo/.previous && ! -e results/demo/dump/history.csv ]] || problem "old results must wait in .previous: $signal"
done
fake bin/mpirun 'exit 1'
call run inputs/demo/in.demo
must_be_whole "after a killed script"
old_results
mkdir -p results/demo/.previous.part/{dump,vtk}
mv results/demo/dump/{a.restart,history.csv} results/demo/.previous.part/dump
call run inputs/demo/in.demo -var go_on 1 -var from results/demo/dump/a.restart
[[ -e results/demo/dump/a.restart && ! -e results/demo/.previous.part ]] || problem "half of a move is not undone"
old_results
fake bin/mpirun "$set_up; kill -KILL \$PPID; sleep 0.2"
call run inputs/demo/in.demo
fake bin/mpirun 'exit 1'
call run inputs/demo/in.demo
must_be_whole "after a script that was killed in the set-up"
fake bin/mpirun "$steps; kill -KILL \$PPID; sleep 0.2"
call run inputs/demo/in.demo
fake bin/mpirun 'exit 1'
call run inputs/demo/in.demo
[[ $(contents | grep -c 'new') -eq 3 && ! -e results/demo/.previous ]] || problem "results of a killed script's run are not kept"

# A run that goes on has the old log set aside only.
old_results
refused='echo ERROR >results/demo/log.liggghts; exit 1'
fake bin/mpirun "$refused"
call run inputs/demo/in.demo -var go_on 1 -var from a.restart
must_be_whole "of a refused run that goes on"
fake bin/mpirun 'kill -KILL $PPID; sleep 0.2; exit 1'
call run inputs/demo/in.demo -var go_on 1 -var from a.restart
[[ ! -e results/demo/log.liggghts ]] || problem "the engine finds the log of an earlier run"
fake bin/mpirun "$refused"
call run inputs/demo/in.demo -var go_on 1 -var from a.restart
must_be_whole "of a run that goes on, after a killed script"
fake bin/mpirun "echo 300,2e-3,new >>results/demo/dump/history.csv; $refused"
call run inputs/demo/in.demo -var go_on 1 -var from a.restart
[[ $(cat results/demo/log.liggghts) == ERROR && ! -e results/demo/.previous.log ]] || problem "the log of a run that went on is lost"

# Ctrl-C before the first step.
old_results
fake bin/mpirun "trap 'exit 1' USR2; kill -TERM \$PPID; for ((k = 0; k < 600; ++k)); do sleep 0.1; done"
call run inputs/demo/in.demo
[[ $status -eq 130 ]] || problem "a run interrupted in its set-up must end with status 130"
told 'interrupted before the first step; nothing was changed'
! grep -qF 'see the message' <<<"$output" || problem "there is no message above"
must_be_whole "of a run interrupted in its set-up"
fake bin/mpirun "$steps; trap 'exit 1' USR2; kill -TERM \$PPID; for ((k = 0; k < 600; ++k)); do sleep 0.1; done"
call run inputs/demo/in.demo
[[ $status -eq 130 ]] || problem "an interrupted run must end with status 130"
told 'interrupted; there is no state to go on from'

# Ctrl-C behind the last step, as the engine is about to end; behind its end, as its results are measured. The run is whole.
old_results
ends_whole="echo 'whole: the input has run to its end' >>results/demo/log.liggghts"
is_stopped="asked=''; trap 'asked=1' USR2; kill -TERM \$PPID; for ((k = 0; k < 600; ++k)); do sleep 0.1; [[ -z \$asked ]] || break; done"
fake bin/mpirun "$steps; $engine_ok; $ends_whole; $is_stopped; exit 0"
call run inputs/demo/in.demo
[[ $status -eq 130 ]] || problem "a run that was interrupted behind its last step must end with status 130"
told 'interrupted; the run in results/demo is whole, and not measured: build/release/postproc/tools/muckpile-post all results/demo does that'
[[ -e results/demo/dump/scene.json && ! -e results/demo/.previous ]] || problem "a whole run is not kept"
! grep -q '^muckpile-post' calls || problem "measured behind a signal"
# A plain run that is cut short; a log that a full disk has cut; an error and a killed rank behind a signal: none of them is whole.
for end in "echo 'interrupted: before the last step of a run' >>results/demo/log.liggghts; exit 0" \
  "$ends_whole; echo 'interrupted: before the first step of phase two' >>results/demo/log.liggghts; exit 0" 'exit 0' "$ends_whole; exit 1" "$ends_whole; exit 137"; do
  fake bin/mpirun "$steps; $engine_ok; $is_stopped; $end"
  call run inputs/demo/in.demo
  [[ $status -eq 130 ]] || problem "an interrupted run must end with status 130: $end"
  told 'interrupted; there is no state to go on from'
  ! grep -q '^muckpile-post' calls || problem "an interrupted run was measured: $end"
done
# A signal that has reached the engine alone.
fake bin/mpirun "$steps; $engine_ok; echo 'interrupted: before the last step of a run' >>results/demo/log.liggghts; exit 0"
call run inputs/demo/in.demo
[[ $status -eq 130 ]] || problem "a run whose engine was interrupted must end with status 130"
told 'interrupted; there is no state to go on from'
! grep -q '^muckpile-post' calls || problem "a run whose engine was interrupted was measured"
fake bin/mpirun "$steps; $engine_ok"
fake build/release/postproc/tools/muckpile-post 'trap "echo stopped >>calls; exit 143" TERM; kill -TERM $PPID; for ((k = 0; k < 600; ++k)); do sleep 0.1; done'
call run inputs/demo/in.demo -vtk
[[ $status -eq 130 ]] || problem "a run that was interrupted as it was measured must end with status 130"
told 'not measured: build/release/postproc/tools/muckpile-post all results/demo --vtk does that'
called '^stopped$'

# A full disk.
healthy
old_results
fake bin/mpirun ''
must_be_told() { call "${@:2}"; [[ $status -ne 0 ]] || problem "passed"; told "$1"; }
must_be_told 'the run left nothing in' run inputs/demo/in.dumps
must_be_whole "of a run that left nothing"
fake bin/mpirun "$engine_ok; : >results/demo/dump/mark"  # the user's own
must_work run inputs/demo/in.dumps
fake bin/mpirun "$engine_ok; : >results/demo/dump/history.csv"
must_be_told 'results/demo/dump/history.csv' run inputs/demo/in.dumps
! grep -q '^muckpile-post' calls || problem "an empty file was post-processed"
fake bin/mpirun ''
must_work run inputs/demo/in.once
told 'nothing to extract'

# Files are taken from the caller's folder.
healthy
rm -rf results/demo
mkdir -p elsewhere/files
echo 1 >elsewhere/files/a.restart
cp elsewhere/files/a.restart elsewhere/holes.csv
cp elsewhere/files/a.restart elsewhere/3
cp inputs/demo/in.demo elsewhere/in.copy
from_elsewhere() {
  rm -f calls
  status=0
  output=$(cd elsewhere && PATH="$tree/bin:$PATH" ../muckpile "$@" 2>&1) || status=$?
}
printf 'variable table index none\n' >>inputs/demo/in.demo
from_elsewhere run ../inputs/demo/in.demo -var go_on 1 -var from files/a.restart -var table ./holes.csv -var bench_height 3 -out ../results/demo
called '-var out results/demo -var go_on 1 -var from elsewhere/files/a.restart -var table elsewhere/holes.csv -var bench_height 3$'
from_elsewhere run ../inputs/demo/in.demo -var go_on 1 -var from 'files/*.restart' -var table inputs/demo/in.demo -out ../results/demo
called '-var from elsewhere/files/\*.restart -var table inputs/demo/in.demo$'
from_elsewhere run in.copy -var patience 8 -var mode slow
called '-in elsewhere/in.copy .*-var patience 8 -var mode slow$'
must_refuse "-var mode must be one of slow, got 'x'" run elsewhere/in.copy -var mode x

# A signal to the script reaches mpirun as one that it hands on; TERM, as INT may be ignored here.
fake bin/mpirun "trap 'echo asked >>calls; exit 0' USR2; kill -TERM \$PPID; for ((k = 0; k < 600; ++k)); do sleep 0.1; done; $engine_ok"
call run inputs/demo/in.demo
called '^asked$'
[[ $status -ne 0 ]] || problem "an interrupted run passed"
! grep -q '^muckpile-post' calls || problem "an interrupted run was post-processed"

mkdir -p results/demo/dump
rm -f results/demo/.lock
mkdir results/demo/.lock  # root writes to any folder, but not to this
must_refuse "cannot write to 'results/demo'" run inputs/demo/in.demo
rmdir results/demo/.lock

fake bin/mpirun 'exit 3'
call run inputs/demo/in.demo
[[ $status -ne 0 ]] || problem "a failed run passed"
! grep -q '^muckpile-post' calls || problem "a failed run was post-processed"

healthy
fake build/release/postproc/tools/muckpile-post 'echo "{}" >results/demo/summary.json; exit 1'
call run inputs/demo/in.demo
[[ $status -ne 0 ]] || problem "failed post-processing passed"

# A folder in that of the results which this user cannot read, as lost+found of a disk.
healthy
fake bin/find "$(command -v find) \"\$@\"; exit 1"
must_work run inputs/demo/in.demo
rm bin/find

healthy
fake bin/cmake 'exit 1'
must_refuse "the build failed" run inputs/demo/in.demo

healthy
fake bin/dpkg-query 'shift 2; for p in "$@"; do case $p in ninja-build) ;; cmake) echo "cmake config-files" ;;
  *) echo "$p installed" ;; esac; done; exit 1'
fake bin/id 'echo 1000'
fake bin/sudo '"$@"'
must_work install-deps
called '^sudo env DEBIAN_FRONTEND=noninteractive apt-get .*install -y --no-install-recommends cmake ninja-build$'
fake bin/dpkg-query 'shift 2; for p in "$@"; do [[ $p == lammps ]] || echo "$p installed"; done; exit 1'
must_work install-deps lammps
called 'install -y --no-install-recommends lammps$'
fake bin/apt-get 'exit 100'
must_refuse "apt-get update failed" install-deps lammps

rm bin/*
for tool in bash readlink dirname; do ln -s "$(command -v "$tool")" bin/; done
status=0
output=$(PATH="$tree/bin" ./muckpile install-deps 2>&1) || status=$?
[[ $status -ne 0 ]] || problem "a system without apt-get passed"
grep -qF 'no apt-get here' <<<"$output" || problem "absence of apt-get is not told"
