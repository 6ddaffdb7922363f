-- Jogs until an input is operated, then stops.
local a = hw.arguments{about = "Jogs until an input is operated.",
  {name = "address", default = "dmx-k-sa@emulator", help = "the controller"},
  {name = "speed", kind = "number", default = 1000, help = "steps/s"},
  {name = "patience", kind = "number", default = 30, help = "s; then it gives up"},
}
local c = hw.check(hw.open(a.address))
hw.check(c:query("EO=1"))                   -- motor power
if c.bench then c.bench:at(hw.now() + 3, function() c.bench:input(1, true) end) end
hw.check(c:jog("X", "+", {speed = a.speed}))
local found, why = c:wait_until(function() return c:input(1) end, a.patience)
local at = c:position("X")                  -- where it was seen; the ramp goes on from there
hw.check(c:stop() and c:wait(10))
hw.check(found, why)
print("found at " .. at .. ", stands at " .. c:position("X"))
