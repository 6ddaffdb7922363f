-- Reads an analog input at each point of a grid in millimetres, and writes a table: grid.csv beside this script.
local a = hw.arguments{about = "Reads an analog input at each point of a grid, into grid.csv.",
  {name = "address", default = "pmx-4ex-sa@emulator", help = "the controller"},
  {name = "points", kind = "whole", default = 4, help = "on each side"},
  {name = "pitch", kind = "number", default = 1.25, help = "mm between two"},
  {name = "speed", kind = "number", default = 5, help = "mm/s"},
  {name = "settle", kind = "number", default = 0.2, help = "s at each point before it reads"},
}
local c = hw.check(hw.open(a.address))
hw.check(c:query("EO=15"))                  -- motor power
for _, axis in ipairs{"X", "Y"} do hw.check(c:units(axis, {unit = "mm", steps_per_unit = 400})) end
local mm = {unit = true}
local rows = {{"x (mm)", "y (mm)", "millivolts"}}
for j = 0, a.points - 1 do
  for i = 0, a.points - 1 do
    local k = j % 2 == 0 and i or a.points - 1 - i   -- there and back: no empty way
    hw.check(c:move_to({X = k * a.pitch, Y = j * a.pitch}, {unit = true, speed = a.speed}))
    hw.check(c:wait(60))
    hw.sleep(a.settle)
    rows[#rows + 1] = {c:position("X", mm), c:position("Y", mm), hw.check(c:analog(1))}
  end
end
hw.check(hw.write_csv("grid.csv", rows))
print(#rows - 1 .. " points")
