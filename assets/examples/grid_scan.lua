-- Reads an analog input at each point of a grid and writes a table: grid.csv beside this script.
local points, pitch = 4, 500
local c = hw.check(hw.open(hw.args[1] or "pmx-4ex-sa@emulator"))
c:send("EO=15")                             -- motor power
local rows = {{"x", "y", "millivolts"}}
for j = 0, points - 1 do
  for i = 0, points - 1 do
    local k = j % 2 == 0 and i or points - 1 - i   -- there and back: no empty way
    hw.check(c:move_to({X = k * pitch, Y = j * pitch}, {speed = 2000}))
    hw.check(c:wait(60))
    rows[#rows + 1] = {c:position("X"), c:position("Y"), hw.check(c:analog(1))}
  end
end
hw.check(hw.write_csv("grid.csv", rows))
print(#rows - 1 .. " points")
