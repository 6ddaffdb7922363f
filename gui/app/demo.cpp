#include "gui/app/demo.h"

#include <filesystem>
#include <fstream>

#include <fmt/core.h>

#include "core/device/registry.h"
#include "core/script/runner.h"
#include "gui/app/cli.h"
#include "gui/app/demo_drawing.h"
#include "gui/app/output.h"
#include "gui/app/script_stage.h"
#include "gui/app/wiring.h"

namespace hw::app {
namespace {

// This script uses only calls of assets/manual/scripts.md.
constexpr std::string_view demonstration = R"lua(
local folder = hw.args[1]
local function picture(name)
  ui.frame(3)
  ui.screenshot(folder .. "/" .. name .. ".png")
  print("  picture: " .. folder .. "/" .. name .. ".png")
end
-- As a hand does it: what was written, and what the controller works on, stand in the editor.
local function write_and_run(text)
  ui.click("tab/program")
  ui.type("program/text", text)
  ui.click("program/run")
  ui.click("tab/program")  -- the mouse rests where it hides nothing
end
local function must(ok, why) hw.check(ok, why) return ok end

ui.window(1440, 900)
picture("connect")

print("A Velmex VXM with two motors.")
local c = must(hw.open("vxm@emulator"))
must(c:set("M1M", 4))
must(c:set("M2M", 4))
c.bench:place(1, {minus = -4000, plus = 12000})
print("  homing motor 1 to its limit switch ...")
must(c:home(1, "-"))
must(c:wait(120))
print(string.format("  at the switch after %.1f s", hw.now()))
must(c:move_by{[1] = 2000})
must(c:wait(60))

print("  a program: five strokes with a pulse on output 1")
must(c:load("S1M4000\nA1M4\nLM0\nU4\nI1M1600\nU5\nP2\nI1M-1600\nL5", 0))
local began = hw.now()
must(c:run(0))
hw.sleep(1.2)
print(string.format("  motor 1 at %d steps, %.0f steps/s", c:position(1), c:velocity(1)))
picture("program")
must(c:wait(120))
print(string.format("  done in %.1f s, motor 1 at %d steps", hw.now() - began, c:position(1)))

print("  jogging motor 2, hand on the button")
ui.press("jog/2/+")
hw.sleep(1)
picture("jog")
ui.release("jog/2/+")
c:wait(20)
print("  let go: stopped at " .. c:position(2) .. " steps")

print("A VXM Master with its Slave, four motors.")
local d = must(hw.open("vxm@emulator,motors=4"))
for m = 1, 4 do must(d:set("M" .. m .. "M", 4)) end
must(d:move_to{[1] = 800, [2] = 400, [3] = 1200, [4] = -600})
must(d:wait(60))
print(string.format("  motors at %d, %d, %d, %d steps", d:position(1), d:position(2), d:position(3), d:position(4)))
picture("four-motors")
d.bench:unplug(true)
hw.sleep(1)
print("  cable pulled: " .. select(2, d:position(1)))
picture("lost")
d.bench:unplug(false)
hw.sleep(6)
print("  cable back: motor 1 at " .. tostring(d:position(1)) .. " steps")

print("An Arcus PMX-4EX-SA draws a house with its stored program.")
local p = must(hw.open("pmx-4ex-sa@emulator"))
began = hw.now()
write_and_run(hw.args[2])
hw.sleep(2)
print(string.format("  at X %d, Y %d", p:position("X"), p:position("Y")))
picture("pmx-draws")
must(p:wait(120))
print(string.format("  drawn in %.1f s, the pen is at %d, %d", hw.now() - began, p:position("X"), p:position("Y")))

print("The same one cuts a drawing, with output 1 for its laser.")
ui.click("tab/path")
ui.click("path/forget")
ui.click("tab/drawing")
ui.click("drawing/open")
ui.type("file/path", hw.args[3] .. "\n")
hw.sleep(0.5)
ui.click("drawing/tool")
ui.click("drawing/tool/DO1")
ui.type("drawing/cut_speed", "20\n")
ui.type("drawing/travel_speed", "60\n")
hw.sleep(0.5)
print(string.format("  %s to cut, %s", ui.value("drawing/drawn"), ui.value("drawing/time")))
began = hw.now()
ui.click("drawing/cut")
ui.click("drawing/ask_cut/yes")
hw.sleep(25)
print(string.format("  %s, X %d, Y %d", ui.value("drawing/cut_progress"), p:position("X"), p:position("Y")))
picture("pmx-cuts")
must(p:wait(300))
print(string.format("  cut in %.1f s, the laser is %s", hw.now() - began, p:output(1) and "on" or "off"))

print("Four Arcus DMX-K-SA with closed loops on one line.")
local m = must(hw.open("dmx-k-sa@emulator,id=01-04"))
for _, id in ipairs{"01", "02", "03", "04"} do must(m.devices[id]:send("EO=1")) end
must(m:move_to{["01"] = 8000, ["02"] = 6000, ["03"] = 4000, ["04"] = 2000})
hw.sleep(1)
picture("dmx-bus")
must(m:wait(60))
for _, id in ipairs{"01", "02", "03", "04"} do
  print(string.format("  %s: target %d, encoder %d counts", id, m:position(id), m:encoder(id)))
end

print("An Oregon Micro Systems VME58, a board with eight servo axes, cuts a hole.")
local v = must(hw.open("vme58@emulator"))
must(v:move_to{X = 4000, Y = -2000, S = 1000})
must(v:wait(60))
print(string.format("  X %d, Y %d, S %d", v:position("X"), v:position("Y"), v:position("S")))
began = hw.now()
write_and_run([[
AA
CV20000
CD,,0,0;
AN0;
CR0,5000,3.1415926
CR0,0,6.2831853
AF0;
MT-10,10000
CE
MT,,-1000,0; GO
CX
]])
hw.sleep(2)
picture("vme58-hole")
must(v:wait(120))
print(string.format("  cut in %.1f s, Z %d, T %d", hw.now() - began, v:position("Z"), v:position("T")))

ui.theme("light")
picture("light")
print(string.format("%.0f s of emulated time.", hw.now()))
)lua";

}  // namespace

std::string folder_of_program() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::string(".") : self.parent_path().string();
}

int headless_demo(const std::string& pictures) {
  std::error_code error;
  std::filesystem::create_directories(pictures, error);
  if (error) return complain(fmt::format("The folder {} cannot be created: {}.", pictures, error.message()));
  IoContext io{1};
  HybridScheduler scheduler(io, false);
  script::RunOptions options;
  options.path = "demo.lua";
  const DeviceType* pmx = find_device_type("pmx-4ex-sa");
  const auto catalog = pmx->make_catalog({});
  const std::string drawing = pictures + "/plate.dxf";
  if (!(std::ofstream(drawing) << demo_drawing))
    return complain(fmt::format("The drawing {} cannot be written.", drawing));
  options.args = {pictures, catalog->program.example, drawing};
  options.opener = wire_opener();
  options.print = print_of_script;
  options.log = [](std::string_view line) { print_result("{}\n", line); };
  ScriptStage stage(scheduler, options.opener);
  options.stage = &stage;
  script::Runner runner(scheduler, std::move(options));
  const auto ended = runner.run(demonstration);
  return ended ? done : complain(ended.error());
}

}  // namespace hw::app
