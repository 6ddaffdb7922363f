# Sourced by run.sh and test.sh: installs what is missing and builds. Debian 12.
# Needs no network when everything is there.

build_packages=(g++ cmake ninja-build pkg-config python3 mold
  libglfw3-dev libimgui-dev libgl-dev libopengl-dev libegl-dev libboost-dev libspdlog-dev libfmt-dev libcli11-dev
  libtomlplusplus-dev libdxflib-dev nlohmann-json3-dev liblua5.4-dev libusb-1.0-0-dev libsystemd-dev libstb-dev libexpected-dev fonts-inter
  fonts-jetbrains-mono
  libgl1-mesa-dri)
test_packages=(dbus libgtest-dev libgmock-dev libbenchmark-dev xvfb xdotool x11-utils openbox i3lock ser2net
  python3-gi gir1.2-gtk-3.0 universal-ctags libumockdev-dev umockdev dpkg-dev man-db desktop-file-utils appstream)
clang_packages=(clang libclang-rt-dev)

say() { printf '\n== %s\n' "$*"; }

install_missing() {
  local missing=()
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  say "installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "These packages are missing and there is no sudo: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# build PRESET [cmake option...]
build() {
  local preset=$1
  shift
  say "building ($preset)"
  cmake --preset "$preset" "$@" >/dev/null
  # One compiler per core: a third one on two cores takes from the others' caches more than it gives.
  cmake --build --preset "$preset" -j "$(nproc)" -- --quiet
}
