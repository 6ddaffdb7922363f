-- What became of a command is kept for the last few only. A panel that was not looked at meanwhile does not
-- wait for ever for one that newer ones have pushed out.
local function shown(id)
  for _, widget in ipairs(ui.list()) do if widget.id == id then return widget end end
end
local function push_out()
  for i = 1, 14 do ui.click("io/out/" .. (1 + i % 2)) hw.sleep(0.05) end
end

local pmx = hw.check(hw.open("pmx-4ex-sa@emulator,wire=real"))
hw.sleep(1)
ui.click("tab/setup")
hw.sleep(1)
ui.click("setup/store")
hw.check(not shown("setup/store").enabled, "it is being stored")
ui.click("tab/program")
push_out()
hw.sleep(20)
ui.click("tab/setup")
hw.sleep(1)
hw.check(shown("setup/store").enabled, "it can be stored again")

local vxm = hw.check(hw.open("vxm@emulator"))
hw.sleep(1)
hw.check(vxm:set("M1M", 4))
hw.check(vxm:load("PA10\nI1M10000\nP50\nL0", 0))
hw.check(vxm:run(0))
hw.sleep(1)
ui.click("io/out/1")
hw.sleep(1)
hw.check(shown("io/out/1").value == "refused", "a program runs: " .. shown("io/out/1").value)
hw.check(vxm:halt())
hw.sleep(3)
for i = 1, 12 do ui.click("io/out/2") hw.sleep(0.2) end
hw.check(shown("io/out/1").value == "off", "it shows what it is: " .. shown("io/out/1").value)
