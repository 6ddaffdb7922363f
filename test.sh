#!/usr/bin/env bash
# Installs what is missing, builds, runs every test (the window tests start their own Xvfb).
#   ./test.sh [PRESET [CMAKE_OPTION...]]    release (default), debug, asan, tsan
set -euo pipefail
cd "$(dirname "$0")"
. ./setup.sh

preset=${1:-release}
install_missing "${build_packages[@]}" "${test_packages[@]}"
build "$preset" -DHW_TESTS=ON "${@:2}"
say "testing ($preset)"
folder=build-$preset
[ "$preset" != release ] || folder=build
rm -rf "$folder/times"
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1:strict_string_checks=1}
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
[ "$preset" != tsan ] || export LP_NUM_THREADS=0  # the threads of Mesa's rasteriser are not built for it
# What runs in real time, programs that are not ours and a real window, comes first, each with up to three tries: on a
# busy machine an answer or a hand may come late. Windows take turns (RUN_SERIAL).
real_time='outside|wall_clock'
[ "$preset" = release ] || [ "$preset" = debug ] || real_time=outside  # sanitizers make hands late
failed=0
ctest --preset "$preset" -j 2 -L "$real_time" --repeat until-pass:3 || failed=1
[ $failed = 0 ] || say "a test with a real window or a program that is not ours has failed: see above"
say "all other tests"
{
  others=0  # what talks to served emulators waits nine tenths of the time
  ctest --preset "$preset" -j 6 -L waits || others=1
  ctest --preset "$preset" -j 2 -LE 'waits|wall_clock|outside' || others=1
  exit $others
} | tests/slowest.py "$folder/times" || failed=1
exit $failed
