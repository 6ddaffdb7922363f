-- Reads an analog input at each point of a grid and writes a table: grid.csv beside this script.
local a = hw.arguments{about = "Reads an analog input at each point of a grid, into grid.csv.",
  {name = "address", default = "pmx-4ex-sa@emulator", help = "the controller"},
  {name = "points", kind = "whole", default = 4, help = "on each side"},
  {name = "pitch", kind = "whole", default = 500, help = "steps between two"},
}
local c = hw.check(hw.open(a.address))
c:send("EO=15")                             -- motor power
local rows = {{"x", "y", "millivolts"}}
for j = 0, a.points - 1 do
  for i = 0, a.points - 1 do
    local k = j % 2 == 0 and i or a.points - 1 - i   -- there and back: no empty way
    hw.check(c:move_to({X = k * a.pitch, Y = j * a.pitch}, {speed = 2000}))
    hw.check(c:wait(60))
    rows[#rows + 1] = {c:position("X"), c:position("Y"), hw.check(c:analog(1))}
  end
end
hw.check(hw.write_csv("grid.csv", rows))
print(#rows - 1 .. " points")
