-- Two motors on one line draw together: each move begins with both, its line is straight, and the tool, which is
-- switched by the first one, never stays on.
local c = assert(hw.open("dmx-k-sa@emulator,id=01-03,wire=real"))
local x, y = c.devices["01"], c.devices["02"]
for _, d in pairs(c.devices) do
  d:send("EO=1")
  d:send("SL=0") -- positions in pulses
end
local head = [[
handwheel_sequence = 1
unit = "mm"
axes = [ { name = "01", per_unit = 100 }, { name = "02", per_unit = 100 } ]
pen_down = [ { do = "output", output = 1, on = true } ]
pen_up = [ { do = "output", output = 1, on = false } ]
]]
local two_chains = head .. [[
steps = [
  { do = "pen", down = false },
  { do = "speed", high = 10, low = 1, ramp_ms = 100 },
  { do = "move", to = { 01 = 0, 02 = 0 } },
  { do = "pen", down = true },
  { do = "move", to = { 01 = 40, 02 = 20 } },
  { do = "move", to = { 01 = 40, 02 = 0 } },
  { do = "pen", down = false },
  { do = "move", to = { 01 = 50, 02 = 10 } },
  { do = "pen", down = true },
  { do = "move", to = { 01 = 0, 02 = 30 } },
  { do = "pen", down = false },
]
]]

local function runs() return x:status().in_pieces or y:status().in_pieces end
local function at() return c:position("01"), c:position("02") end

-- All of it, on straight lines.
hw.check(c:run_in_pieces(two_chains))
hw.check(runs(), "it is under way")
local furthest, seen_on, last_on = 0, 0, false
while runs() do
  local on = x:output(1)
  if on and not last_on then seen_on = seen_on + 1 end
  last_on = on
  local here_x, here_y = x.bench:look().load[1], y.bench:look().load[1] -- both at this instant
  if on and x:status().step == 5 then furthest = math.max(furthest, math.abs(here_y - here_x / 2)) end
  hw.sleep(0.02)
end
hw.check(c:wait(60))
hw.check(seen_on == 2, "the tool was on " .. seen_on .. " times")
hw.check(furthest > 0 and furthest < 30, "the line was left by " .. furthest .. " pulses")
local end_x, end_y = at()
hw.check(end_x == 0 and end_y == 3000, "it ends at " .. end_x .. ", " .. end_y)
hw.check(not x:output(1), "the tool is off")
hw.check(c:position("03") == 0, "nobody else has moved")

-- A stop ends all, and it goes on with the chain that was stopped.
hw.check(c:run_in_pieces(two_chains))
while not (x:output(1) and c:position("01") > 1000) do hw.sleep(0.05) end
hw.check(c:stop())
hw.check(c:wait(20))
hw.sleep(1)
hw.check(not x:output(1), "a stop switches the tool off")
local there = c:position("01")
hw.sleep(5)
hw.check(c:position("01") == there and not runs(), "nothing follows a stop")
hw.check(c:run_in_pieces(two_chains, x:status().step))
hw.check(c:wait(60))
end_x, end_y = at()
hw.check(end_x == 0 and end_y == 3000, "what was left ends at " .. end_x .. ", " .. end_y)

-- So does the stop of one of them.
hw.check(c:run_in_pieces(two_chains))
while not (x:output(1) and c:position("01") > 1000) do hw.sleep(0.05) end
hw.check(c:stop("02"))
hw.sleep(8)
hw.check(not runs(), "none goes on without the other")
hw.check(not x:output(1), "and the tool is off")
hw.check(c:wait(20))

-- A hold holds both, with the tool off, and it comes on again.
hw.check(c:run_in_pieces(two_chains))
while not (x:output(1) and c:position("01") > 1000) do hw.sleep(0.05) end
hw.check(c:pause())
hw.sleep(8)
hw.check(not x:output(1), "a hold switches the tool off")
local held_x, held_y = at()
hw.check(held_x == 4000 and held_y == 2000, "what was begun went to its end")
hw.check(c:resume())
hw.sleep(1)
hw.check(x:output(1), "it is on again")
hw.check(c:wait(60))
end_x, end_y = at()
hw.check(end_x == 0 and end_y == 3000)

-- Half as fast.
local began = hw.now()
hw.check(c:run_in_pieces(two_chains))
hw.check(c:wait(60))
local whole = hw.now() - began
began = hw.now()
hw.check(c:run_in_pieces(two_chains))
hw.check(c:override_speed(50))
hw.check(c:wait(90))
hw.check(hw.now() - began > 1.5 * whole, "it took " .. hw.now() - began .. " s, and " .. whole .. " before")

-- One that meets a limit ends it for both.
y.bench:place(1, {plus = 1000})
hw.check(c:run_in_pieces(two_chains))
hw.sleep(20)
hw.check(not runs() and not x:output(1), "a limit ends it with the tool off")
local ok, why = c:wait(20)
hw.check(not ok and why:find("limit switch", 1, true), tostring(why))

-- One that cannot take part: none begins.
y.bench:place(1, {plus = 100000})
y:send("CLR") -- the error that a limit leaves
hw.check(c:jog("02", "-"))
hw.sleep(0.3)
ok, why = c:run_in_pieces(two_chains)
hw.check(not ok and why:find("A program is running or an axis is moving", 1, true), tostring(why))
hw.sleep(3)
hw.check(not runs(), "the other has not begun either")
hw.check(c:stop())
hw.check(c:wait(20))

-- What they cannot do is said with its step.
ok, why = c:run_in_pieces(head .. 'steps = [ { do = "pen", down = false }, { do = "home", axis = "01" } ]')
hw.check(not ok and why:find("Step 2 (home)", 1, true), tostring(why))
ok, why = c:run_in_pieces(two_chains:gsub("02", "07"))
hw.check(not ok and why:find('no axis "07"', 1, true), tostring(why))
ok, why = c:pause()
hw.check(not ok and why:find("nothing together", 1, true), tostring(why))
