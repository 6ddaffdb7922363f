-- A drawing that two motors on one bus draw together: opened, cut, held, stopped, and gone on with.
local c = assert(hw.open("dmx-k-sa@emulator,id=01-02"))
local x, y = c.devices["01"], c.devices["02"]
for _, d in pairs(c.devices) do
  d:send("EO=1")
  d:send("SL=0") -- positions in pulses
end
ui.window(1440, 900)
hw.sleep(1)
ui.click("tab/drawing")
ui.click("drawing/open")
ui.type("file/path", "../../../assets/examples/plate.dxf\n")
hw.sleep(1)
hw.check(ui.value("drawing/along_x") == "01" and ui.value("drawing/along_y") == "02", "each is an axis")
ui.click("drawing/tool") ui.click("drawing/tool/DO1")
ui.type("drawing/cut_speed", "20\n")
ui.type("drawing/travel_speed", "60\n")
hw.sleep(1)
for _, w in ipairs(ui.list()) do
  if w.id == "drawing/to_program" or w.id == "drawing/to_blocks" then
    hw.check(not w.enabled, w.id .. ": there is no one text for both")
  end
end

local takes = ui.value("drawing/time")
hw.check(takes and not takes:find("at least", 1, true), "emulators have drawn it beforehand: " .. tostring(takes))

local function cut_until_on()
  while not x:output(1) do hw.sleep(0.05) end
  hw.sleep(0.5)
end
ui.click("drawing/cut")
ui.click("drawing/ask_cut/yes")
cut_until_on()
hw.check(x:status().in_pieces and y:status().in_pieces, "both are at it")
ui.screenshot((hw.args[1] or ".") .. "/bus_drawing.png")

ui.click("drawing/hold")
hw.sleep(15)
hw.check(not x:output(1), "a hold switches the tool off")
local there_x, there_y = c:position("01"), c:position("02")
hw.sleep(3)
hw.check(c:position("01") == there_x and c:position("02") == there_y, "and nothing moves")
ui.click("drawing/hold")
hw.sleep(0.5)
hw.check(x:output(1), "it goes on with the tool on")

ui.click("drawing/stop")
hw.sleep(2)
hw.check(not x:output(1) and not x:status().in_pieces and not y:status().in_pieces, "a stop ends both")
ui.click("drawing/cut_on")
ui.click("drawing/ask_cut/yes")
cut_until_on()
hw.check(c:wait(3600))
hw.check(not x:status().in_pieces and not y:status().in_pieces, "all of it is done")
hw.sleep(0.2)
hw.check(ui.value("drawing/cut_progress"):find("Everything is drawn", 1, true), ui.value("drawing/cut_progress"))
hw.check(not x:output(1))
