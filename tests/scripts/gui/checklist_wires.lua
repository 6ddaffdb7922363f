-- The lines of tests/checklist/makers.md about connections, against emulators that other processes serve on ports:
-- command_line.py starts them and gives the path. A PMX that is called 07 at 38400 baud, or a DMX 05 at 9600; each has a
-- run of its own.
require("lib.checklist")
local lines, port_there = hw.args[1], hw.args[2]  -- "PMX" or "DMX"
local pmx, dmx = port_there, port_there
local any_block = block
local function block(id, work)
  if id:find("^" .. lines) then any_block(id, work) end
end
ui.window(1440, 900)

-- Puts the form together and opens it.
local function open(model, port, baud, id)
  if not ui.exists("connect/form/open") then ui.click("controller/new") end
  pick("connect/form/model", model)
  fill("connect/form/port", port)
  choose("connect/form/baud", baud)
  fill("connect/form/id", id)
  is("connect/form/address", ("%s@serial:%s,baud=%s,id=%s"):format(model == 2 and "pmx-4ex-sa" or "dmx-k-sa", port, baud, id))
  ui.click("connect/form/open")
end
local function close()
  ui.click("menu")
  ui.click("menu/close")
  if ui.exists("close/leave") then ui.click("close/leave") end
  ui.frame(3)
end
local function search(where, first, last)
  if not ui.exists("connect/search") then ui.click("controller/new") end
  pick("connect/search/port", where)
  fill("connect/search/first", first)
  fill("connect/search/last", last)
  ui.click("connect/search")
end
-- How many ports a machine has is its own affair; of those that it has none is left out. What is asked and found
-- there: tests/panels/connect_test.cpp, tests/transports/scan_test.cpp.
local function every_port_was_asked()
  shows("connect/search/progress", "%.$")
  local said = ui.value("connect/search/progress")
  local asked, all = said:match("^Done after (%d+) of (%d+) queries")
  local none = said == "There is no serial port to search." or said == "No port could be searched."
  assert(none or (asked == all and tonumber(all) > 0), said)
end

-- ---- PMX-4EX-SA
block("PMX-CONN-B1", function()
  open(2, "/dev/no-such-port", "38400", "07")
  shows("status/text", "no%-such%-port")
  close()
end)
block("PMX-CONN-B2", function()  -- at another rate nothing is understood
  open(2, pmx, "9600", "07")
  sent("@07ID")
  hw.sleep(2)
  shows("link/health", "^Connecting")
  close()
end)
block("PMX-CONN-B3", function()  -- another device is asked, and what to look at is said
  open(2, pmx, "38400", "08")
  sent("@08ID")
  shows("status/text", "08")
  shows("status/text", "12 to 24 V")
  close()
end)
block("PMX-CONN-C1", function()
  pick("connect/form/model", 2)
  fill("connect/form/port", pmx)
  search(1, "98", "98")
  every_port_was_asked()
end)
block("PMX-CONN-C2", function()
  search(2, "06", "08")
  for _ = 1, 40 do
    if ui.exists("connect/search/found/0") then break end
    hw.sleep(0.25)
  end
  shows("connect/search/found/0/text", "with id 07 answers at 38400 baud")
  ui.click("connect/search/found/0")
  shows("link/health", "^Link good")
  close()
end)
block("PMX-CONN-D", function()
  hw.sleep(1)
  open(2, pmx, "38400", "07")
  shows("link/health", "^Link good")
  sent("@07ID")
  shows("dro/X/state", "OFF")
  close()
end)

-- ---- DMX-K-SA
block("DMX-CONN-A", function()
  open(3, "/dev/no-such-port", "9600", "05")
  shows("status/text", "no%-such%-port")
  close()
end)
block("DMX-CONN-B", function()  -- the factory's rate stands there from the start
  pick("connect/form/model", 2)
  pick("connect/form/model", 3)
  is("connect/form/baud", "9600")
  open(3, dmx, "19200", "05")
  sent("@05ID")
  hw.sleep(2)
  shows("link/health", "^Connecting")
  close()
end)
block("DMX-CONN-C", function()
  open(3, dmx, "9600", "06")
  sent("@06ID")
  shows("status/text", "12 to 35 V")
  close()
end)
block("DMX-CONN-D1", function()
  pick("connect/form/model", 3)
  fill("connect/form/port", dmx)
  search(1, "98", "98")
  every_port_was_asked()
end)
block("DMX-CONN-D2", function()
  search(2, "04", "06")
  for _ = 1, 40 do
    if ui.exists("connect/search/found/0") then break end
    hw.sleep(0.25)
  end
  shows("connect/search/found/0/text", "with id 05 answers at 9600 baud")
  if ui.exists("connect/search/cancel") then ui.click("connect/search/cancel") end
  shows("connect/search/progress", "found%.$")
end)
block("DMX-CONN-E", function()
  hw.sleep(1)
  open(3, dmx, "9600", "05")
  shows("link/health", "^Link good")
  sent("@05ID")
end)
block("DMX-CONN-485", function()
  set_param("CM", 2, "CM=1")
  ui.click("setup/store")
  said("Stored in the controller.")  -- before sent(), which may put messages away
  sent("STORE")
  ui.click("controller/new")
  pick("connect/form/model", 3)
  shows("connect/form/guide", "write it, store it.*off and on, and open it again with its id")
end)
over()
