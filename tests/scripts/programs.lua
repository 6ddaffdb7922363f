-- Stored programs: load, list, run, pause, resume, halt.
local c = assert(hw.open("vxm@emulator"))
c:set("M1M", 4)
hw.check(c:load("I1M400\nP5\nI1M-400", 0))
hw.check(c:program(0):find("I1M400"), "listing: " .. c:program(0))
hw.check(c:load("S1M500,I1M200", 1))
hw.check(c:program(1):find("S1M500") and not c:program(1):find("I1M400"), "programs are apart")

hw.check(c:run(0))
hw.check(c:status().program == "running", "running")
hw.check(c:wait(20))
hw.check(c:position(1) == 0, "there and back")
hw.check(c:run(1))
hw.check(c:wait(20))
hw.check(c:position(1) == 200, "program 1")

-- pause and resume: held before the next command, then on to the end
hw.check(c:load("I1M1000\nI1M1000\nI1M1000", 2))
local start = c:position(1)
hw.check(c:run(2))
hw.sleep(0.3)
hw.check(c:pause())
hw.sleep(5)
hw.check(c:status().program == "held", "held: " .. c:status().program)
hw.check(c:position(1) == start + 1000, "held after the first index: " .. c:position(1))
hw.check(c:resume())
hw.check(c:wait(30))
hw.check(c:position(1) == start + 3000, "to the end")

-- halt ends an endless one
hw.check(c:load("LM0\nI1M100\nI1M-100\nL0", 3))
hw.check(c:run(3))
hw.sleep(3)
hw.check(c:status().program == "running", "still running")
hw.check(c:halt())
c:wait(10)
hw.check(c:status().program == "idle", "halted: " .. c:status().program)

local ok, why = c:load(("I1M400\n"):rep(65), 4)
hw.check(ok == nil, "260 bytes do not fit")
hw.check(why:find("256"), why)
ok, why = c:run(5)
hw.check(ok == nil and why:find("There is no such program. VXM has 0 to 4.", 1, true), why)

-- a sequence is loaded as the controller's own text; what it cannot do is refused
local sequence = [[
handwheel_sequence = 1
unit = "steps"
axes = [ { name = "1" }, { name = "2" } ]
steps = [
  %s,
]
]]
hw.check(c:load(sequence:format('{ do = "move", relative = true, to = { "1" = 250 } }'), 0))
local from = c:position(1)
hw.check(c:run(0))
hw.check(c:wait(20))
hw.check(c:position(1) == from + 250, "the sequence was run: " .. c:position(1))
ok, why = c:load(sequence:format('{ do = "arc", x = 1, y = 2, degrees = 90 }'), 0)
hw.check(ok == nil and why:find("arc", 1, true), "a VXM draws no arcs: " .. tostring(why))
