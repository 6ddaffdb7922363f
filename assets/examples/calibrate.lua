-- Steps per millimetre from two points that were measured with a gauge: calibrate.lua MM_AT_0 MM_AT_10000
local first, second = tonumber(hw.args[1]) or 2.5, tonumber(hw.args[2]) or 52.5
local c = hw.check(hw.open("dmx-k-sa@emulator"))
c:send("EO=1")
hw.check(c:move_to({X = 10000}, {speed = 4000}) and c:wait(60))
local steps = c:position("X")
hw.check(second ~= first, "the two points are one")
local per_mm = steps / (second - first)
print(string.format("%.3f steps a millimetre, zero at %.3f mm", per_mm, first))
hw.check(c:move_to{X = math.floor((20 - first) * per_mm + 0.5)} and c:wait(60))   -- to 20 mm
print("at 20 mm: " .. c:position("X"))
