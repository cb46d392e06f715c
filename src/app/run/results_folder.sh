# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# The folder OUT of a run: its lock, its old results, what an interrupted run leaves. Old results wait in OUT/.previous until it is known
# whether the new run starts, and come back if it does not.
# Scope: sourced by muckpile, whose say() and die() it uses; takes what a run and muckpile-post write, by name, and leaves other files alone.

# Two runs in one folder would write over each other. The lock lasts as long as this script or its mpirun lives; where there is
# no flock, nothing is locked.
lock() {  # lock OUT
  command -v flock >/dev/null || return 0
  { exec {lock_file}>"$1/.lock"; } 2>/dev/null || die "cannot write to '$1'"
  flock -n "$lock_file" || die "another run writes to '$1'; choose another folder with -out"
}

# LIGGGHTS leaves its state in the present folder when it is interrupted (Ctrl-C), under a name that another run may use too:
# the log has this run's. A file without the seal has lost its end.
keep_interrupted_state() {  # keep_interrupted_state OUT INPUT [-var NAME VALUE]...: fails if the run was not interrupted
  local out=$1 input=$2 kept=$1/dump/interrupted.restart file given='' in_pour=''
  shift 2
  [[ -f $out/log.liggghts ]] || return 1
  file=$(sed -nE "s/^interrupted: the state is in '(.*)'$/\1/p" "$out/log.liggghts" | tail -n 1)
  [[ -f $file ]] || return 1
  if [[ $(tail -c 24 -- "$file" | head -c 8 | tr -d '\0') != MuckSeal ]]; then
    say "interrupted, but '$file' has lost its end: there is nothing to go on from in it"
    return
  fi
  # The blast has a scene as soon as its rock is cut; before there is only the pour of muck.
  if [[ -f $out/muck/dump/scene.json && ! -f $out/dump/scene.json ]]; then in_pour=1 kept=$out/muck/dump/interrupted.restart; fi
  mv -f -- "$file" "$kept"
  kept=$(realpath -m --relative-to="$caller_dir" -- "$kept")
  if [[ -n $in_pour ]]; then
    say "interrupted in the pour of the muck; the same command with -var pour_from $kept goes on"
    return
  fi
  if [[ -z $(variables_of "$input" | sed -n '/^go_on /p') ]]; then
    say "interrupted; its state is in $kept"
    return
  fi
  [[ -z $(value_of go_on "$@")$(value_of from "$@") ]] || given=' in place of those given'
  say "interrupted; the same command with -var go_on 1 -var from $kept$given goes on"
}

results_in() {  # results_in FOLDER: paths from there
  (
    cd "$1" && shopt -s nullglob
    for file in {,muck/}dump/{blocks_[0-9]*,impulses_[0-9]*,history,gas*,gauges*,holes,holes_again,burden,joints}.csv {,muck/}dump/blocks_[0-9]*.bin {,muck/}dump/blocks.vtk {,muck/}dump/{floor,behind,ground,gate}.stl {,muck/}dump/{run,scene}.json \
      {,muck/}dump/{a,b,interrupted,stopped}.restart {,muck/}{vtk/blocks*,summary.json,log.liggghts,report.html} \
      {,muck/}{profile,movement,polygons,rows,heights,face_velocity,waves,ppv,survey,damage,cracks,crater,heap,fragments,fines,dig,launch,momentum,energy,plan,section,over,trough,burden,boulders}.{csv,png} {,muck/}{flyrock,sieve,fragments_list,model_moved,polygons_moved,energy_holes,hole_polygons}.csv {,muck/}{movement,polygons}.dxf {,muck/}pile3d{.csv,*.png}; do
      if [[ -f $file ]]; then printf '%s\n' "$file"; fi
    done
  )
}

# Names, sizes and times, to see whether any has changed; what cannot be looked into is not of the run.
listed() { find "$@" -type f -printf '%P %s %T@\n' 2>/dev/null | sort || true; }      # listed FOLDER [TEST]...
written_in() { listed "$1" ! -path "$1/.previous*" ! -path "$1/.lock" ! -path "$1/run.log" ! -name log.liggghts; }  # written_in OUT
steps_in() {  # steps_in OUT: those of a pour of muck, too
  local dump
  for dump in "$1"/{,muck/}dump; do
    if [[ -d $dump ]]; then listed "$dump" -maxdepth 1 \( -name history.csv -o -name 'blocks_[0-9]*.csv' -o -name 'blocks_[0-9]*.bin' \); fi
  done
}

# History and snapshots of the set-up show one step, that from which the run starts. Copies of what is set aside are as old as that.
started() {  # started OUT: a run that does not go on has got beyond its set-up
  local out=$1 file steps
  steps=$(
    for file in "$out"/{,muck/}dump/{history,blocks_[0-9]*}.csv "$out"/{,muck/}dump/blocks_[0-9]*.bin "$out"/{,muck/}dump/{a,b,stopped}.restart; do
      [[ -f $file && $file -nt $out/.previous/${file#"$out"/} ]] || continue
      case ${file##*/} in
        history.csv) sed -nE 's/^0*([0-9]+),.*/\1/p' "$file" ;;
        *.csv | *.bin) sed -nE 's/^blocks_0*([0-9]+)\.(csv|bin)$/\1/p' <<<"${file##*/}" ;;
        *) printf 'restart\nfile\n' ;;  # written at steps only
      esac
    done | sort -u | wc -l
  )
  ((steps > 1))
}

move_results() {  # move_results FROM TO
  local inside files
  for inside in '' dump/ vtk/ muck/ muck/dump/ muck/vtk/; do
    mapfile -t files < <(results_in "$1" | grep "^${inside}[^/]*\$")
    [[ ${#files[@]} -gt 0 || $inside == dump/ ]] || continue
    mkdir -p "$2/$inside" || die "cannot make a folder in '$2'"
    [[ ${#files[@]} -eq 0 ]] || mv -f -t "$2/$inside" -- "${files[@]/#/$1/}" || die "cannot move results from '$1' to '$2'"
  done
  rmdir -- "$1"/muck/{dump,vtk} "$1/muck" 2>/dev/null || true
}

# Results in OUT that a new run reads.
results_read_by() {  # results_read_by OUT INPUT [-var NAME VALUE]...: paths from OUT
  local folder file path
  folder=$(realpath -- "$1")/
  files_named_by "${@:2}" | while read -r file; do
    path=$(realpath -- "$file")
    if [[ $path == "$folder"* ]]; then printf '%s\n' "${path#"$folder"}"; fi
  done
}

# What is in .previous is whole; in .previous.part it is on its way there or back. What the new run reads stays in its place, too.
set_aside() {  # set_aside OUT INPUT [-var NAME VALUE]...
  local out=$1 file kept
  [[ -n $(results_in "$out") ]] || return 0
  mapfile -t kept < <(results_read_by "$@")
  move_results "$out" "$out/.previous.part"
  mv -T -- "$out/.previous.part" "$out/.previous" || die "cannot set aside what '$out' holds"
  for file in "${kept[@]}"; do
    [[ ! -f $out/.previous/$file ]] || cp -p -- "$out/.previous/$file" "$out/$file" || die "cannot copy '$file' in '$out'"
  done
}

put_back() {  # put_back OUT
  local out=$1 file part=$1/.previous.part
  if [[ -d $out/.previous ]]; then
    while read -r file; do rm -f -- "$out/$file"; done < <(results_in "$out")
    mv -T -- "$out/.previous" "$part" || die "cannot put back what is in '$out/.previous'"
  fi
  [[ ! -f $out/.previous.log ]] || mv -f -- "$out/.previous.log" "$out/log.liggghts"
  [[ -d $part ]] || return 0
  move_results "$part" "$out"
  rmdir -- "$part"/{dump,vtk} 2>/dev/null || true
  rmdir -- "$part" 2>/dev/null || say "'$part' holds more than results; look at it"
  rmdir -- "$out/vtk" 2>/dev/null || true
}

drop_previous() { rm -rf -- "${1:?}/.previous" "$1/.previous.log"; }  # drop_previous OUT

# After a run that was killed together with its script.
recover_previous() {  # recover_previous OUT
  [[ ! -f $1/.previous.log || -f $1/log.liggghts ]] || mv -f -- "$1/.previous.log" "$1/log.liggghts"
  rm -f -- "$1/.previous.log"
  [[ -d $1/.previous || -d $1/.previous.part ]] || return 0
  if [[ -d $1/.previous ]] && started "$1"; then
    drop_previous "$1"
  else
    say "putting back the results in '$1', which a run that did not start has left set aside"
    put_back "$1"
  fi
}

# What a full disk leaves of a file.
refuse_empty_files() {  # refuse_empty_files OUT
  local file empty=()
  while read -r file; do
    [[ -s $1/$file ]] || empty+=("$1/$file")
  done < <(results_in "$1" | grep "^dump/")
  ((${#empty[@]} == 0)) || die "the run left ${#empty[@]} files with nothing in them, as '${empty[0]}'; is the disk full?"
}
