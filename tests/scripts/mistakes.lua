-- Slips of a user who knows another library: each message names the call, what was wrong, and what to write instead.
local c = assert(hw.open("pmx-4ex-sa@emulator"))
local vxm = assert(hw.open("vxm@emulator"))
local bus = assert(hw.open("dmx-k-sa@emulator,id=01-02"))
assert(c:query("EO=15"))

-- Errors at the script's line.
for _, slip in ipairs{
  {'move_to: the targets must be a table like {X=400}, not string', function() c:move_to("X", 400) end},
  {'move_by: the targets must be a table like {[1]=400}, not number', function() vxm:move_by(1, 400) end},
  {'move_to: the targets must be a table like {["01"]=400}, not nil', function() bus:move_to() end},
  {"move_to: the table of targets is empty: an axis whose value is nil", function() c:move_to{X = nil} end},
  {"move_to: a target must be a whole number of steps, not 10.5: round it, or set a unit", function() c:move_to{X = 10.5} end},
  {"move_to: a target must be a whole number of steps, not a string", function() c:move_to{X = "four"} end},
  {"move_to: a target must be a whole number of steps, not a table", function() c:move_to{X = {400}} end},
  {"move_to: axis X has no unit yet: set it first, c:units(axis", function() c:move_to({X = 1}, {unit = true}) end},
  {"with true it counts in the units of c:units(axis)", function() c:move_to({X = 1}, {unit = "mm"}) end},
  {"move_to: argument 2 (options) must be a table like {speed=...}, not number", function() c:move_to({X = 1}, 2000) end},
  {'move_to: there is no option "velocity". It takes speed', function() c:move_to({X = 1}, {velocity = 2000}) end},
  {'Did you mean "speed"?', function() c:move_to({X = 1}, {sped = 2000}) end},
  {"the speed must be a number above 0, in steps/s", function() c:move_to({X = 1}, {speed = "fast"}) end},
  {'jog: argument 2 (direction) must be "+" or "-", not nil', function() c:jog("X") end},
  {'home: argument 2 (direction) must be "+" or "-", not number', function() c:home("X", 1) end},
  {'jog: argument 2 (direction) must be "+" or "-", not up', function() c:jog("X", "up") end},
  {'position: the axis must be its number or its name, as 1 or "X", not nil', function() c:position() end},
  {'jog: the axis must be its number or its name, as 1 or "1", not table', function() vxm:jog({1}, "+") end},
  {'position: on a bus the axis is the id of a device, as "01", not number', function() bus:position(1) end},
  {'name the device, c.devices["01"]', function() bus:get("HSPD") end},
  {"call this with a colon on a controller returned by hw.open()", function() c.position("X") end},
  {"wait: argument 1 (seconds) must be a number, not string", function() c:wait("10") end},
  {"wait: argument 1 (seconds) must be from 0 to a million seconds, not -1", function() c:wait(-1) end},
  {"hw.wait_any: number 1 is neither a function nor a task of hw.spawn, but boolean: write function()", function() hw.wait_any{c:wait(1)} end},
  {'trust: a position can only be "set" by a script', function() c:trust("X", "yes") end},
  {"sleep: argument 1 (seconds) must be a number, not nil", function() hw.sleep(nil) end},
  {"wait_until: argument 1 must be a function, as function() ... end, not boolean", function() c:wait_until(c:input(1)) end},
  {"on: argument 2 must be a function, as function() ... end, not nil", function() c:on("input") end},
  {'on: there is no "moved". There is limit, input, stopped, lost.', function() c:on("moved", print) end},
  {"hw.spawn: argument 1 must be a function, not nil: hw.spawn(f, ...) calls f(...)", function() hw.spawn(print()) end},
  {'limits: there is no "min": the ends are minus and plus', function() c:limits("X", {min = 0}) end},
  {"limits: argument 2 must be a table like {minus=-1000, plus=90000}, not number", function() c:limits("X", 5) end},
  {"place: argument 2 must be a table like {X=1000, Y=0}, not number", function() c:place("load", 5) end},
  {"place: argument 1 (name) must not be empty", function() c:place("") end},
  {'backlash: ends is "+" or "-"', function() c:backlash("X", {by = 5, ends = "up"}) end},
  {"open: argument 1 (address) must be a text, not nil", function() hw.open() end},
  {"set: argument 2 (value) must be a whole number, not nil", function() c:set("HS") end},
  {"hw.write_csv: row 1 must be a list like {1, 2}", function() hw.write_csv("a.csv", {1, 2}) end},
} do
  local words, f = table.unpack(slip)
  local ok, why = pcall(f)
  hw.check(not ok, "taken: " .. words)
  hw.check(tostring(why):find("mistakes.lua:%d+: "), "without its line: " .. tostring(why))
  hw.check(why:find(words, 1, true), "got: " .. why .. "\nwant: " .. words)
end

-- Refusals: nil, a sentence, and a table that a script can go by.
for _, slip in ipairs{
  {'There is no such axis. PMX has: X, Y, Z, U. Did you mean "X"?', "refused", function() return c:move_to{x = 5} end},
  {"There is no such axis. VXM has: 1, 2.", "refused", function() return vxm:move_to{[3] = 5} end},
  {'There is no device "1". On this wire are: 01, 02.', "refused", function() return bus:move_to{["1"] = 5} end},
  {'There is no controller model "pmx".', "text", function() return hw.open("pmx@emulator") end},
  {'"usb0" is not a transport. Did you mean "usb"?', "text", function() return hw.open("pmx-4ex-sa@usb0") end},
  {'Did you mean "pmx-4ex-sa"?', "text", function() return hw.open("pmx@emulator") end},
  {'There is no homing mode "hard". The modes are', "refused", function() return c:home("X", "-", "hard") end},
  {'There is no place "load".', "refused", function() return c:go("load") end},
  {'has no parameter "ACCEL"', "refused", function() return c:set("ACCEL", 5) end},
} do
  local words, kind, f = table.unpack(slip)
  local ok, why, more = f()
  hw.check(ok == nil and type(why) == "string" and type(more) == "table", "taken: " .. words)
  hw.check(why:find(words, 1, true), "got: " .. why .. "\nwant: " .. words)
  hw.check(more.kind == kind, words .. ": " .. tostring(more.kind))
end

-- What did not come in time is neither refused nor unanswered.
assert(c:jog("X", "+", {speed = 500}))
for what, wait in pairs{
  wait = function() return c:wait(0.2) end,
  wait_until = function() return c:wait_until(function() return false end, 0.2) end,
  wait_any = function() return hw.wait_any({function() hw.sleep(5) end}, 0.2) end,
  task = function() return hw.spawn(hw.sleep, 5):wait(0.2) end,
} do
  local ok, why, more = wait()
  hw.check(ok == nil and why:find("Timeout", 1, true), what .. ": " .. tostring(why))
  hw.check(more.kind == "timeout" and more.what_to_do == "Wait longer, or stop it.", what .. ": " .. more.kind)
end
assert(c:stop() and c:wait(10))
