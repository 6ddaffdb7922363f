-- What is chosen and asked for a bus is chosen and asked for all of it: step, name, and before it is closed.
local c = assert(hw.open("dmx-k-sa@emulator,id=01-04"))
hw.sleep(1)
for i = 1, 4 do c.devices["0" .. i]:send("EO=1") end
hw.sleep(1)

-- the step that is lit is the one that a tap in any row moves
ui.click("bus/02")
ui.click("jog/step/1000")
ui.click("bus/01")
ui.frame(2)
hw.check(ui.value("jog/step/1000") == "on", "the choice is that of the bus")
for _, id in ipairs{"01", "02", "04"} do
  local before = c:position(id)
  ui.click("jog/" .. id .. "/+")
  hw.sleep(4)
  hw.check(c:position(id) - before == 1000, id .. " moved " .. c:position(id) - before)
end

-- its name
local function name(words)
  ui.click("menu")
  ui.click("menu/names")
  ui.frame(2)
  ui.type("names/controller", words)
  ui.click("names/ok")
  ui.frame(2)
  for _, w in ipairs(ui.list()) do if w.id == "controller/1" then return w.label end end
end
hw.check(name("Lift bus") == "Lift bus", "the bus has its name")
ui.click("menu")
ui.click("menu/names")
ui.frame(2)
hw.check(ui.value("names/controller") == "Lift bus", ui.value("names/controller"))
ui.click("names/cancel")
hw.check(name("") ~= "Lift bus", "and loses it")

-- closing asks for whoever moves, in front or not
ui.click("bus/01")
c.devices["03"]:move_by{[1] = 100000}
hw.sleep(1)
ui.click("menu")
ui.click("menu/close")
ui.frame(3)
hw.check(ui.exists("close/stop") and ui.exists("bus/01"), "03 moves, and that is asked")
ui.click("close/cancel")
hw.sleep(0.5)
hw.check(c:status("03").moving, "cancelled: it goes on")
ui.click("stop_all")
hw.sleep(2)
ui.click("menu")
ui.click("menu/close")
ui.frame(3)
hw.check(not ui.exists("bus/01"), "all stand: closed without a question")
