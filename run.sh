#!/usr/bin/env bash
# Installs what is missing, builds, and opens the console with emulated controllers. Without a display: the
# headless demo, which leaves its pictures in build/demo.
set -euo pipefail
cd "$(dirname "$0")"
. ./setup.sh

install_missing "${build_packages[@]}"
build release -DHW_TESTS=OFF
exec build/handwheel demo "$@"
