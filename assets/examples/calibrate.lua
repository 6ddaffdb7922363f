-- Steps per millimetre from two points that were measured with a gauge, and a move to 20 mm in them.
local a = hw.arguments{about = "Steps per millimetre from two measured points.",
  {name = "address", default = "dmx-k-sa@emulator", help = "the controller"},
  {name = "first", kind = "number", default = 2.5, help = "mm at 0 steps"},
  {name = "second", kind = "number", default = 52.5, help = "mm at 10000 steps"},
}
hw.check(a.second ~= a.first, "the two points are one")
local c = hw.check(hw.open(a.address))
hw.check(c:query("EO=1"))                   -- motor power
hw.check(c:move_to({X = 10000}, {speed = 4000}) and c:wait(60))
local per_mm = hw.check(c:position("X")) / (a.second - a.first)
hw.check(c:units("X", {unit = "mm", steps_per_unit = per_mm}))
print(string.format("%.3f steps a millimetre, zero at %.3f mm", per_mm, a.first))
hw.check(c:move_to({X = 20 - a.first}, {unit = true, speed = 15}) and c:wait(60))   -- to 20 mm at 15 mm/s
print("at 20 mm: " .. c:position("X"))
