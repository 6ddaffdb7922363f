-- A drawing that two motors on one bus draw together: opened, cut, held, stopped and gone on with.
local c = assert(hw.open("dmx-k-sa@emulator,id=01-02"))
for _, d in pairs(c.devices) do
  d:send("EO=1")
  d:send("SL=0")
end
ui.window(1440, 900)
hw.sleep(1)
ui.click("tab/drawing")
hw.check(ui.exists("drawing/open"))
