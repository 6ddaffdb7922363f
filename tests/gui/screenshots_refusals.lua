-- Pictures of what the console does not do, or asks about first: build/handwheel run --gui
-- tests/gui/screenshots_refusals.lua FOLDER [PART-OF-A-NAME [dark|light]]. What was seen in them: PICTURES.md.
require("lib.pictures")

local function pad() tab("jog") ui.frame(2) end  -- in a narrow window the pad is a tab

-- ---- motors without current, then positions that cannot be trusted
local c = assert(hw.open("pmx-4ex-sa@emulator"))
hw.sleep(2)
pictures("refusal-power-off", pad, aside)
c:send("EO=15")
hw.sleep(1)
c:move_to{X = 20000, Y = -100000}
c:wait(60)
c.bench:power_cycle()
hw.sleep(20)
c:send("EO=15")
hw.sleep(1)
pictures("refusal-doubt", function()
  pad()
  ui.type("goto/X", "240\n")
  hw.sleep(0.5)
end, function()
  ui.click("goto/X/refused/close")
  aside()
end)

-- ---- a rehearsal that does not begin where the axes stand, and a question before it is closed
local v = assert(hw.open("vxm@emulator"))
for m = 1, 2 do v:set("M" .. m .. "M", 4) end
ui.type("program/text", "I1M90000")
ui.click("program/simulate")
hw.sleep(2)
v:move_to{[1] = 20000}
v:wait(60)
aside()
pictures("refusal-rehearsal")
v:run(0)
v:move_by{[1] = -15000}
hw.sleep(1)
pictures("refusal-close", function() ui.key("Ctrl+W") ui.frame(3) end, function() ui.click("close/cancel") end)
v:stop()
v:wait(20)
