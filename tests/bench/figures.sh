#!/usr/bin/env bash
# Builds the benchmarks and prints every figure of the manual with its budget, as ratios of one run. Takes some minutes,
# and a quiet machine: with other work on it wall-clock figures mean little.
#   tests/bench/figures.sh [NAME...]     only figures whose name contains one of the words
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset release -DHW_TESTS=ON >/dev/null
cmake --build --preset release --target hw_bench bare_window handwheel -- --quiet
exec python3 tests/bench/figures.py "$@"
