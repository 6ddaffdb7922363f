-- Saves places by name, in millimetres, and goes through them.
local a = hw.arguments{about = "Goes through saved places.",
  {name = "address", default = "pmx-4ex-sa@emulator", help = "the controller"},
  {name = "speed", kind = "number", default = 8, help = "mm/s"},
}
local c = hw.check(hw.open(a.address))
hw.check(c:query("EO=15"))                  -- motor power
for _, axis in ipairs{"X", "Y"} do hw.check(c:units(axis, {unit = "mm", steps_per_unit = 400})) end
hw.check(c:place("load", {X = 0, Y = 0}, {unit = true}))
hw.check(c:place("measure", {X = 10, Y = 3.75}, {unit = true}))
hw.check(c:place("park", {X = 0.5, Y = 7.5}, {unit = true}))
for _, name in ipairs{"load", "measure", "park", "load"} do
  hw.check(c:go(name, {speed = a.speed, unit = true}) and c:wait(60))
  print(name, c:position("X", {unit = true}), c:position("Y", {unit = true}))
end
