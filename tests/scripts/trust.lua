-- Whether an axis stands where it counts: asked, refused for, and said, on every kind of controller and a bus.
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end

local function refused(ok, why)
  same(ok, nil, "a move to a place")
  hw.check(why:find("cannot be trusted: its power was cut", 1, true), why)
  hw.check(why:find("Nothing was sent. Home it, set its position, or go on just this once.", 1, true), why)
end

for _, kind in ipairs{
  {"vxm@emulator", 1}, {"pmx-4ex-sa@emulator", "X", "EO=15"}, {"dmx-k-sa@emulator", "X", "EO=1"},
  {"vme58@emulator", "X"},
} do
  local address, axis, power = table.unpack(kind)
  local c = assert(hw.open(address))
  if power then assert(c:query(power)) end
  local word, why = c:trust(axis)
  same(word, "counted", address)
  hw.check(#why > 10, why)
  assert(c:move_to{[axis] = 500})
  assert(c:wait(30))
  c.bench:power_cycle()
  hw.sleep(20)
  assert(c:move_by{[axis] = 10})
  assert(c:wait(30))
  word, why = c:trust(axis)
  same(word, "untrusted", address)
  hw.check(why:find("its power was cut", 1, true), why)
  same(c:status(axis).position_doubtful, true, address)
  local ok, reason = c:move_to{[axis] = 0}
  refused(ok, reason)
  same(c:position(axis), 10, "nothing was moved")
  assert(c:trust(axis, "set"))
  same(c:trust(axis), "set", address)
  assert(c:move_to{[axis] = 0})
  assert(c:wait(30))
  same(c:position(axis), 0, address)
  hw.check(not pcall(c.trust, c, axis, "homed"), "that is the controller's to say")
  local none, no_axis = c:trust(99)
  same(none, nil, "no such axis")
  hw.check(no_axis:find("no such axis", 1, true), no_axis)
end

-- Homed, where that sets the count.
local c = assert(hw.open("vxm@emulator"))
c.bench:place(1, {minus = -800})
assert(c:home(1, "-"))
assert(c:wait(30))
same(c:trust(1), "counted", "the switch alone sets nothing")
assert(c:home(1, "-", "limit-zero"))
assert(c:wait(30))
same(c:trust(1), "homed", "its zero does")
c:jog(2, "+", 3000)
hw.sleep(2)
c:abort()
local word, why = c:trust(2)
same(word, "untrusted", "stopped without a ramp")
hw.check(why:find("without a ramp", 1, true), why)
same(c:trust(1), "homed", "of the other one nothing is doubted")

-- A bus names the device.
local bus = assert(hw.open("dmx-k-sa@emulator,id=01-02"))
for _, id in ipairs{"01", "02"} do assert(bus.devices[id]:query("EO=1")) end
assert(bus:move_to{["01"] = 300, ["02"] = 300})
assert(bus:wait(30))
bus.devices["02"].bench:power_cycle()
hw.sleep(20)
assert(bus.devices["02"]:query("EO=1"))
same(bus:trust("01"), "counted", "01")
same(bus:trust("02"), "untrusted", "02")
local ok, reason = bus:move_to{["02"] = 0}
refused(ok, reason)
hw.check(reason:find("device 02", 1, true), reason)
assert(bus:trust("02", "set"))
assert(bus:move_to{["02"] = 0})
assert(bus:wait(30))

-- A program that goes to a place is not started by a count that is doubted; one that goes a distance is.
for _, kind in ipairs{
  {"vxm@emulator", 1, "IA1M400\n", "I1M20\n"},
  {"pmx-4ex-sa@emulator", "X", "X400\nWAITX\nEND\n", "INC\nX20\nWAITX\nABS\nEND\n", "EO=15"},
  {"vme58@emulator", "X", "AA;\nMA400; GO ID\n", "AA;\nMR20; GO ID\n"},
} do
  local address, axis, absolute, relative, power = table.unpack(kind)
  local c = assert(hw.open(address))
  if power then assert(c:query(power)) end
  assert(c:move_to{[axis] = 300})
  assert(c:wait(30))
  c.bench:power_cycle()
  hw.sleep(20)
  if power then assert(c:query(power)) end
  assert(c:load(absolute))
  local ok, reason = c:run()
  refused(ok, reason)
  assert(c:load(relative))
  assert(c:run())
  assert(c:wait(30))
  same(c:position(axis), 20, address .. ", by a distance")
  assert(c:trust(axis, "set"))
  assert(c:load(absolute))
  assert(c:run())
  assert(c:wait(30))
  same(c:position(axis), 400, address .. ", to a place")
end
