-- With StepNLoop on, targets and speeds are counts: both manuals, StepNLoop Closed Loop Control, notes.
local function refused(action, field, unit)
  ui.type(("action/%s/%s"):format(action, field), "999999999")
  ui.click(("action/%s/go"):format(action))
  ui.frame(2)
  local said = ui.value(("action/%s/refused"):format(action))
  assert(said:find(" " .. unit .. " only.", 1, true), ("%s: %q"):format(action, said))
end
local function range(param, unit)
  ui.type("setup/filter", param)
  ui.frame(2)
  ui.press("setup/" .. param) ui.release("setup/" .. param)
  ui.frame(2)
  local said = ui.value("setup/facts/range")
  assert(said:match(unit .. "$"), ("%s: %q"):format(param, said))
end
ui.window(1440, 900)

local dmx = assert(hw.open("dmx-k-sa@emulator"))
hw.sleep(1)
for _, now in ipairs{{1, "counts"}, {0, "pulses"}} do
  dmx:set("SL", now[1])
  hw.sleep(1)
  ui.click("tab/control")
  dmx:jog(1, "+")  -- they are changes under way
  ui.frame(2)
  refused("change_target", "target", now[2])
  refused("change_speed", "speed", now[2] .. "/s")
  dmx:stop()
  dmx:wait(20)
  ui.click("tab/setup")
  range("HSPD", now[2] .. "/s")
  range("LSPD", now[2] .. "/s")
end
ui.type("setup/filter", "DN")
ui.frame(2)
ui.press("setup/DN") ui.release("setup/DN")
ui.frame(2)
assert(ui.value("setup/facts/range"):match("^DMK01 to DMK99$"), ui.value("setup/facts/range"))

local pmx = assert(hw.open("pmx-4ex-sa@emulator"))
hw.sleep(1)
pmx:set("SLY", 1)
hw.sleep(1)
ui.click("tab/control")
refused("arc", "centre_x", "pulses")
ui.type("action/arc/centre_x", "0")
refused("arc", "centre_y", "counts")
for _, shown in ipairs(ui.list()) do  -- one control for all axes
  local text = shown.id:find("^jog/s") and shown.label .. " " .. tostring(shown.value) or ""
  assert(not text:find("pulse") and not text:find("count"), text)
end
ui.click("tab/setup")
range("HS", "%d/s")  -- of some axes pulses, of others counts
range("HSX", "pulses/s")
range("HSY", "counts/s")
