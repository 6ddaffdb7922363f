-- Every kind of thing that a hand does, through the registry, and what is refused.
local folder = hw.args[1] or "."
hw.check(#ui.list() > 0, "something is on the screen")
hw.check(ui.exists("stop_all"), "stop is always there")
local c = assert(hw.open("vxm@emulator"))
for m = 1, 2 do c:set("M" .. m .. "M", 4) end
ui.frame()

-- the contract's ids
for _, id in ipairs{"stop_all", "jog/1/+", "jog/1/-", "dro/1/position", "terminal/command", "terminal/log", "io/out/1",
                    "io/in/1", "tab/program"} do
  hw.check(ui.exists(id), id .. " is missing")
end
for _, w in ipairs(ui.list()) do
  hw.check(w.id ~= "" and w.kind ~= "" and w.rectangle.width and w.enabled ~= nil, w.id)
end

-- the terminal
ui.type("terminal/command", "getD1\n")
hw.sleep(0.5)
hw.check(ui.value("terminal/log"):find("12-29-04", 1, true), ui.value("terminal/log"))

-- outputs and inputs
ui.click("io/out/1")
hw.sleep(0.5)
hw.check(c:output(1) == true, "output 1 by its button")

-- a program, typed, checked, run
ui.click("tab/program")
for _, id in ipairs{"program/text", "program/run"} do hw.check(ui.exists(id), id .. " is missing") end
ui.type("program/text", "I1M400\nP3\nI1M-300\n")
ui.click("program/run")
hw.sleep(0.5)
hw.check(c:wait(20))
hw.check(c:position(1) == 100, "the program moved to " .. tostring(c:position(1)))

-- a parameter
ui.click("tab/setup")
hw.check(ui.exists("setup/j1M") or ui.exists("setup/j1M/value") or #ui.list() > 20, "setup shows parameters")

-- what a hand could not do is an error with a reason
local ok, why = pcall(ui.click, "nowhere/at/all")
hw.check(not ok and why:find("no widget 'nowhere/at/all'", 1, true), why)
ok, why = pcall(ui.type, "stop_all", "x")
hw.check(not ok and why:find("nothing can be typed", 1, true), why)
ok, why = pcall(ui.theme, "pink")
hw.check(not ok and why:find("pink", 1, true), why)
ok, why = pcall(ui.screenshot, folder .. "/picture.exe")
hw.check(not ok and why:find(".png", 1, true), why)
hw.check(ui.value("nowhere") == nil, "no value of nothing")

ui.window(1440, 900, 0.5)  -- the smallest scale
ui.frame(3)
hw.check(ui.exists("stop_all"), "drawn at half its size")

ui.theme("light")
ui.window(1024, 700)
ui.screenshot(folder .. "/hands.png")

-- the newest controller is in front
local d = assert(hw.open("vxm@emulator,motors=4"))
ui.frame(3)
hw.check(ui.exists("jog/4/+"), "four axes in front")
