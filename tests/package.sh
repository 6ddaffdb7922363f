#!/usr/bin/env bash
# The package on a bare Debian 12: made, installed with what it depends on and nothing else, used without and with a
# window, and removed again without a trace. By hand, as root: it needs the network, and takes a few minutes.
#   tests/package.sh [PACKAGE.deb]    without one it is built first
set -euo pipefail
cd "$(dirname "$0")/.."
. ./setup.sh
mirror=${MIRROR:-http://deb.debian.org/debian}

[ "$(id -u)" -eq 0 ] || { echo "Run this as root: it makes a system in a folder and enters it." >&2; exit 2; }
install_missing debootstrap dpkg-dev xvfb x11-utils

work=$(mktemp -d)
root=$work/root
x_server=
leave() {
  [ -z "$x_server" ] || kill "$x_server" 2>/dev/null || true
  umount -l "$root/tmp/.X11-unix" "$root/dev/pts" "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$work"
}
trap leave EXIT

if [ $# -gt 0 ]; then
  cp "$1" "$work/"
else
  install_missing "${build_packages[@]}"
  build release
  say "packing"
  cpack --config build/CPackConfig.cmake -B "$work" >/dev/null
fi
package=$(echo "$work"/*.deb)

say "making a bare Debian 12"
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$work/debootstrap.log" || { tail "$work/debootstrap.log"; exit 1; }
mount -t proc proc "$root/proc"
mkdir -p "$root/dev/pts" && mount -t devpts devpts "$root/dev/pts"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
# As a person: with a home, and no rights.
inside useradd --create-home tester
as_tester() { chroot --userspec=tester "$root" env -i PATH=/usr/bin:/bin HOME=/home/tester LC_ALL=C.UTF-8 "$@"; }
# All that dpkg and the package could leave behind, but for their own diaries.
everything() {
  (cd "$root" && find . -xdev \( -path ./proc -o -path ./dev -o -path ./tmp -o -path ./var/lib/apt -o -path ./var/lib/dpkg \
    -o -path ./var/cache -o -path ./var/log -o -path ./home \) -prune -o -print | sort)
}
inside apt-get update -qq
everything >"$work/before"

say "installing"
cp "$package" "$root/tmp/"
inside apt-get install -y -qq --no-install-recommends "/tmp/$(basename "$package")" >"$work/install.log" || { tail "$work/install.log"; exit 1; }
inside dpkg-query -W -f '${Package} ${Version} ${Status}\n' handwheel

say "without a display"
as_tester handwheel --version
as_tester handwheel --help | grep -q '/usr/share/handwheel'
as_tester sh -c 'cd && handwheel simulate /usr/share/handwheel/examples/plate.prg --for pmx-4ex-sa >/dev/null'
as_tester sh -c 'cd && handwheel demo --headless >/dev/null && ls handwheel-demo/*.png | wc -l'
# Some write a table beside themselves, and only root writes where they are installed.
as_tester sh -c 'handwheel run /usr/share/handwheel/examples/grid_scan.lua 2>&1 || true' | grep -q 'Copy the script into a folder of your own'
as_tester sh -c 'cd && cp -r /usr/share/handwheel/examples . && for script in examples/*.lua; do handwheel run "$script" >/dev/null || exit 1; done'
as_tester bash --norc -c 'source /usr/share/bash-completion/completions/handwheel
  COMP_LINE="handwheel sim" COMP_POINT=13; _handwheel; [ "${COMPREPLY[*]}" = simulate ]'
as_tester sh -c 'cat >~/help.lua && handwheel run --gui ~/help.lua' <<'LUA'
ui.frame(2)
ui.key("F1")
ui.frame(2)
ui.click("help/show/Manual")
ui.frame(2)
local pages = 0
for _, w in ipairs(ui.list()) do
  if w.id:find("^help/page/") then
    ui.click(w.id)
    ui.frame(2)
    hw.check(ui.value("help/title") == w.label)
    ui.click("help/pages")
    ui.frame(2)
    pages = pages + 1
  end
end
hw.check(pages > 10)
print("the help shows " .. pages .. " pages of the manual")
LUA

say "with a window"
display=:$((90 + RANDOM % 900))
Xvfb "$display" -ac -screen 0 1440x900x24 >/dev/null 2>&1 &
x_server=$!
for _ in $(seq 50); do xwininfo -display "$display" -root >/dev/null 2>&1 && break; sleep 0.2; done
mkdir -p "$root/tmp/.X11-unix" && mount --bind /tmp/.X11-unix "$root/tmp/.X11-unix"
as_tester DISPLAY="$display" timeout 15 handwheel open vxm@emulator >"$work/window.log" 2>&1 &
window=$!
until xwininfo -display "$display" -root -tree | grep -q '"Handwheel'; do
  kill -0 "$window" 2>/dev/null || { echo "No window came up:" >&2; cat "$work/window.log" >&2; exit 1; }
  sleep 0.2
done
echo "a window is shown"
wait "$window" || true  # ended by timeout
test -f "$root/home/tester/.local/state/handwheel/handwheel.log"

say "removing"
inside apt-get purge -y -qq --auto-remove handwheel >/dev/null
everything >"$work/after"
diff "$work/before" "$work/after"
say "The package installs, works, and leaves nothing behind."
