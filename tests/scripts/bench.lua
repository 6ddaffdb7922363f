-- Every method of the bench.
local c = assert(hw.open("vxm@emulator"))
local b = c.bench
c:set("M1M", 4)
local function fails(part, f, ...)
  local ok, message = pcall(f, ...)
  hw.check(not ok, "should be an error")
  hw.check(tostring(message):find(part, 1, true), message)
end

-- a limit switch by hand, in time
b:at(hw.now() + 0.3, function() b:limit(1, "+", true) end)
c:move_by{[1] = 4000}
local ok, why = c:wait(10)
hw.check(ok == nil and why:find("limit"), why)
hw.check(c:status(1).limit_plus, "limit seen")
b:limit(1, "+", false)

-- callbacks may wait too
local steps = 0
b:at(hw.now() + 1, function()
  hw.sleep(0.5)
  steps = steps + 1
  b:button("Run", true)
  hw.sleep(0.1)
  b:button("Run", false)
end)
hw.sleep(0.9)
hw.check(steps == 0, "not yet")
hw.sleep(1)
hw.check(steps == 1, "now")
c:wait(20)

-- where the switches are
b:place(2, {minus = -500, plus = 500})
c:home(2, "+")
hw.check(c:wait(30))
hw.check(c:position(2) >= 490 and c:position(2) <= 510, "stopped at " .. c:position(2))
b:place(1, {minus = -5000, plus = 90000, home = {2000, 2400}, backlash = 3})
b:place(1, {index_every = 4000, counts_per_step = 1.25})  -- a scale that a VXM does not read
fails("minus must be below plus", b.place, b, 1, {minus = 5, plus = 5})
fails('a place has no "plsu"', b.place, b, 1, {plsu = 5})
local own = setmetatable({plus = 90000}, {__index = function() error("the script's code ran in place()") end})
hw.check(b:place(1, own))

-- what the controller cannot know
local before = c:position(1)
b:slip(1, 40)
hw.check(c:position(1) == before, "a slip is not seen")
local load = b:look().load[1]
b:jam(1, true)
c:move_by{[1] = 300}
c:wait(10)
hw.check(b:look().load[1] == load, "jammed: the load stays")
b:jam(1, false)

-- the wire
b:garble(2)
hw.sleep(1)
hw.check(c:query("V") == "R", "recovers from garbled bytes")
b:drop(2)
hw.sleep(1)
hw.check(c:query("V") == "R", "recovers from dropped bytes")
b:unplug(true)
hw.sleep(1)
local x, reason = c:position(1)
hw.check(x == nil and reason:find("no connection"), tostring(reason))
hw.check(c:status(1) == nil, "no status of a lost controller")
b:unplug(false)
hw.sleep(3)
hw.check(c:position(1), "back again")

-- power
b:power_cycle()
hw.sleep(5)
hw.check(c:query("V") == "R", "on-line again after a power cycle")
hw.check(c:position(1) == 0, "counted from zero again")
b:power(false)
hw.sleep(2)
hw.check(b:look().powered == false, "off")
b:power(true)
hw.sleep(5)
hw.check(b:look().powered, "on")
hw.check(b:look().lamps["Power"], "power lamp")

-- the circuit breaker takes the power, whatever the switch says, until it is pushed in
b:breaker(true)
hw.sleep(2)
hw.check(b:look().powered == false, "tripped")
b:power(true)
hw.check(b:look().powered == false, "the switch does not help")
b:breaker(false)
hw.sleep(5)
hw.check(c:query("V") == "R", "on-line again")
fails("no supply", b.power, b, false, "Slave")
local two = assert(hw.open("vxm@emulator,motors=4"))
hw.check(two.bench:look().lamps["Slave Power"], "the Slave has power")
two.bench:power(false, "Slave")
hw.check(not two.bench:look().lamps["Slave Power"] and two.bench:look().powered, "only the Slave was switched off")
hw.sleep(2)
local where, why = two:position(3)
hw.check(where == nil and why:find("Axis 3 cannot be read now%. %S"), "with a reason: " .. tostring(why))

-- trigger pulses, with their place and time
hw.check(c:set("P1M", 100))
c:send("PM0,C,U77,I1M1000,U78")
b:analog(1, 700)
hw.check(c:analog(1) == 700)
c:move_by{[1] = 1000}
c:wait(10)
local pulses = b:pulses()
hw.check(#pulses > 0, "pulses on the way: " .. #pulses)
hw.check(pulses[1].t > 0 and pulses[1].width > 0 and pulses[1].position[1], "a pulse has its place")

fails("no such axis", b.limit, b, 9, "+", true)
fails("must be a function", b.at, b, 1, 2)
