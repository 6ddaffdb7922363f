-- The pictures of the README: build/handwheel run --gui tests/gui/readme_pictures.lua assets/screenshots
require("lib.pictures")
local function picture(name)
  ui.frame(3)
  ui.screenshot(folder .. "/" .. name .. ".png")
end
ui.window(1440, 900)
ui.theme("dark")
local c = assert(hw.open("vxm@emulator,wire=real"))
for m = 1, 2 do c:set("M" .. m .. "M", 4) end
c.bench:place(1, {minus = -800, plus = 60000})
c.bench:place(2, {minus = -800, plus = 20000})
ui.click("dro/unit")
for m = 1, 2 do choose("dro/unit/axis/" .. m, "UniSlide K1") end
ui.key("Escape")
ui.click("menu")
ui.click("menu/names")
ui.type("names/controller", "VXM stage")
ui.type("names/1", "across")
ui.type("names/2", "rows")
ui.click("names/ok")
c:home(1, "-", "limit-zero")
c:wait(60)

-- a program at work, while its text is being changed
ui.type("program/text", [[
; plate scan: 20 rows, camera flash on output 1
S1M2000, A1M2       ; across at 5 mm/s
S2M1000             ; rows at 2.5 mm/s
IA1M0               ; start at the left edge
LM0                 ; each row from here
I1M4800             ; across, 12 mm
PA5                 ; flash 0.5 s
I2M400              ; next row, 1 mm
L-20                ; 20 rows, back and forth]])
hw.sleep(0.3)
ui.click("program/run")
hw.sleep(29)
ui.type("program/text", "\nS2M8000")
ui.type("terminal/command", "S1M")
hw.sleep(0.2)
picture("console-dark")
ui.type("terminal/command", "")
c:halt()
c:wait(20)

-- the set-up, in the light
ui.theme("light")
ui.click("tab/setup")
hw.sleep(1)
choose("setup/M2M", "5: Slo-Syn M091")
choose("setup/L1M", "1: on, normally closed")
picture("setup-light")

-- the cable pulled while an axis moves
ui.theme("dark")
ui.click("tab/program")
c:move_to{[1] = 40000}
hw.sleep(1.5)
c.bench:unplug(true)
hw.sleep(3)
picture("fault-dark")

-- a drawing that is being cut
c.bench:unplug(false)
hw.sleep(8)
ui.theme("dark")
local p = assert(hw.open("pmx-4ex-sa@emulator,wire=real"))
p:send("EO=15")
ui.click("tab/drawing")
ui.click("drawing/open")
ui.type("file/path", "assets/examples/plate.dxf\n")
hw.sleep(1)
choose("drawing/tool", "DO1")
ui.type("drawing/cut_speed", "20\n")
ui.type("drawing/travel_speed", "60\n")
hw.sleep(1)
ui.click("drawing/to_program")
ui.click("tab/path")
ui.click("path/simulate")
hw.sleep(1)
ui.click("tab/drawing")
ui.click("drawing/cut")
ui.click("drawing/ask_cut/yes")
hw.sleep(36)
picture("drawing-dark")

-- and the path of it
ui.theme("light")
ui.click("tab/path")
picture("path-light")
