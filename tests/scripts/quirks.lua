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
