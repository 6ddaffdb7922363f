-- Readouts go on under every tool: position, speed and a readout of the controller change while each tab, list, menu and
-- dialog is open. The makers' programs freeze theirs, or move only when a window is closed.
require("lib.checklist")
ui.window(1440, 900)
local c = assert(hw.open("pmx-4ex-sa@emulator"))
c.bench:place("U", {minus = -100000000, plus = 100000000})
c:send("EO4=1")
tab("setup")
is("setup/state", "All values are those of the controller.")

local function goes_on(what)
  if not c:status("U").moving then c:jog("U", "+") end  -- Escape, which closes, also stops
  for _ = 1, 2 do
    local ok, why = pcall(changes, "dro/U/position")
    hw.check(ok, what .. ": " .. tostring(why))
  end
  hw.check(ui.value("dro/U/state") == "MOVING +", what .. ": the state is shown")
end
local function away()
  if ui.exists("file/cancel") then return ui.click("file/cancel") end
  ui.key("Escape")
  ui.frame(3)
end

-- ---- tabs
for _, name in ipairs{"program", "control", "list", "variables", "setup"} do
  tab(name)
  goes_on("tab " .. name)
end

-- ---- what is asked only while it is looked at goes on under a list that lies over it
tab("control")
c:send("TR=1000000")
for _, list in ipairs{"control/SYNXC", "home/mode", "dro/unit", "menu", "terminal/to", "dro/X/position"} do
  tab("control")
  ui.click(list)
  ui.frame(2)
  goes_on(list)
  local ok, why = pcall(changes, "readout/TR")
  hw.check(ok, list .. ": " .. tostring(why))
  away()
  look_at("readout/TR")
end

-- ---- lists and dialogs of the other tabs
local function under(name, opens, sign)
  tab(name)
  opens()
  ui.frame(2)
  hw.check(ui.exists(sign), sign .. " is open")
  goes_on(sign)
  away()
end
under("setup", function() ui.click("setup/EDEC") end, "setup/EDEC/" .. "1: brake with the deceleration time")
under("setup", function() ui.click("setup/save") end, "file/path")
under("setup", function() ui.click("setup/open") end, "file/path")
under("program", function() ui.click("program/open") end, "file/path")
under("program", function() ui.click("program/more") end, "program/more/Find")
under("program", function() ui.click("program/empty") end, "program/clear/yes")
under("program", function() fill("program/text", "V1=1\nEND\n") ui.click("program/new") end, "program/replace/yes")
under("program", function() ui.click("program/view") end, "program/listing")
under("list", function() ui.click("list/add") ui.click("list/open") end, "list/replace/yes")
under("list", function() ui.click("list/save") end, "file/path")
under("control", function() ui.click("terminal/save") end, "file/path")
under("control", function() ui.type("terminal/command", "S") ui.key("Tab") end, "terminal/offer/STOP")
under("control", function() ui.click("menu") ui.click("menu/names") end, "names/controller")

-- ---- another page: what is shown afterwards is of now
ui.click("controller/new")
c:jog("U", "+")
local before = c:position("U")
hw.sleep(2)
ui.click("controller/1")
ui.frame(2)
hw.check(tonumber((ui.value("dro/U/position"):gsub(" ", ""))) > before, "of now")
goes_on("after the connection page")
c:stop()
c:wait(20)
