-- Two controllers at once; each has its own wire and its own bench.
local one, two = assert(hw.open("vxm@emulator")), assert(hw.open("vxm@emulator,motors=4"))
for m = 1, 2 do one:set("M" .. m .. "M", 4) end
for m = 1, 4 do two:set("M" .. m .. "M", 4) end
one:move_to{[1] = 2000}
two:move_to{[3] = 1000}
hw.check(one:wait(20))
hw.check(two:wait(20))
hw.check(one:position(1) == 2000, "one")
hw.check(two:position(1) == 0 and two:position(3) == 1000, "two")
one.bench:unplug(true)
hw.sleep(1)
hw.check(one:position(1) == nil, "one is lost")
hw.check(two:position(3) == 1000, "two is not")
local started = hw.now()
two:move_to{[4] = 500}
hw.check(two:wait(20))
hw.check(hw.now() > started, "moves take their time")
