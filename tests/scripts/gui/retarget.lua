-- A target that is changed on the fly belongs to a move that may have been begun elsewhere: by text, by a program.
require("lib.checklist")
ui.window(1440, 900)
for _, model in ipairs{"pmx-4ex-sa", "dmx-k-sa"} do
  local c = assert(hw.open(model .. "@emulator"))
  hw.sleep(2)
  if model == "dmx-k-sa" then c:query("SL=0") end
  c:query("X50000")
  hw.sleep(0.5)
  tab("control")
  local change = model == "dmx-k-sa" and "action/change_target" or "action/change_target/X"
  fill(change .. "/target", "2000")
  ui.click(change .. "/go")
  hw.sleep(0.3)
  hw.check(ui.value("dro/X/state"):find("MOVING", 1, true), model .. " shows " .. ui.value("dro/X/state"))
  hw.check(c:wait(60))
  hw.check(c:position("X") == 2000, model .. " stands at " .. c:position("X"))
  c:query("X4000")
  hw.sleep(1)
  hw.check(ui.value("dro/X/state"):find("MOVING", 1, true), model .. ", the move after it: " .. ui.value("dro/X/state"))
end
