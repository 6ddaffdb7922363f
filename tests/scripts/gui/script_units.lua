-- What the window calls a length of an axis counts for a script of the same run, until it tells another one.
local function near(got, want, by)
  hw.check(got and math.abs(got - want) <= by, string.format("got %s, want %s", tostring(got), tostring(want)))
end
local c = assert(hw.open("vxm@emulator"))
assert(c:set("M1M", 4))
hw.sleep(1)
local ok, why = pcall(c.move_to, c, {[1] = 1}, {unit = true})
hw.check(not ok and why:find("axis 1 has no unit yet", 1, true), why)

ui.click("dro/unit") ui.frame(3)
ui.click("dro/unit/axis/1") ui.frame(3)
ui.click("dro/unit/axis/1/UniSlide K2, Q2 or BiSlide M02: 2 mm a turn") ui.frame(3)
local unit = c:units(1)
hw.check(unit.unit == "mm", unit.unit)
near(unit.steps_per_unit, 200, 1e-6)
assert(c:move_to({[1] = 2}, {unit = true}) and c:wait(30))
near(c:position(1), 2 * unit.steps_per_unit, 0.5)

ui.click("dro/unit/reversed/1") ui.frame(3)
near(c:units(1).steps_per_unit, -unit.steps_per_unit, 1e-6)
near(c:position(1, {unit = true}), -2, 0.02)
assert(c:limits(1, {minus = -50, plus = 100}, {unit = true}))
near(c:limits(1).plus, 50 * unit.steps_per_unit, 0.5)  -- the lower end in units is the upper one in steps
near(c:limits(1, nil, {unit = true}).plus, 100, 0.02)
assert(c:move_to({[1] = -40}, {unit = true, speed = 10}))
hw.sleep(1)
near(c:velocity(1, {unit = true}), -10, 0.5)
assert(c:wait(30))

ui.click("dro/unit/steps") ui.frame(3)
near(c:position(1, {unit = true}), -40, 0.02)  -- shown in steps, and still known
assert(c:units(1, {unit = "turn", steps_per_unit = 100}))
hw.check(c:units(1).unit == "turn" and c:units(1).steps_per_unit == 100, "the script's own goes first")
