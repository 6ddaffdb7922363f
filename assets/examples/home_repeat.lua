-- How well does a limit switch repeat? Homes to it from the same side each time, and compares the places.
local a = hw.arguments{about = "Homes to a limit switch again and again; the places go into home_repeat.csv.",
  {name = "address", default = "vxm@emulator", help = "the controller"},
  {name = "times", kind = "whole", default = 10, help = "how often"},
  {name = "away", kind = "whole", default = 800, help = "steps that it goes away between two"},
}
local c = hw.check(hw.open(a.address))
-- The emulated switch acts up to 4 steps before or behind its place.
if c.bench then c.bench:place(1, {minus = -1500, scatter = 4}) end
hw.check(c:set("M1M", 4))                   -- the motor type
hw.check(c:home(1, "-", {mode = "limit-zero"}) and c:wait(120))
local rows, places, sum = {{"run", "steps"}}, {}, 0
for i = 1, a.times do
  hw.check(c:move_to({[1] = a.away}, {speed = 3000}) and c:wait(60))
  hw.check(c:home(1, "-", {mode = "limit", speed = 1000}) and c:wait(60))
  places[i] = hw.check(c:position(1))
  rows[#rows + 1] = {i, places[i]}
  sum = sum + places[i]
end
hw.check(hw.write_csv("home_repeat.csv", rows))
table.sort(places)
local mean, squares = sum / #places, 0
for _, at in ipairs(places) do squares = squares + (at - mean) ^ 2 end
print(string.format("scatter %d steps, standard deviation %.1f", places[#places] - places[1],
                    math.sqrt(squares / #places)))
