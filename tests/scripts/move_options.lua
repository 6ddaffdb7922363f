-- A speed and an acceleration that are given with one motion hold for that motion, on every kind of controller.
local function near(got, want, what)
  hw.check(got and math.abs(got - want) <= 0.03 * want, string.format("%s: got %s, want %s", what, got, want))
end

local function wrong(words, f, ...)
  local ok, why = pcall(f, ...)
  hw.check(not ok, "taken: " .. words)
  hw.check(why:find(words, 1, true), why)
end

-- How long a move takes that goes to its speed and back: distance by speed, and the time of the ramp.
local function seconds_of(c, axis, options)
  local began = hw.now()
  assert(c:move_by({[axis] = 9000}, options) and c:wait(60))
  local took = hw.now() - began
  assert(c:move_by({[axis] = -9000}, options) and c:wait(60))
  return took
end

-- The slow ramp of each takes 2 s to 3000 steps/s, in the controller's own unit.
for _, kind in ipairs{
  {"vxm@emulator", 1, nil, nil, 1, {0, 128}}, {"pmx-4ex-sa@emulator", "X", "EO=15", "HS", 2000, {0, 1 << 40}},
  {"dmx-k-sa@emulator", "X", "EO=1", "HSPD", 2000, {0, 1 << 40}}, {"vme58@emulator", "X", nil, nil, 1000, {0, 8000001}},
} do
  local address, axis, power, own_speed, slow, beyond = table.unpack(kind)
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

  local plain = seconds_of(c, axis, {speed = 3000})
  local ramped = seconds_of(c, axis, {speed = 3000, acceleration = slow})
  hw.check(ramped > plain + 1, string.format("%s: %s s by its own ramp, %s s by one of 2 s", address, plain, ramped))
  near(seconds_of(c, axis, {speed = 3000}), plain, address .. ": the next move has the controller's own ramp")
  assert(c:jog(axis, "+", {speed = 3000, acceleration = slow}))
  hw.sleep(0.8)
  hw.check(c:velocity(axis) < 2700, address .. ": the jog is on its slow ramp")
  assert(c:stop() and c:wait(10))
  near(seconds_of(c, axis, {speed = 3000}), plain, address .. ": and so has the move behind a jog")
  for _, value in ipairs(beyond) do
    local ok, why, more = c:move_by({[axis] = 10}, {acceleration = value})
    hw.check(not ok and why:find("acceleration", 1, true) and why:find("Nothing was sent.", 1, true), why)
    hw.check(more.kind == "refused" and more.axis == tostring(axis), more.axis)
  end

  c.bench:place(axis, {minus = -40000, plus = 40000, home = axis ~= 1 and {-20000, -19000} or nil})
  assert(c:move_to({[axis] = 0}) and c:wait(60))
  assert(c:home(axis, "-", {speed = 600, acceleration = slow}))
  hw.sleep(2)
  near(-c:velocity(axis), 600, address .. " home")
  assert(c:stop() and c:wait(30))
  near(seconds_of(c, axis, {speed = 3000}), plain, address .. ": and so has the move behind homing")

  hw.check(not own_speed or c:query(own_speed) == before, address .. " has its own speed again")

  wrong('there is no option "sped". It takes speed, acceleration, unit. Did you mean "speed"?', c.move_to, c, {[axis] = 1}, {sped = 10})
  wrong("It takes speed, acceleration, unit.", c.move_by, c, {[axis] = 1}, {[1] = 10})
  wrong("must be a number above 0", c.jog, c, axis, "+", {speed = -3})
  wrong("must be a number above 0", c.move_to, c, {[axis] = 1}, {speed = "10"})
  wrong("must be a whole number, in the controller's own unit", c.move_to, c, {[axis] = 1}, {acceleration = 1.5})
  wrong("must be a table like {speed=...}", c.move_to, c, {[axis] = 1}, 10)
  wrong('It takes mode, speed, acceleration, unit. Did you mean "mode"?', c.home, c, axis, "-", {mod = "limit"})
  local ok, why = c:home(axis, "-", {mode = "nowhere"})
  hw.check(not ok and why:find('no homing mode "nowhere"', 1, true), why)
  hw.check(c:position(axis) and not c:status(axis).moving, "nothing of that has moved it")
end
local vxm = hw.open("vxm@emulator")
local refused, too_fast = vxm:home(1, "-", {speed = 1500})
hw.check(not refused and too_fast:find("finds a switch reliably up to 1000 steps/s", 1, true), too_fast)
local ok, why = vxm:home(1, "-", "limit-zer")
hw.check(not ok and why:find('Did you mean "limit-zero"?', 1, true), why)
