#!/usr/bin/env bash
# Measures what a change costs: a clean release build as run.sh makes it, without a compiler cache (under 4 minutes
# on two cores), and the build after touching one panel (under 10 s). Exit status 1 when a budget is missed.
#   tests/build_times.sh [FOLDER]     FOLDER is removed and filled anew; default: build-times
# On a machine with other work look at the processor seconds: divided by two they are the least that two cores need.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-build-times}
clean_budget=240 touch_budget=10 missed=0

# measure BUDGET WORDS...: builds in $folder and says how long it took.
measure() {
  local budget=$1 what=$2 cpu
  local before=$EPOCHREALTIME
  cpu=$({ TIMEFORMAT='%U %S'; time cmake --build "$folder" -j 2 -- --quiet >&2; } 2>&1 | tail -1)
  local after=$EPOCHREALTIME verdict
  verdict=$(awk -v a="$before" -v b="$after" -v cpu="$cpu" -v budget="$budget" -v what="$what" 'BEGIN {
    split(cpu, c, " "); s = b - a
    printf "%-28s %6.1f s (processor %.0f s), budget %d s: %s\n", what, s, c[1] + c[2], budget, s < budget ? "kept" : "missed" }')
  echo "$verdict"
  [[ $verdict == *kept ]] || missed=1
}

rm -rf "$folder"
cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DHW_TESTS=OFF -DHW_CCACHE= >/dev/null
measure $clean_budget "clean release build"
touch panels/jog/jog.cpp
measure $touch_budget "after touching panels/jog/jog.cpp"
rm -rf "$folder"
exit $missed
