-- A text typed at one device of a bus that is addressed to another, or to all: each shows what it changed, and takes
-- none of it for a device that was switched off and on.
ui.window(1440, 900)
local c = assert(hw.open("dmx-k-sa@emulator,id=01-02"))
hw.sleep(1)
local one, two = c.devices["01"], c.devices["02"]
local function no_message()
  for _, w in ipairs(ui.list()) do assert(not w.id:match("^toast/"), w.id .. ": " .. tostring(w.value)) end
end
two:query("PX=777")
hw.sleep(1)
assert(ui.value("dro/02/position") == "777")
ui.type("terminal/command", "@02PX=0\n")
hw.sleep(1)
assert(ui.value("dro/02/position") == "0", ui.value("dro/02/position"))
no_message()
one:query("PX=55")
two:query("PX=66")
hw.sleep(1)
assert(two:get("HSPD") ~= 2222)
ui.type("terminal/command", "@02HSPD=2222\n")
hw.sleep(3)
assert(two:get("HSPD") == 2222 and one:get("HSPD") ~= 2222)
ui.type("terminal/command", "@00PX=0\n")
hw.sleep(2)
assert(ui.value("dro/01/position") == "0" and ui.value("dro/02/position") == "0")
no_message()
