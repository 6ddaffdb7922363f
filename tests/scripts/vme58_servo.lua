-- A servo axis stands where its encoder stands: a script reads that, waits for it, and is asked before a gain
-- drives the motor a long way.
local c = assert(hw.open("vme58@emulator"))

local function same(got, wanted, what)
  hw.check(got == wanted, what .. ": " .. tostring(got) .. " instead of " .. tostring(wanted))
end
local function says(why, words)
  hw.check(tostring(why):find(words, 1, true), "\"" .. tostring(why) .. "\" does not say: " .. words)
end

-- the ideal plant of the bench is in place at once
hw.check(c:move_to{X = 3000})
same(c:wait(20), true, "X")
local x = c:status("X")
same(x.servo, true, "X is a servo axis")
same(x.in_place, true, "in place")
same(x.open_loop, false, "its loop is closed")
same(x.command, 3000, "its command")
same(x.following_error, 0, "its error")

-- a motor without gains is sent, and does not come
c.bench:place("Y", {motor = true})
c:send("AY VL20000")
hw.check(c:move_to{Y = 5000})
hw.sleep(1)
same(c:status("Y").moving, true, "it has not come")
local came, why = c:wait(20)
same(came, nil, "Y")
says(why, "Axis Y did not reach its target: its encoder stands at 0, 5000 counts from there")
same(c:position("Y"), 0, "its place")
same(c:encoder("Y"), 0, "its encoder")
local y = c:status("Y")
same(y.activity, "idle", "it rests")
same(y.ended_by, "not_in_place", "how it ended")
same(y.in_place, false, "not in place")
same(y.command, 5000, "where it is sent")
same(y.following_error, 5000, "how far that is")

-- its gains are asked about
hw.check(c:set("KDY", 8))
local set, why_not = c:set("KPY", 2)
same(set, nil, "a gain that drives it there")
says(why_not, "its encoder is 5000 counts from its command")
says(why_not, 'c:set("KPY", value, "stay")')
same(c:position("Y"), 0, "nothing was sent")
hw.check(c:set("KPY", 2, "stay"))
same(c:wait(20), true, "it stays")
same(c:position("Y"), 0, "where it stood")
same(c:status("Y").command, 0, "and that is its command")
hw.check(c:move_to{Y = 2000})
same(c:wait(20), true, "now it comes")
hw.check(math.abs(c:position("Y") - 2000) <= 10, "to " .. c:position("Y"))

-- the motor is let go, turned by hand, and driven back on purpose
c:send("AY KP0 HF")
c.bench:slip("Y", -1500)
same(c:wait(20), true, "turned")
hw.check(select(2, c:set("KPY", 1)) == nil, "an open loop drives nothing")
hw.check(c:set("KPY", 0))
same(c:status("Y").open_loop, true, "its loop is open")
hw.check(math.abs(c:position("Y") - 500) <= 10, "by hand: " .. c:position("Y"))
c:send("AY HN LP" .. c:status("Y").command)
same(c:wait(20), true, "closed")

-- step axes are counted as ever
local s = assert(hw.open("vme58@emulator,variant=4S4"))
same(s:status("U").servo, false, "U is a step axis")
same(s:status("U").command, nil, "and has no other place")
