-- How well does a home switch repeat? Comes from the same side each time and compares the places.
local c = hw.check(hw.open(hw.args[1] or "vxm@emulator"))
if c.bench then c.bench:place(1, {minus = -1500}) end
c:set("M1M", 4)                             -- the motor type
hw.check(c:home(1, "-", "limit-zero") and c:wait(120))
local lowest, highest = math.huge, -math.huge
for _ = 1, 5 do
  hw.check(c:move_to{[1] = 800} and c:wait(60))
  hw.check(c:home(1, "-", {mode = "limit"}) and c:wait(60))
  local at = hw.check(c:position(1))
  lowest, highest = math.min(lowest, at), math.max(highest, at)
end
print("scatter " .. highest - lowest .. " steps")
