-- Boards and controllers with habits that their manuals do not know are worked with as any other.

local function same(got, wanted, what)
  hw.check(got == wanted, what .. ": " .. tostring(got) .. " instead of " .. tostring(wanted))
end

-- a VME58 that prints blanks, signs and leading zeros: its queues are seen to be empty, and it is idle
local c = assert(hw.open("vme58@emulator,quirk=padded+oms-kk"))
c:send("AX VL1000 AC10000 MR300 GO ")
same(c:wait(20), true, "a text has ended")
same(c:position("X"), 300, "its place")
hw.check(c:move_to{X = -200, Y = 50})
same(c:wait(20), true, "a move of two axes")
same(c:position("X"), -200, "X")
same(c:position("Y"), 50, "Y")
same(c:status("X").activity, "idle", "its activity")
same(c:query("AX RP", 1), "  -000200", "what the board prints is shown as it came")

-- a VXM that takes a mode while a program runs
local v = assert(hw.open("vxm@emulator,quirk=mode-while-running"))
hw.check(v:load("I1M2000", 1))
hw.check(v:run(1))
same(v:wait(20), true, "a program has ended")
same(v:position(1), 2000, "its place")

-- a VXM with firmware 1.19, which does not tell its outputs
local old = assert(hw.open("vxm@emulator,quirk=old-firmware"))
hw.check(old:move_by{[1] = 400})
same(old:wait(20), true, "a move has ended")
same(old:position(1), 400, "its place")
same(old:output(1, true), true, "an output is set")
local state, why = old:output(1)
same(state, nil, "an output that nobody can read")
hw.check(type(why) == "string", "a reason")
hw.log(why)
hw.sleep(5)
same(old:status().link, "good", "it stays connected")
