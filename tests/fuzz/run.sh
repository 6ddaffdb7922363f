#!/usr/bin/env bash
# Builds the fuzz targets (clang, libFuzzer, ASan + UBSan) and lets each run for a while, two at a time, at the lowest
# priority. Prints what each did; exit status 1 when one found something (its input is then in build-fuzz/found).
#   tests/fuzz/run.sh [SECONDS [TARGET...]]      600 seconds each unless said, all targets unless named
set -euo pipefail
cd "$(dirname "$0")/../.."
duration=${1:-600}
shift || true
cmake --preset fuzz >/dev/null
nice -n 19 cmake --build --preset fuzz -- --quiet
cd build-fuzz
targets=("$@")
[ ${#targets[@]} -gt 0 ] || for t in tests/fuzz/*_fuzz; do targets+=("$(basename "$t")"); done
mkdir -p found

# A unit may take some seconds: the emulators run endless programs for ten minutes of theirs.
fuzz() {
  mkdir -p "corpus/$1"
  nice -n 19 "tests/fuzz/$1" -max_total_time="$duration" -timeout=60 -report_slow_units=60 -rss_limit_mb=4096 -print_final_stats=1 \
    -artifact_prefix="found/$1-" "corpus/$1" >"$1.log" 2>&1 || true
}
export -f fuzz
export duration
rm -f found/*
printf '%s\n' "${targets[@]}" | xargs -P 2 -I{} bash -c 'fuzz {}'

printf '%-22s %12s %10s %8s   %s\n' target executions coverage corpus finding
for t in "${targets[@]}"; do
  awk -v t="$t" '
    /stat::number_of_executed_units/ { n = $2 }
    / cov: / { for (i = 1; i < NF; i++) { if ($i == "cov:") cov = $(i + 1); if ($i == "corp:") corp = $(i + 1) } }
    /^SUMMARY/ { found = $0 }
    END { sub("/.*", "", corp); printf "%-22s %12d %10d %8d   %s\n", t, n, cov, corp, found == "" ? "none" : found }' "$t.log"
done
[ -z "$(ls found)" ]
