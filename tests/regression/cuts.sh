# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash disable=SC2154
# What scripts share that cut rock on several numbers of ranks and compare the blocks.
# Scope: to be sourced behind runs.sh.

# cut_input BOX <<<COMMANDS: $out/in.cut with a box of six numbers and what every cut needs, and the commands behind it, which write
# ${out}/${name}.vtk.
cut_input() {
  cat - >"$out/commands" && cat - "$out/commands" >"$out/in.cut" <<END
units si
atom_style granular
atom_modify map array
newton off
boundary f f f
communicate single vel yes
hard_particles yes
region box block $1 units box
create_box 1 box
neighbor 0.01 bin
timestep 1e-6
pair_style muckpile/block
pair_coeff * *
fix bodies all multisphere
END
}

same_on_ranks() {  # same_on_ranks WHAT "RANKS..." [-var NAME VALUE]...: $out/WHAT<ranks>.vtk and .screen of each, with the same blocks
  local what=$1 ranks first='' name
  local -a all
  read -ra all <<<"$2"
  shift 2
  for ranks in "${all[@]}"; do
    name=$what$ranks
    on_ranks "$ranks" -in "$out/in.cut" -log none -var out "$out" -var name "$name" "$@" >"$out/$name.screen" 2>&1 ||
      fail "$what failed on $ranks ranks: $(grep -m 1 ERROR "$out/$name.screen")"
    tail -n +3 "$out/$name.vtk" >"$out/$name.blocks"
    cmp "$out/${first:=$name}.blocks" "$out/$name.blocks" || fail "$what: the blocks of ${first#"$what"} and $ranks ranks differ"
  done
}
