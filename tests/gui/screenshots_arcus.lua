-- Pictures of what controllers show that run several programs at once, have closed loops, buffers, variables,
-- and of controllers that share a wire: build/handwheel run --gui tests/gui/screenshots_arcus.lua FOLDER
-- [PART-OF-A-NAME [dark|light]]. What was seen in them: PICTURES.md.
require("lib.pictures")

-- ---- a table of four axes with a program at work
local c = assert(hw.open("pmx-4ex-sa@emulator"))
local axes = {"X", "Y", "Z", "U"}
for _, axis in ipairs(axes) do
  c.bench:place(axis, {minus = -500000, plus = 500000, home = {-20, 20}})
  ui.click("dro/" .. axis .. "/power")
  hw.sleep(0.3)
end
hw.sleep(1)
aside()
pictures("arcus-idle")
ui.type("program/text", table.concat({"; a square, again and again", "ABS", "HSPD=4000", "LSPD=200", "ACC=200", "WHILE 1=1",
  "  X8000Y0", "  WAITX", "  X8000Y8000", "  WAITX", "  X0Y8000", "  WAITX", "  X0Y0", "  WAITX", "  V50=V50+1",
  "ENDWHILE", "END", "PRG 1", "WHILE 1=1", "  V1=DI", "  DELAY=200", "ENDWHILE", "END", ""}, "\n"))
ui.frame(3)
pictures("arcus-program-text")
ui.click("program/download")
hw.sleep(5)
if ui.exists("program/ask/overwrite") then ui.click("program/ask/overwrite") hw.sleep(5) end
ui.click("thread/0/run")
ui.click("thread/1/run")
hw.sleep(2)
aside()
pictures("arcus-program", nil, nil, in_all)
pictures("arcus-compiled", function() ui.click("program/view") aside() end, function() ui.click("program/view") end)
pictures("arcus-program-more", function() tab("program") ui.click("program/more") end, escape)
for _, name in ipairs{"control", "variables"} do
  pictures("arcus-" .. name, function() tab(name) hw.sleep(1) end, nil, with_200)
end
pictures("arcus-control-lower", function() tab("control") ui.click("action/arc/centre_x") end, escape)
pictures("arcus-right", open_right, close_right)
c:halt()
c:stop()
c:wait(10)
tab("program")
ui.click("program/new")
ui.frame(2)
if ui.exists("program/replace/yes") then ui.click("program/replace/yes") end
ui.type("program/text", "ABS\nX8000Y\nWHILE 1=1\n  V200=3\n  FOO 7\nEND\n")
hw.sleep(0.5)
aside()
pictures("arcus-errors")
ui.click("program/new")
ui.frame(2)
if ui.exists("program/replace/yes") then ui.click("program/replace/yes") end
ui.type("program/text", string.rep("X8000Y0\nWAITX\n", 500))
hw.sleep(0.5)
aside()
pictures("arcus-too-long")

-- ---- buffered moves
tab("list")
for n, row in ipairs{{0, 0}, {8000, 0}, {8000, 8000}, {0, 8000}, {0, 0}} do
  ui.click("list/add")
  ui.type("list/" .. n .. "/x", tostring(row[1]))
  ui.type("list/" .. n .. "/y", tostring(row[2]))
  ui.type("list/" .. n .. "/speed", "3000")
end
ui.click("list/start")
hw.sleep(1)
pictures("arcus-moves", function() tab("list") end)
c:stop()
c:wait(10)
hw.sleep(7)
pictures("arcus-setup", function() tab("setup") end, nil, with_200)
tab("setup")
ui.type("setup/filter", "joystick")
pictures("arcus-setup-search")
ui.type("setup/filter", "")
pictures("arcus-setup-bits", function() tab("setup") ui.click("setup/POX") end, escape)

-- ---- hands and trouble
tab("program")
pictures("arcus-axis-menu", function() ui.click("dro/X/position") end, escape)
pictures("arcus-jog-held", function() tab("jog") ui.press("jog/X/+") hw.sleep(0.8) end,
         function() ui.release("jog/X/+") c:wait(20) tab("program") end)
c:home("Y", "+", "home")
hw.sleep(0.5)
pictures("arcus-homing", nil, nil, {wide})
c:stop()
c:wait(10)
c.bench:limit("Z", "+", true)
c:move_by{Z = 20000}
hw.sleep(1)
pictures("arcus-limit")
c.bench:limit("Z", "+", false)
c.bench:alarm("U", true)
hw.sleep(1)
pictures("arcus-alarm", nil, nil, {wide, medium})
c.bench:alarm("U", false)
tab("control")
ui.click("action/clear/U/go")
hw.sleep(1)
c:set("SLX", 1)
hw.sleep(1)
c.bench:jam("X", true)
c:move_by{X = 20000}
hw.sleep(4)
pictures("arcus-stalled", nil, nil, {wide, medium})
c.bench:jam("X", false)
ui.click("action/clear/X/go")
hw.sleep(1)
c.bench:unplug(true)
hw.sleep(4)
pictures("arcus-lost", function() tab("program") end)
c.bench:unplug(false)
hw.sleep(6)

-- ---- a bus of four; one meets a limit, one loses its power
local bus = assert(hw.open("dmx-k-sa@emulator,id=01-04"))
hw.sleep(3)
aside()
pictures("arcus-bus-idle")
bus.devices["02"]:move_by{[1] = 20000}
hw.sleep(1)
pictures("arcus-bus", function() tab("control") end, nil, in_all)
pictures("arcus-bus-menu", function() ui.click("dro/01/menu") end, escape)
bus.devices["02"]:wait(60)
bus.devices["04"].bench:limit(1, "+", true)
bus.devices["04"]:move_by{[1] = 20000}
hw.sleep(2)
pictures("arcus-bus-limit", function() tab("program") end)
bus.devices["03"].bench:power(false)
hw.sleep(6)
pictures("arcus-bus-lost", function() tab("program") end, nil, with_200)
pictures("arcus-bus-right", open_right, close_right)
pictures("arcus-bus-all", function() tab("terminal") ui.click("terminal/to") end, escape)
bus.devices["03"].bench:power(true)
hw.sleep(6)

-- ---- thirty of them
local thirty = assert(hw.open("dmx-k-sa@emulator,id=01-30"))
hw.sleep(3)
aside()
pictures("arcus-bus-thirty")

-- ---- how they are found
ui.click(ui.exists("controller/new") and "controller/new" or "controller/menu")
ui.frame(3)
pictures("arcus-connect")
choose("connect/form/model", "PMX")
pictures("arcus-connect-form", function() ui.click("connect/form/id") end, nil)
