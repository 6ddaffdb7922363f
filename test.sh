#!/usr/bin/env bash
# Installs what is missing, builds, runs every test (the window tests start their own Xvfb).
#   ./test.sh [PRESET [CMAKE_OPTION...]]    release (default), debug, asan, tsan; asan-core: what parses and talks, by clang
set -euo pipefail
cd "$(dirname "$0")"
. ./setup.sh

preset=${1:-release}
[ "$preset" != asan-core ] || test_packages+=("${clang_packages[@]}")
install_missing "${build_packages[@]}" "${test_packages[@]}"
build "$preset" -DHW_TESTS=ON "${@:2}"
say "testing ($preset)"
folder=build-$preset
[ "$preset" != release ] || folder=build
rm -rf "$folder/times"
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1:strict_string_checks=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
if [ "$preset" = asan-core ]; then  # nothing here runs in real time
  ctest --preset "$preset" -j 2
  exit
fi
[ "$preset" != tsan ] || export LP_NUM_THREADS=0  # the threads of Mesa's rasteriser are not built for it
# What runs in real time has the machine: what talks to served emulators (it waits nine tenths of the time), then programs
# that are not ours and a real window, which take turns (RUN_SERIAL) and have up to three tries, since an answer or a
# hand may come late. All other tests run behind them, in time that is idle.
real_time='outside|wall_clock'
[ "$preset" = release ] || [ "$preset" = debug ] || real_time=outside  # sanitizers make hands late
set -m  # a group of its own, which ends with this script
(
  chrt --idle --pid 0 "$BASHPID" || say "cannot run at idle priority: the tests disturb each other"
  # Two tries: a test may be starved of time here.
  ctest --preset "$preset" -j 2 -LE 'waits|wall_clock|outside' --repeat until-pass:2 >"$folder/other_tests.log" 2>&1
) &
others=$!
set +m
trap 'kill -- -$others 2>/dev/null || true' EXIT
failed=0
ctest --preset "$preset" -j 3 -L waits | tee "$folder/waiting_tests.log" || failed=1
ctest --preset "$preset" -j 4 -L "$real_time" --repeat until-pass:3 | tee "$folder/real_time_tests.log" || failed=1
[ $failed = 0 ] || say "a test that runs in real time has failed: see above"
say "all other tests"
wait $others || failed=1
cat "$folder/other_tests.log"
tests/slowest.py "$folder/times" "$folder"/*_tests.log || failed=1
exit $failed
