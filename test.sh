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
# What runs in real time, programs that are not ours and a real window, has the machine first, each test with up to three
# tries: on a busy machine an answer or a hand may come late. Windows take turns (RUN_SERIAL). All other tests run beside
# it at the lowest priority, on what it leaves: it waits most of the time.
real_time='outside|wall_clock'
[ "$preset" = release ] || [ "$preset" = debug ] || real_time=outside  # sanitizers make hands late
# Two runs of ctest in one folder would overwrite each other's records: these have a folder that names the first.
mkdir -p "$folder/beside"
echo "subdirs(\"$PWD/$folder\")" >"$folder/beside/CTestTestfile.cmake"
beside() { nice -n 19 ctest --test-dir "$folder/beside" --output-on-failure "$@"; }
others() {
  local failed=0
  beside -j 6 -L waits || failed=1  # what talks to served emulators waits nine tenths of the time
  beside -j 2 -LE 'waits|wall_clock|outside' || failed=1
  return $failed
}
others >"$folder/beside/output" 2>&1 &
beside=$! failed=0
ctest --preset "$preset" -j 2 -L "$real_time" --repeat until-pass:3 || failed=1
[ $failed = 0 ] || say "a test with a real window or a program that is not ours has failed: see above"
say "all other tests"
tail --pid $beside -n +1 -f "$folder/beside/output" | tests/slowest.py "$folder/times"
wait $beside || failed=1
exit $failed
