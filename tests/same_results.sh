#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Do two builds give the same results, bit for bit? Runs every case that needs no OpenFOAM, and its variants, with both
# and compares history.csv.
#   tests/same_results.sh FOLDER_OF_PROGRAMS_BEFORE FOLDER_OF_PROGRAMS_AFTER [CASE...]
set -u
[ $# -ge 2 ] || { echo "usage: $0 PROGRAMS_BEFORE PROGRAMS_AFTER [CASE...]" >&2; exit 2; }
before=$1
after=$2
shift 2
cases=("$@")
[ ${#cases[@]} -gt 0 ] || cases=("$(dirname "$0")"/../cases/*/)
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
compared=0
different=0

run() { # programs, case, variant, folder
  "$1/blockweir" run "$2" ${3:+--variant "$3"} --quiet --out "$4" > "$4.txt" 2>&1
}

for case in "${cases[@]}"; do
  scene=$case/scene.toml
  [ -f "$scene" ] && ! grep -q 'model = "openfoam"' "$scene" || continue
  mapfile -t variants < <(sed -n '/^\[\[variant\]\]/,/^\[/s/^name = "\(.*\)"/\1/p' "$scene")
  for variant in "" "${variants[@]}"; do
    run "$before" "$case" "$variant" "$out/before" &
    run "$after" "$case" "$variant" "$out/after"
    wait
    compared=$((compared + 1))
    if ! cmp -s "$out/before/history.csv" "$out/after/history.csv"; then
      echo "different: $case ${variant:+variant \"$variant\"}"
      different=$((different + 1))
    fi
    rm -rf "$out"/*
  done
done
echo "$compared runs compared, $different different"
[ "$compared" -gt 0 ] && [ "$different" -eq 0 ]
