-- A speed that is given with one motion holds for that motion, on every kind of controller.
local function near(got, want, what)
  hw.check(got and math.abs(got - want) <= 0.03 * want, string.format("%s: got %s, want %s", what, got, want))
end

local function wrong(words, f, ...)
  local ok, why = pcall(f, ...)
  hw.check(not ok, "taken: " .. words)
  hw.check(why:find(words, 1, true), why)
end

for _, kind in ipairs{
  {"vxm@emulator", 1}, {"pmx-4ex-sa@emulator", "X", "EO=15", "HS"}, {"dmx-k-sa@emulator", "X", "EO=1", "HSPD"},
  {"vme58@emulator", "X"},
} do
  local address, axis, power, own_speed = table.unpack(kind)
  local c = assert(hw.open(address))
  if power then assert(c:query(power)) end
  local before = own_speed and c:query(own_speed)

  assert(c:move_to({[axis] = 3000}, {speed = 700}))
  hw.sleep(1.5)
  near(c:velocity(axis), 700, address .. " move_to")
  assert(c:wait(30))
  hw.check(c:position(axis) == 3000)

  assert(c:move_by({[axis] = -3000}, {speed = 600}))
  hw.sleep(1.5)
  near(-c:velocity(axis), 600, address .. " move_by")
  assert(c:wait(30))

  assert(c:jog(axis, "+", {speed = 800}))
  hw.sleep(1.5)
  near(c:velocity(axis), 800, address .. " jog")
  assert(c:stop() and c:wait(10))
  assert(c:jog(axis, "-", 800))
  hw.sleep(1.5)
  near(-c:velocity(axis), 800, address .. " jog, the speed alone")
  assert(c:stop() and c:wait(10))

  hw.check(not own_speed or c:query(own_speed) == before, address .. " has its own speed again")

  wrong('there is no option "sped". It takes speed. Did you mean "speed"?', c.move_to, c, {[axis] = 1}, {sped = 10})
  wrong("It takes speed.", c.move_by, c, {[axis] = 1}, {[1] = 10})
  wrong("must be a number above 0", c.jog, c, axis, "+", {speed = -3})
  wrong("must be a number above 0", c.move_to, c, {[axis] = 1}, {speed = "10"})
  wrong("must be a table like {speed=...}", c.move_to, c, {[axis] = 1}, 10)
  wrong('It takes mode. Did you mean "mode"?', c.home, c, axis, "-", {mod = "limit"})
  local ok, why = c:home(axis, "-", {mode = "nowhere"})
  hw.check(not ok and why:find('no way of homing "nowhere"', 1, true), why)
  hw.check(c:position(axis) and not c:status(axis).moving, "nothing of that has moved it")
end
local vxm = hw.open("vxm@emulator")
local ok, why = vxm:home(1, "-", "limit-zer")
hw.check(not ok and why:find('Did you mean "limit-zero"?', 1, true), why)
