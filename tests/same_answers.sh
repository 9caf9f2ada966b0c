#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Do two builds find the same factors of safety, and in which time? Asks both for each scene in turn; factors are to
# agree in six digits and outcomes in all. Processor time: other work on the machine changes it little.
#   tests/same_answers.sh FOLDER_OF_PROGRAMS_BEFORE FOLDER_OF_PROGRAMS_AFTER SCENE...
set -u
[ $# -ge 3 ] || { echo "usage: $0 PROGRAMS_BEFORE PROGRAMS_AFTER SCENE..." >&2; exit 2; }
before=$1
after=$2
shift 2
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
different=0

ask() { # programs, scene, answer: processor seconds
  TIMEFORMAT='%U'
  { time "$1/blockweir-limit" safety "$2" --answer "$3" 2> "$3.txt"; } 2>&1
}

printf '%-32s %12s %12s %9s %9s %7s\n' scene before after 's before' 's after' ratio
for scene in "$@"; do
  rm -f "$out"/*
  before_s=$(ask "$before" "$scene" "$out/before")
  after_s=$(ask "$after" "$scene" "$out/after")
  python3 - "$out" "$scene" "$before_s" "$after_s" << 'END' || different=$((different + 1))
import json
import os
import sys

out, scene, before_s, after_s = sys.argv[1:]


def answer(name):
    if not os.path.exists(f"{out}/{name}"):
        return None, open(f"{out}/{name}.txt").read().strip().split("\n")[-1]
    found = json.load(open(f"{out}/{name}"))
    return found["factor"], found["outcome"]


(before, said_before), (after, said_after) = answer("before"), answer("after")
text = [f"{f:.7g}" if f is not None else said for f, said in ((before, said_before), (after, said_after))]
ratio = float(before_s) / max(float(after_s), 1e-3)
name = scene.rstrip("/").removesuffix("/scene.toml").split("/")[-1]
both = before is not None and after is not None
same = said_before == said_after and (abs(after / before - 1) < 1e-6 if both else before == after)
print(f"{name:32.32} {text[0]:>12.12} {text[1]:>12.12} {before_s:>9} {after_s:>9} {ratio:7.1f}{'' if same else '  DIFFERENT'}", flush=True)
sys.exit(0 if same else 1)
END
done
echo "$# scenes, $different different"
[ "$different" -eq 0 ]
