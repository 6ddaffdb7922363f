-- Saves places by name and goes through them.
local c = hw.check(hw.open(hw.args[1] or "pmx-4ex-sa@emulator"))
c:send("EO=15")
hw.check(c:place("load", {X = 0, Y = 0}))
hw.check(c:place("measure", {X = 4000, Y = 1500}))
hw.check(c:place("park", {X = 200, Y = 3000}))
for _, name in ipairs{"load", "measure", "park", "load"} do
  hw.check(c:go(name) and c:wait(60))
  print(name, c:position("X"), c:position("Y"))
end
