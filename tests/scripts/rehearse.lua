-- A script's rehearsal begins from the controller as it is.
local c = hw.check(hw.open("vxm@emulator"))
hw.check(c:set("M1M", 4))
hw.check(c:set("Bx", 9))
hw.check(c:move_to{[1] = 250})
hw.check(c:wait(60))
hw.check(c:load("I2M44", 2))
local text = "S1M1500\nA1M3\nIA1M100\nJM2\n"
local r = hw.check(c:rehearse(text))
hw.check(r.finished and not r.error and not r.endless)
hw.check(r.axes[1].begin == 250 and r.axes[1].position == 100 and r.axes[1].min == 91, "backlash, from 250")
hw.check(r.axes[2].position == 44, "the controller's own program 2")
hw.check(not r.assumptions.S1M and r.assumptions.S2M, "motor 2 runs by a speed that nobody has told")
hw.check(c:position(1) == 250, "nothing has moved")

-- It is what the run does.
hw.check(c:load(text))
hw.check(c:run())
hw.check(c:wait(60))
hw.check(c:position(1) == 100 and c:position(2) == 44)

-- A switch in the way.
c.bench:place(1, {minus = -5000, plus = 700})
r = hw.check(c:rehearse("S1M2000\nI1M9000\n"))
hw.check(#r.stops == 1 and r.stops[1].axis == "1" and r.stops[1].direction == 1 and r.stops[1].line == 2)
hw.check(r.axes[1].position < 9000 and r.limit_touched)

local none, why = c:rehearse("S1M9999\n")
hw.check(not none and why:find("Line 1", 1, true), why)

local p = hw.check(hw.open("pmx-4ex-sa@emulator"))
hw.check(p:set("HS", 500))
r = hw.check(p:rehearse("X1000\nWAITX\nIF V3=0\nDO1=1\nENDIF\nEND\n"))
hw.check(r.axes.X.position == 1000 and r.outputs[1] and r.duration > 2, r.duration)
hw.check(not r.assumptions.V3, "the controller has told it")
