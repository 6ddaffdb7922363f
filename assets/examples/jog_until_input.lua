-- Jogs until an input is operated, then stops.
local c = hw.check(hw.open(hw.args[1] or "dmx-k-sa@emulator"))
c:send("EO=1")
if c.bench then c.bench:at(hw.now() + 3, function() c.bench:input(1, true) end) end
hw.check(c:jog("X", "+", {speed = 1000}))
local found, why = c:wait_until(function() return c:input(1) end, 30)
hw.check(c:stop() and c:wait(10))
hw.check(found, why)
print("found at " .. c:position("X"))
