#!/usr/bin/env bash
# Installs what is missing, builds, runs every test (the window tests start their own Xvfb).
#   ./test.sh [PRESET]    release (default), debug, asan, tsan
set -euo pipefail
cd "$(dirname "$0")"
. ./setup.sh

preset=${1:-release}
install_missing "${build_packages[@]}" "${test_packages[@]}"
build "$preset" -DHW_TESTS=ON
say "testing ($preset)"
folder=build-$preset
[ "$preset" != release ] || folder=build
rm -rf "$folder/times"
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1:strict_string_checks=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
[ "$preset" != tsan ] || export LP_NUM_THREADS=0  # the threads of Mesa's rasteriser are not built for it
failed=0
# Programs that are not ours, and a real window, under real time: on a busy machine an answer or a hand may come late,
# so each of these may try again.
ctest --preset "$preset" -L outside --repeat until-pass:3 || failed=1
if [ "$preset" = release ] || [ "$preset" = debug ]; then
  ctest --preset "$preset" -L wall_clock --repeat until-pass:3 || failed=1
fi
[ $failed = 0 ] || say "a test with a real window or a program that is not ours has failed: see above"
ctest --preset "$preset" -j 2 -LE 'wall_clock|outside' | tests/slowest.py "$folder/times" || failed=1
exit $failed
