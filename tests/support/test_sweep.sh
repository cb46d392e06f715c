#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# test_sweep.sh MUCKPILE_POST: ./muckpile sweep runs every combination once, as many at once as it should, does again what is missing, failed or
# was made otherwise, and refuses wrong words before any run.
# Scope: fake apt-get, cmake and mpirun; the tables are those of the real muckpile-post, which has its own tests.
# shellcheck disable=SC2016  # the bodies of the fakes expand when they run
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/script.sh"
post=$(readlink -f "$1")
source "$here/fake_tree.sh"
mkdir -p src/{core,figures} fixes postproc/{lib,tools} cmake
touch CMake{Lists.txt,Presets.json}
printf 'variable burden index 3 # m\nvariable seed index 1\nvariable table index none\n' >>inputs/demo/in.demo

# Writes what a run writes, unless there is a file nothing. The run whose variables are like the pattern in the file fail stops with an error; that in the file hang waits
# until it is asked to stop; that in the file late is asked behind its last step.
fake bin/mpirun '
out="" knobs=""
while (($#)); do
  if [[ $1 == -var ]]; then
    [[ $2 == out ]] && out=$3 || knobs+=", \"$2\": $([[ $3 =~ ^[0-9.]+$ ]] && echo "$3" || echo "\"$3\"")"
    shift 3
  else shift; fi
done
matches() { [[ -e $1 && $knobs == *$(cat "$1")* ]]; }
echo "LIGGGHTS 3.8"
[[ -d $OMPI_MCA_orte_tmpdir_base ]] && echo "$OMPI_MCA_orte_tmpdir_base" >>sessions
touch "at_once/$$" && trap "rm at_once/$$" EXIT
find at_once -type f | wc -l >>begun
[[ ! -e nothing ]] || exit 0
matches fail && { echo "ERROR: no rock (rock.cpp:3)"; exit 1; }
if matches hang; then
  trap "echo asked >>begun; exit 0" USR2
  touch hanging
  for ((k = 0; k < 600; ++k)); do sleep 0.1; done
fi
mkdir -p "$out/dump"
echo "{\"case\": \"bench\", \"run_id\": \"$(md5sum <<<"$knobs" | cut -c -16)\", \"burden_m\": 3, \"knobs\": {${knobs#, }}}" >"$out/dump/scene.json"
printf "step,time_s\n0,0\n200,0.1\n" >"$out/dump/history.csv"
if matches late; then
  asked="" && trap "asked=1" USR2
  touch hanging
  for ((k = 0; k < 600; ++k)); do [[ -z $asked ]] || { echo "whole: the input has run to its end" >"$out/log.liggghts" && exit 0; }; sleep 0.1; done
fi
for ((k = 0; k < 200; ++k)); do [[ -e together && $(wc -l <begun) -lt $(cat together) ]] || break; sleep 0.05; done'
# 24 m over the burden, and a tenth of the seed. Measuring the run whose scene is like the pattern in the file linger lasts until it is stopped.
fake build/release/postproc/tools/muckpile-post '
[[ $1 == all ]] || exec '"$post"' "$@"
[[ ! -s $2/summary.json && -e $2/summary.json ]] && { echo "muckpile-post: summary.json: parse error" >&2; exit 1; }
if [[ -e unmeasured ]] && grep -q "$(cat unmeasured)" "$2/dump/scene.json"; then
  echo "muckpile-post: profile $2" && echo "muckpile-post: no pile" >&2
  exit 1
fi
if [[ -e linger ]] && grep -q "$(cat linger)" "$2/dump/scene.json"; then
  trap "echo stopped >>begun; exit 143" TERM
  touch hanging
  for ((k = 0; k < 600; ++k)); do sleep 0.1; done
fi
number() { sed -nE "s/.*\"$1\": ([0-9.]+).*/\1/p" "$2/dump/scene.json"; }
id=$(sed -nE "s/.*\"run_id\": \"([0-9a-f]*)\".*/\1/p" "$2/dump/scene.json")
burden=$(number burden "$2") seed=$(number seed "$2")
awk -v b="${burden:-3}" -v s="${seed:-1}" -v id="$id" \
  "BEGIN { printf \"{\\\"case\\\": \\\"bench\\\", \\\"run_id\\\": \\\"%s\\\", \\\"throw_cg_m\\\": %g, \\\"still\\\": true}\n\", id, 24 / b + s / 10 }" >"$2/summary.json"'
fake_tools
fake bin/nproc 'echo 2'
fake bin/lscpu 'printf "0,0\n1,0\n"'
mkdir at_once
sweep() {
  rm -f begun
  call sweep inputs/demo/in.demo "$@"
}
at_once_were() { [[ $(sort -n begun | tail -n 1) -eq $1 ]] || problem "not $1 at once: $(cat begun)"; }  # at_once_were MOST
runs_were() { [[ $(grep -c '^mpirun ' calls || true) -eq $1 ]] || problem "not $1 runs"; }  # runs_were NUMBER
ended_with() { [[ $status -eq $1 ]] || problem "status is not $1"; }

must_refuse "sweep needs an input" sweep -var burden 2,3
must_refuse "sweep needs two runs at least: -var NAME V1,V2,... with a comma" sweep inputs/demo/in.demo -var burden 2
must_refuse "sweep needs two runs at least" sweep inputs/demo/in.demo -var burden 2 -seeds 1
for values in 1,,2 ,1 1, ,; do must_refuse "-var burden has an empty value in '$values'" sweep inputs/demo/in.demo -var burden "$values"; done
must_refuse "-var burden has the value 2 twice" sweep inputs/demo/in.demo -var burden 2,3,2.0
must_refuse "-var burden is given twice" sweep inputs/demo/in.demo -var burden 2,3 -var burden 4,5
for word in -out -np -jobs -seeds -samples; do must_refuse "$word is given twice" sweep inputs/demo/in.demo -var burden 2,3 "$word" 2 "$word" 3; done
must_refuse "-var burden has the range '2..3' among values; a range goes alone" sweep inputs/demo/in.demo -var burden 4,2..3
must_refuse "-var burden is given twice" sweep inputs/demo/in.demo -var burden 2,3 -var burden 4
must_refuse "-var seed is given twice" sweep inputs/demo/in.demo -var burden 2,3 -var seed 4 -seeds 2
must_refuse "has no variable 'burdn'; did you mean 'burden'?" sweep inputs/demo/in.demo -var burdn 2,3
must_refuse "-var mode must be one of slow, got 'fast'" sweep inputs/demo/in.demo -var mode slow,fast
must_refuse "-var mode must be one of slow, got 'fast'" sweep inputs/demo/in.demo -var mode fast,slow
must_refuse "a sweep begins each run anew" sweep inputs/demo/in.demo -var burden 2,3 -var go_on 1
must_refuse "unknown option '-frames' of sweep (known: -np, -var, -out, -vtk, -seeds, -samples, -jobs)" sweep inputs/demo/in.demo -frames 3
must_refuse "two runs would have the same folder 'table-a_b'" sweep inputs/demo/in.demo -var table 'a:b,a;b'
for number in 0 -1 two 1.5 '' 12345; do
  must_refuse "-seeds must be a whole number from 1 to 9999, got '$number'" sweep inputs/demo/in.demo -var burden 2,3 -seeds "$number"
  must_refuse "-jobs must be a whole number from 1 to 9999, got '$number'" sweep inputs/demo/in.demo -var burden 2,3 -jobs "$number"
done
must_refuse "-jobs times -np must be at most 32 on 2 cores, got '17' times '2'" sweep inputs/demo/in.demo -var burden 2,3 -np 2 -jobs 17
must_refuse "-samples needs a range to take values from" sweep inputs/demo/in.demo -var burden 2,3 -samples 4
must_refuse "-var burden 2..3 is a range; -samples N says how many runs" sweep inputs/demo/in.demo -var burden 2..3
must_refuse "-seeds is for lists of values" sweep inputs/demo/in.demo -var burden 2..3 -samples 4 -seeds 2
must_refuse "ranges go with single values" sweep inputs/demo/in.demo -var burden 2..3 -var bench_height 6,9 -samples 4
must_refuse "has no variable 'burdn'; did you mean 'burden'?" sweep inputs/demo/in.demo -var burdn 2..3 -samples 4
must_refuse "'burden=3..2' must rise" sweep inputs/demo/in.demo -var burden 3..2 -samples 4
for number in 0 1 1.5; do
  must_refuse "-samples must be a whole number from 2 to 9999, got '$number'" sweep inputs/demo/in.demo -var burden 2..3 -samples "$number"
done
must_refuse "-var seed cannot be a range" sweep inputs/demo/in.demo -var burden 2..3 -var seed 1..9 -samples 4
# Of muckpile-post itself: ./muckpile sweep has refused a variable that is given twice before.
status=0 output=$("$post" sample burden=2..4 burden=1..2 --runs 3 2>&1) || status=$?
((status != 0)) && [[ $output == *"sample: each variable once, got 'burden' twice"* ]] || problem "a variable is sampled twice: $output"
[[ ! -e results ]] || problem "a refused sweep has made a folder"

# Every combination, the last fastest, each with its own folder; two at once on two cores.
echo 2 >together
sweep -var burden 2,3,4 -var patience 5 -var bench_height 6,9 -seeds 2
rm together
ended_with 0
runs_were 12
# Each with a folder of its own for what Open MPI keeps, which goes with it.
[[ $(sort -u sessions | wc -l) -eq 12 ]] || problem "runs share a folder of Open MPI"
while read -r folder; do [[ ! -e $folder ]] || problem "$folder has stayed"; done <sessions
called '^mpirun -np 1 .*-var out results/sweep_demo/burden-3,bench_height-9,seed-2 -var patience 5 -var burden 3 -var bench_height 9 -var seed 2$'
at_once_were 2
demo=results/sweep_demo
[[ $(sed -n 2,6p $demo/sweep_runs.csv) == 'folder,state,burden,bench_height,seed
burden-2;bench_height-6;seed-1,done,2,6,1
burden-2;bench_height-6;seed-2,done,2,6,2
burden-2;bench_height-9;seed-1,done,2,9,1
burden-2;bench_height-9;seed-2,done,2,9,2' ]] || problem "runs are not listed in order: $(cat $demo/sweep_runs.csv)"
[[ $(sed -n '1p;$p' $demo/sweep.csv) == 'burden,bench_height,seed,state,still,throw_cg_m
4,9,2,done,1,6.2' ]] || problem "the table is wrong: $(cat $demo/sweep.csv)"
for file in sweep.png sweep_mean.csv sweep_fit.csv burden-2,bench_height-6,seed-1/run.log; do [[ -s $demo/$file ]] || problem "no $file"; done
told '12 of 12 runs done, 0 failed'

# Samples of ranges: each run has values and a seed of its own, and the same again.
sweep -var burden 2..4 -var patience 5 -var bench_height log:6..12 -samples 4 -out results/sampled
ended_with 0 && runs_were 4
sampled=results/sampled
[[ $(sed -n 2,3p $sampled/sweep_runs.csv) == '# sampled burden=2..4 bench_height=log:6..12
folder,state,burden,bench_height,seed' ]] || problem "the list does not say what was sampled: $(cat $sampled/sweep_runs.csv)"
[[ $(tail -n +4 $sampled/sweep_runs.csv | cut -d, -f 2,5) == $'done,1\ndone,2\ndone,3\ndone,4' ]] || problem "not a seed for each: $(cat $sampled/sweep_runs.csv)"
for file in sweep.csv sweep_mean.csv sweep_influence.csv sweep.png; do [[ -s $sampled/$file ]] || problem "no $file"; done
sweep -var burden 2..4 -var patience 5 -var bench_height log:6..12 -samples 4 -out results/sampled
ended_with 0 && runs_were 0
# Of fourteen ranges a run is checked at each end, not at all combinations of their ends, which would be more than a sweep does.
many=()
cp inputs/demo/in.demo in.demo.before
for k in {1..14}; do
  printf 'variable k%s index 1\n' "$k" >>inputs/demo/in.demo
  many+=(-var "k$k" 1..2)
done
sweep "${many[@]}" -samples 2 -out results/many
ended_with 0 && runs_were 2
mv in.demo.before inputs/demo/in.demo
sweep -var burden 2..4 -var seed 7 -samples 2 -out results/one_seed
ended_with 0 && runs_were 2
[[ $(sed -n 3p results/one_seed/sweep_runs.csv) == folder,state,burden ]] || problem "a seed that was given is sampled"

# Nothing to do; more values; fewer cores.
sweep -var burden 2,3,4 -var patience 5 -var bench_height 6,9 -seeds 2
ended_with 0 && runs_were 0
told '12 runs, 12 done before; 2 at once with -np 1 on 2 cores'
sweep -var patience 5 -var burden 2,3,4 -var bench_height 6,9 -seeds 3 -jobs 1
ended_with 0 && runs_were 6
at_once_were 1
sweep -var burden 2,3 -np 2 -vtk -out results/two_ranks
ended_with 0 && runs_were 2
told '1 at once with -np 2 on 2 cores'
called '^muckpile-post all results/two_ranks/burden-3 --vtk$'
at_once_were 1

# What a run came of has changed: another build, input, file, value; other results in the folder; another muckpile-post.
two() { sweep -var burden 2,3 -var table elsewhere.csv -out results/two; }
must_do() {  # must_do NUMBER WHY
  two
  ended_with 0 && runs_were "$1"
  told "${2-2 of 2 runs done}"
}
echo 1 >elsewhere.csv
mkdir -p results/two && two
must_do 0
echo 2 >fixes/fix_blast.cpp
must_do 2 'begins anew burden-2: engine changed since'
echo '# another' >>inputs/common/mode_slow.in
must_do 2 'begins anew burden-3: input changed since'
sed -i s/elsewhere.csv/./ inputs/demo/in.demo
sweep -var burden 2,3 -var table ./elsewhere.csv -out results/two
echo 2 >elsewhere.csv
must_do 2 'variable table changed since'
sweep -var burden 2,3 -var table none -out results/two
ended_with 0 && runs_were 2
told 'variable table changed since'
call run inputs/demo/in.demo -var burden 5 -out results/two/burden-2
two && must_do 0
call run inputs/demo/in.demo -var burden 5 -out results/two/burden-2
must_do 1 'begins anew burden-2: results changed since'
rm results/two/burden-3/summary.json
must_do 0 'measured again burden-3'
echo 2 >postproc/lib/pile.cpp
must_do 0 'measured again burden-3'
called '^muckpile-post all results/two/burden-3$'
must_do 0
! grep -q '^muckpile-post all' calls || problem "measured once too often"

# One fails: the others are run; it is told, and done again.
echo '"burden": 3,' >fail
sweep -var burden 2,3,4 -seeds 1 -out results/failing
ended_with 1
runs_were 3
told 'failed burden-3,seed-1: ERROR: no rock (rock.cpp:3)'
told 'failed: burden-3,seed-1, log results/failing/burden-3,seed-1/run.log'
told '2 of 3 runs done, 1 failed'
grep -qx '3,1,failed,,' results/failing/sweep.csv || problem "the table does not say that a run failed"
rm fail
sweep -var burden 2,3,4 -seeds 1 -out results/failing
ended_with 0 && runs_were 1
echo '"burden"' >fail
sweep -var burden 2,3 -out results/none
ended_with 1
told '0 of 2 runs done, 2 failed'
rm fail
touch nothing
sweep -var burden 2,3 -out results/none
ended_with 1
told 'failed burden-2: muckpile: inputs/demo/in.demo has written nothing to its ${out}'
rm nothing
# Where it is muckpile-post that fails, its last words are the reason; so is a folder that cannot be made. The others are run.
echo '"burden": 3' >unmeasured
sweep -var burden 2,3 -out results/unmeasured
ended_with 1
told 'failed burden-3: muckpile-post: no pile'
told '1 of 2 runs done, 1 failed'
rm unmeasured
: >results/unmeasured/burden-2/summary.json
sweep -var burden 2,3 -out results/unmeasured
ended_with 0 && runs_were 0
touch results/unmeasured/burden-4
sweep -var burden 4,5 -jobs 1 -out results/unmeasured
ended_with 1
told "failed burden-4: cannot make the folder 'results/unmeasured/burden-4'"
told '1 of 2 runs done, 1 failed'

# A signal stops what is running and begins nothing more; TERM, as INT may be ignored here.
sweep_stopped() {  # sweep_stopped OUT: once it hangs
  rm -f hanging calls begun
  (
    for ((k = 0; k < 600; ++k)); do [[ ! -e hanging ]] || break; sleep 0.05; done
    kill -TERM "$(cat script)"
  ) &
  status=0
  output=$(PATH="$tree/bin:$PATH" bash -c 'echo $$ >script; exec ./muckpile sweep inputs/demo/in.demo -var burden 2,3,4 -jobs 1 -out '"$1" 2>&1) || status=$?
  ended_with 130
}
echo '"burden": 2' >hang
sweep_stopped results/stopped
told 'interrupted burden-2'
told 'interrupted; the same command does what is missing'
grep -qx asked begun || problem "the engine was not asked to stop"
[[ $(tail -n +3 results/stopped/sweep_runs.csv) == $'burden-2,interrupted,2\nburden-3,waiting,3\nburden-4,waiting,4' ]] || problem "the states are wrong"
rm hang
sweep -var burden 2,3,4 -jobs 1 -out results/stopped
ended_with 0 && runs_were 3

# A signal behind the last step of a run, or as it is measured, leaves what the engine has done: the next call measures it only.
must_be_measured_only() {
  told 'interrupted burden-2: the run is whole, and not measured'
  [[ $(tail -n +3 results/whole/sweep_runs.csv) == $'burden-2,measure,2\nburden-3,waiting,3\nburden-4,waiting,4' ]] || problem "the states are wrong"
  sweep -var burden 2,3,4 -jobs 1 -out results/whole
  ended_with 0 && runs_were 2
  told 'measured again burden-2'
  told '3 of 3 runs done, 0 failed'
  rm -r results/whole
}
echo '"burden": 2' >late
sweep_stopped results/whole
rm late
! grep -q '^muckpile-post all' calls || problem "measured behind a signal"
must_be_measured_only
echo '"burden": 2' >linger
sweep_stopped results/whole
rm linger
grep -qx stopped begun || problem "the measuring was not stopped"
must_be_measured_only

(
  flock 9
  must_refuse "another run writes to 'results/stopped'" sweep inputs/demo/in.demo -var burden 2,3 -out results/stopped
) 9>results/stopped/.lock
