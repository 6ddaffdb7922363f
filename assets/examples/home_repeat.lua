-- How well does a limit switch repeat? Homes to it from the same side each time, and compares the places.
local a = hw.arguments{about = "Homes to a limit switch again and again, and compares the places.",
  {name = "address", default = "vxm@emulator", help = "the controller"},
  {name = "times", kind = "whole", default = 10, help = "how often"},
}
local c = hw.check(hw.open(a.address))
-- The emulated switch acts up to 4 steps before or behind its place.
if c.bench then c.bench:place(1, {minus = -1500, scatter = 4}) end
c:set("M1M", 4)                             -- the motor type
hw.check(c:home(1, "-", {mode = "limit-zero"}) and c:wait(120))
local places, sum = {}, 0
for i = 1, a.times do
  hw.check(c:move_to({[1] = 800}, {speed = 3000}) and c:wait(60))
  hw.check(c:home(1, "-", {mode = "limit"}) and c:wait(60))
  places[i] = hw.check(c:position(1))
  sum = sum + places[i]
end
table.sort(places)
local mean, squares = sum / #places, 0
for _, at in ipairs(places) do squares = squares + (at - mean) ^ 2 end
print(string.format("scatter %d steps, standard deviation %.1f", places[#places] - places[1],
                    math.sqrt(squares / #places)))
