-- Units of the script's own: told by axis, taken by {unit=true}.
local function wrong(words, f, ...)
  local ok, why = pcall(f, ...)
  hw.check(not ok and why:find(words, 1, true), why)
end

local c = assert(hw.open("pmx-4ex-sa@emulator"))
assert(c:query("EO=15"))
hw.check(c:units("X").unit == "pulses" or c:units("X").unit == "steps", c:units("X").unit)
hw.check(c:units("X").steps_per_unit == 1, "until it is told, an axis counts its steps")
wrong("axis X has no unit yet", c.move_to, c, {X = 1}, {unit = true})

assert(c:units("X", {unit = "mm", steps_per_unit = 400}))
assert(c:units("Y", {unit = "deg", steps_per_unit = 100 / 3}))
hw.check(c:units("X").unit == "mm" and c:units("X").steps_per_unit == 400)
assert(c:move_to({X = 2.5, Y = 12}, {unit = true}) and c:wait(30))
hw.check(c:position("X") == 1000 and c:position("Y") == 400, c:position("X"))
hw.check(c:position("X", {unit = true}) == 2.5 and math.abs(c:position("Y", {unit = true}) - 12) < 0.02)

assert(c:jog("X", "+", {speed = 2, unit = true}))
hw.sleep(1.5)
hw.check(math.abs(c:velocity("X", {unit = true}) - 2) < 0.1, c:velocity("X", {unit = true}))
assert(c:stop() and c:wait(10))
assert(c:move_by({X = 0.5}, {speed = 5, unit = true}) and c:wait(10))

assert(c:limits("X", {minus = -1, plus = 10}, {unit = true}))
hw.check(c:limits("X").plus == 4000 and c:limits("X", nil, {unit = true}).plus == 10)
local ok, why = c:move_to({X = 10.5}, {unit = true})
hw.check(not ok and why:find("4200", 1, true), why)
assert(c:place("load", {X = 1.25}, {unit = true}) and c:go("load", {speed = 900}) and c:wait(30))
hw.check(c:position("X") == 500)
assert(c:place("away", {X = 6}, {unit = true}) and c:go("away", {speed = 2, unit = true}))
hw.sleep(1)
hw.check(math.abs(c:velocity("X", {unit = true}) - 2) < 0.1, c:velocity("X", {unit = true}))
assert(c:wait(30))
wrong('Did you mean "speed"?', c.go, c, "away", {sped = 2})

wrong("needs axes of one unit", c.move_to, c, {X = 1, Y = 1}, {unit = true, speed = 1})
wrong("unit must be true or false", c.move_to, c, {X = 1}, {unit = "mm"})
wrong("give both", c.units, c, "X", {unit = "mm"})
wrong("must be a number above 0", c.units, c, "X", {unit = "mm", steps_per_unit = -4})
wrong("must be a number of units", c.move_to, c, {X = "1"}, {unit = true})

local bus = assert(hw.open("dmx-k-sa@emulator,id=01-02"))
for _, device in pairs(bus.devices) do assert(device:query("EO=1")) end
assert(bus:units("02", {unit = "mm", steps_per_unit = 200}))
assert(bus:move_to({["02"] = 1.5}, {unit = true}) and bus:wait(30))
hw.check(bus:position("02") == 300 and bus.devices["02"]:position(1, {unit = true}) == 1.5)

-- On a bus the reason begins with the device; what to do stands apart.
local moved, reason, more = bus:move_to({["02"] = 200000000})
hw.check(not moved and reason:sub(1, 4) == "02: " and more.kind == "refused" and more.device:find("dmx-k-sa", 1, true), reason)
assert(c:limits("X", {}))
local v = assert(hw.open("vxm@emulator"))
assert(v:move_by{[1] = 40000})
local again, busy, told = v:run(0)
hw.check(not again and told.what_to_do and busy:sub(-#told.what_to_do) == told.what_to_do, busy)
