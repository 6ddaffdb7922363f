-- Pictures of every panel and state of a controller that is programmed line by line, to be looked at:
--   build/handwheel run --gui tests/gui/screenshots.lua FOLDER [PART-OF-A-NAME [dark|light]]
-- at 1440x900, at 1024x700 (medium), at 200 % in a window of 1440x900 pixels (narrow), and a few at 200 % in
-- one of 2880x1800 (wide). What was seen in them: PICTURES.md.
require("lib.pictures")

-- ---- without a controller
pictures("connect", nil, nil, with_200)
ui.type("connect/address", "vxm@serial\n")
pictures("connect-refused")
ui.click("help")
pictures("help", nil, nil, with_200)
ui.click("help/close")

-- ---- a controller as the factory sends it
local c = assert(hw.open("vxm@emulator,wire=real"))
hw.sleep(1)
pictures("motor-type-0")
for m = 1, 2 do c:set("M" .. m .. "M", 4) end
c.bench:place(1, {minus = -4000, plus = 60000})
c.bench:place(2, {minus = -4000, plus = 20000})
hw.sleep(1)
aside()
pictures("program-empty")

-- ---- as its user likes to see it
pictures("units", function() tab("jog") ui.click("dro/unit") end, escape)
ui.click("dro/unit")
for m = 1, 2 do choose("dro/unit/axis/" .. m, "UniSlide K1, Q1 or BiSlide M01: 1 mm a turn") end
escape()
ui.click("menu")
ui.click("menu/names")
ui.type("names/controller", "VXM stage")
ui.type("names/1", "across")
ui.type("names/2", "rows")
pictures("names")
ui.click("names/ok")
pictures("menu", function() ui.click("menu") end, escape)
pictures("axis-menu", function() ui.click("dro/1/position") end, escape)

-- ---- the program
local plate_scan = [[
; plate scan: 20 rows, camera flash on output 1
S1M2000, A1M2       ; across at 5 mm/s
S2M1000             ; rows at 2.5 mm/s
IA1M0               ; start at the left edge
LM0                 ; each row from here
I1M4800             ; across, 12 mm
PA5                 ; flash 0.5 s
I2M400              ; next row, 1 mm
L-20                ; 20 rows, back and forth]]
tab("program")
ui.type("program/text", plate_scan)
hw.sleep(0.5)
aside()
pictures("program-text")
ui.click("program/simulate")
hw.sleep(1)
aside()
pictures("program-rehearsed", nil, nil, with_200)
pictures("rehearsal-open", function() tab("program") ui.click("rehearsal/expand") end,
         function() ui.click("rehearsal/expand") end, {medium, narrow})
pictures("program-more", function() tab("program") ui.click("program/more") end, escape)
pictures("program-find", function() tab("program") ui.click("program/text") ui.key("Ctrl+F") ui.type("program/text/find", "M4") end, escape)
pictures("file-open", function() tab("program") ui.click("program/open") end, escape)
pictures("file-save", function() tab("program") ui.click("program/save") end, escape)
ui.click("program/run")
hw.sleep(9)
aside()
pictures("program-running", nil, nil, in_all)
ui.type("program/text", "\nS2M8000")
hw.sleep(0.3)
pictures("program-running-edited", nil, nil, with_200)
ui.click("program/hold")
hw.sleep(4)
aside()
pictures("program-held")
c:halt()
c:wait(20)
ui.click("program/slot/1")
ui.type("program/text", "S1M2000\nI1Q400\nI2M9999999999\nU3,U200\nL0\n")
hw.sleep(0.5)
aside()
pictures("program-errors")
pictures("refusal", function() tab("program") ui.key("Ctrl+Enter") end, read_messages)
ui.click("program/slot/2")
ui.type("program/text", string.rep("I1M400,I2M400,P5,U4,I1M-400,I2M-400,P5,U5\n", 12))
hw.sleep(0.5)
aside()
pictures("program-too-long")
c:load("I1M100,P5,I1M-100", 3)
ui.click("program/slot/3")
ui.type("program/text", "I1M200")
ui.click("program/run")
hw.sleep(1)
aside()
pictures("program-replace")
ui.click("program/ask/leave")
ui.click("program/slot/0")

-- ---- the set-up
tab("setup")
ui.frame(5)
hw.sleep(1)
pictures("setup", nil, nil, with_200)
ui.type("setup/Bx", "20\n")
ui.type("setup/filter", "speed")
hw.sleep(0.2)
pictures("setup-search")
ui.type("setup/filter", "")
ui.click("setup/show/Changed")
pictures("setup-changed")
ui.click("setup/show/All")
ui.click("setup/M2M")
ui.frame(2)
pictures("setup-choice", nil, nil, {wide})
ui.click("setup/M2M/" .. (function()
  for _, w in ipairs(ui.list()) do if w.id:match("^setup/M2M/5") then return w.id:sub(11) end end
  error("no choice 5")
end)())
ui.click("setup/write")
pictures("setup-confirm")
ui.click("setup/confirm/no")

-- ---- the terminal
tab("program")
ui.type("terminal/command", "getM1M\n")
hw.sleep(0.3)
pictures("terminal-completion", function() tab("terminal") ui.type("terminal/command", "S") ui.key("Tab") end,
        function() escape() ui.type("terminal/command", "") end)
pictures("terminal-hint", function() tab("terminal") ui.type("terminal/command", "I1M4000,R") end,
        function() ui.type("terminal/command", "") escape() end)
pictures("terminal-traffic", function() tab("terminal") end)
ui.type("terminal/filter", "motor 1")
pictures("terminal-filter", function() tab("terminal") end)
ui.type("terminal/filter", "")
tab("program")

-- ---- hands
pictures("goto-refused", function() tab("jog") ui.type("goto/1", "99999999\n") end, function() ui.type("goto/1", "") end)
tab("program")
c:move_to{[1] = 4000, [2] = 2000}
c:wait(60)
pictures("jog-held", function() tab("jog") ui.press("jog/1/+") hw.sleep(0.8) end,
        function() ui.release("jog/1/+") c:wait(20) end, with_200)
c.bench:limit(1, "-", true)
c:home(2, "-")
c:wait(120)
hw.sleep(7)
pictures("limit")
c.bench:limit(1, "-", false)
pictures("right", open_right, close_right)
pictures("bench-lower", function() look_at("bench/analog/1") end, close_right)

-- ---- the bench
c.bench:breaker(true)
hw.sleep(3)
pictures("breaker-out", open_right, close_right)
c.bench:breaker(false)
hw.sleep(6)
c.bench:input(1, true)
c.bench:button("Stop", true)
hw.sleep(1)
pictures("stop-pressed", open_right, close_right)
c.bench:button("Stop", false)
c.bench:input(1, false)

-- ---- trouble
c.bench:garble(4)
hw.sleep(1)
pictures("garbled", nil, nil, {wide})
c:home(2, "+")
hw.sleep(0.5)
c.bench:drop(40)
hw.sleep(0.9)
pictures("stale", nil, nil, {wide})
c.bench:unplug(true)
hw.sleep(4)
pictures("lost", nil, nil, in_all)
c.bench:unplug(false)
hw.sleep(6)
pictures("back")
c.bench:power_cycle()
hw.sleep(3)
pictures("power-cycled", nil, nil, {wide, medium})

-- ---- several controllers
local d = assert(hw.open("vxm@emulator,motors=4,wire=real"))
hw.sleep(1)
for m = 1, 4 do d:set("M" .. m .. "M", 4) end
d:move_to{[1] = 12400, [2] = -2200, [3] = 180, [4] = 99000}
hw.sleep(0.5)
pictures("four-axes", nil, nil, with_200)
pictures("bench-two", open_right, close_right)
ui.click("menu")
ui.click("menu/close")
pictures("close-moving")
ui.click("close/cancel")
d.bench:power(false, "Slave")
hw.sleep(2)
pictures("slave-off", open_right, close_right)
d.bench:power(true, "Slave")
pictures("controllers", function() if ui.exists("controller/menu") then ui.click("controller/menu") end end, escape, {narrow})
ui.click("menu")
ui.click("menu/reset")
pictures("reset")
ui.click("reset/cancel")
