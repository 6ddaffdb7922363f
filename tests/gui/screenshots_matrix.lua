-- Every panel of each controller at work, in four sizes and both themes:
--   build/handwheel run --gui tests/gui/screenshots_matrix.lua FOLDER [PART-OF-A-NAME [dark|light]]
-- What was seen in them: PICTURES.md.
require("lib.pictures")
local sizes = {medium, laptop, wide, narrow}

local function all_panels(name)
  local panels, seen = {}, {}
  for _, w in ipairs(ui.list()) do
    local panel = w.id:match("^tab/([%w_]+)$")
    if panel and not seen[panel] then
      seen[panel] = true
      panels[#panels + 1] = panel
    end
  end
  for _, panel in ipairs(panels) do
    pictures(name .. "-" .. panel, function() tab(panel) hw.sleep(0.5) ui.frame(2) end, nil, sizes)
  end
  pictures(name .. "-jog", function() tab("jog") end, nil, {narrow})
  pictures(name .. "-right", open_right, close_right, {medium, laptop, narrow})
end

local vxm = hw.check(hw.open("vxm@emulator,motors=4,wire=real"))
hw.sleep(1)
for motor = 1, 4 do
  vxm:set("M" .. motor .. "M", 4)
  vxm.bench:place(motor, {minus = -40000, plus = 60000})
end
ui.click("dro/unit")
for motor = 1, 4 do choose("dro/unit/axis/" .. motor, "UniSlide K1") end
escape()
ui.type("program/text", "; plate scan\nS1M2000, A1M2\nS2M1000\nLM0\nI1M4800 ; across\nPA5\nI2M400 ; next row\nL-20")
ui.click("program/simulate")
hw.sleep(1)
ui.click("program/run")
hw.sleep(6)
all_panels("vxm")

local pmx = hw.check(hw.open("pmx-4ex-sa@emulator"))
hw.sleep(1)
for _, axis in ipairs{"X", "Y", "Z", "U"} do
  pmx.bench:place(axis, {minus = -500000, plus = 500000, home = {-20, 20}})
  ui.click("dro/" .. axis .. "/power")
  hw.sleep(0.3)
end
pmx:send("LTX=1") -- a latch that waits
pmx:set("SLX", 1)
ui.type("program/text", "; a square\nABS\nHSPD=4000\nLSPD=200\nACC=200\nWHILE 1=1\n  X8000Y0\n  WAITX\n  X0Y8000\n  WAITX\nENDWHILE\nEND\n")
ui.click("program/simulate")
hw.sleep(1)
pmx.bench:alarm("U", true)
hw.sleep(0.5)
pmx:move_by{Z = 20000000}
hw.sleep(1)
pmx.bench:alarm("U", false)
hw.sleep(1)
all_panels("pmx")
pmx:stop()
pmx:wait(20)

local dmx = hw.check(hw.open("dmx-k-sa@emulator"))
hw.sleep(1)
dmx.bench:place(1, {minus = -500000, plus = 500000, home = {-20, 20}})
dmx:set("EO", 1)
ui.type("program/text", "; to and fro\nABS\nWHILE 1=1\n  X8000\n  WAITX\n  X0\n  WAITX\nENDWHILE\nEND\n")
dmx:move_by{[1] = 20000000}
hw.sleep(1)
all_panels("dmx")
dmx:stop()
dmx:wait(20)

local bus = hw.check(hw.open("dmx-k-sa@emulator,id=01-04"))
hw.sleep(3)
bus.devices["02"]:move_by{[1] = 20000000}
bus.devices["04"].bench:limit(1, "+", true)
bus.devices["04"]:move_by{[1] = 20000}
hw.sleep(1)
all_panels("bus")

local vme = hw.check(hw.open("vme58@emulator"))
hw.sleep(1)
ui.type("program/text", "AA MT125000,-18240,,,,-33000000; GO\nAZ MA-12000 GO WT5 MR400 GO MR-400 GO\nAX WT2 MR4000 GO MR-4000 GO\n")
vme:send("AX MA125000 GO")
vme:send("AZ JG2000")
vme.bench:limit("U", "-", true)
hw.sleep(1)
all_panels("vme58")
