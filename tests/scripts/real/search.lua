-- The connection page's search on a line that another program serves (hw.args[1], see command_line.py): two DMX
-- with ids 07 and 11 at 38400 baud are listed, and one of them is opened from the list.
local line = hw.args[1]
local function pick(id, name)
  ui.click(id)
  ui.frame(2)
  ui.click(id .. "/" .. name)
  ui.frame(2)
end

ui.frame(5)
ui.type("connect/form/port", line)
pick("connect/search/port", line)
pick("connect/search/baud", "38400")
ui.type("connect/search/first", "06")
ui.type("connect/search/last", "12")
ui.click("connect/search")
ui.frame(5)
hw.check(ui.exists("connect/search/cancel"), "it can be ended")

local progress
for _ = 1, 200 do
  hw.sleep(0.1)
  progress = ui.value("connect/search/progress") or ""
  if progress:find("^Done") then break end
end
hw.check(progress == "Done after 7 of 7 queries, 2 found.", progress)
hw.check(ui.exists("connect/search/found/0") and ui.exists("connect/search/found/1"), "both are listed")
hw.check(not ui.exists("connect/search/found/2"), "and nothing else")

ui.click("connect/search/found/1")
for _ = 1, 200 do
  hw.sleep(0.1)
  if ui.exists("dro/X/position") and ui.value("dro/X/position") ~= "-" then break end
end
hw.check(ui.value("dro/X/position") == "0", "the second of them is open: " .. tostring(ui.value("dro/X/position")))
local wire = ui.value("terminal/log") or ""
hw.check(wire:find("@11", 1, true), "it is device 11: " .. wire)
