-- Every method of a controller, against an emulated VXM.
local c, why = hw.open("vxm@emulator")
hw.check(c, why)
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end
local function refused(what, ok, reason, part)
  hw.check(ok == nil, what .. ": should be refused")
  hw.check(reason:find(part, 1, true), what .. ": the reason reads " .. reason)
end

-- raw text
same(c:query("V"), "R", "query V")
same(c:query("X"), "+0000000", "query X")
same(c:send("PM0"), true, "send")
same(c:query("PM", 1.0), "0", "query PM")
c:send("C,I1M40,R")
same(c:read(5), "^", "read the prompt")
same(c:position(1), 40, "position after a raw run")
local nothing, reason = c:read(0.1)
refused("read without news", nothing, reason, "Nothing")
c:send("C")

-- moves
for m = 1, 2 do same(c:set("M" .. m .. "M", 4), true, "motor type") end
same(c:move_to{[1] = 400}, true, "move_to")
same(c:wait(10), true, "wait")
same(c:position(1), 400, "position 1")
same(c:move_by{["1"] = -100, ["2"] = 50}, true, "move_by")
same(c:wait(10), true, "wait")
same(c:position("1"), 300, "position by name")
same(c:position(2), 50, "position 2")
local began = hw.now()
c:move_by{[1] = 4000}
hw.sleep(0.5)
local s = c:status(1)
same(s.moving, true, "moving")
same(s.activity, "moving", "activity")
hw.check(c:velocity(1) > 0, "velocity while moving")
local midway = c:position(1)
hw.check(midway > 300 and midway < 4300, "position on the way: " .. midway)
same(c:stop(), true, "stop")
same(c:wait(10), true, "wait after a stop of one's own")
same(c:status(1).ended_by, "stop", "ended by")
same(c:status(1).moving, false, "at rest")
same(c:velocity(1), 0.0, "velocity at rest")

same(c:jog(2, "-"), true, "jog")
hw.sleep(0.4)
same(c:status(2).jogging, true, "jogging")
same(c:stop(2), true, "stop of one axis")
c:wait(10)
hw.check(c:position(2) < 50, "jogged to " .. c:position(2))
c:jog(1, "+", 500)
hw.sleep(0.2)
same(c:abort(1), true, "abort")
same(c:wait(10), true, "wait after an abort of one's own")
c:move_by{[1] = 5000}
hw.sleep(0.5)
c.bench:button("Stop", true)
local cut, why_cut = c:wait(10)
refused("wait after the panel's Stop", cut, why_cut, "Stop button")
same(c:status(1).ended_by, "elsewhere", "ended by the panel's Stop")
c.bench:button("Stop", false)
hw.sleep(0.5)

c.bench:place(1, {minus = -2000, plus = 9000})
same(c:home(1, "-"), true, "home")
same(c:wait(60), true, "wait for home")
same(c:status(1).limit_minus, true, "on the limit")

-- what is refused says why
refused("unknown axis", pcall(c.position, c, 7) and nil, select(2, c:position(7)), "There is no such axis. VXM has: 1, 2.")
refused("encoder", nil, select(2, c:encoder(1)), "no encoder")
local ok, message = pcall(c.move_to, c, {[1] = 1.5})
hw.check(not ok and message:find("whole number of steps"), message)
ok, message = pcall(c.jog, c, 1, "up")
hw.check(not ok and message:find('"+" or "-"', 1, true), message)
ok, message = pcall(c.position, 3)
hw.check(not ok and message:find("colon"), message)
local far, why_far = c:move_by{[1] = 99999999}
refused("a move too far", far, why_far, "99999999")

-- inputs and outputs
same(c:input(1), false, "input at rest")
c.bench:input(1, true)
same(c:input(1), true, "input operated")
c.bench:input(1, false)
same(c:output(1), false, "output")
same(c:output(1, true), true, "set output")
same(c:output(1), true, "output is on")
same(c:output(1, false), true, "set output")
same(c:analog(1), 512, "analog")
c.bench:analog(1, 100)
same(c:analog(1), 100, "analog after the bench")
refused("input 99", nil, select(2, c:input(99)), "There is no input 99.")

-- parameters
same(c:get("M1M"), 4, "get")
same(c:set("j1M", 500), true, "set")
same(c:get("j1M"), 500, "get after set")
local set, why_set = c:set("j1M", 500000)
refused("out of range", set, why_set, "500000")
same(c:get("j1M"), 500, "unchanged")
refused("unknown parameter", nil, select(2, c:get("nope")), 'no parameter "nope"')

-- status of the whole controller
local all = c:status()
same(all.link, "good", "link")
same(all.program, "idle", "program")
same(all.moving, false, "moving")
same(all.why, nil, "nothing is amiss")

-- without a link there is a table still, which says so and tells nothing old
c.bench:unplug(true)
hw.sleep(3)
all = c:status()
hw.check(all.link == "lost" or all.link == "connecting", "link: " .. tostring(all.link))
hw.check(#all.why > 20, "why: " .. tostring(all.why))
for _, unknown in ipairs{"moving", "program", "firmware", "unsaved_setup"} do same(all[unknown], nil, unknown) end
c.bench:unplug(false)
hw.sleep(6)
all = c:status()
same(all.link, "good", "link again")
same(all.moving, false, "moving again")

-- two axes of targets in the order of the axes, whatever the table says
c:move_to{[2] = 0, [1] = 0}
same(c:wait(30), true, "wait for both")
same(c:position(1), 0, "back 1")
same(c:position(2), 0, "back 2")

-- patience
c:move_by{[1] = 8000}
local late, why_late = c:wait(0.2)
refused("wait in vain", late, why_late, "Timeout")
c:wait(30)
hw.check(hw.now() > began, "time goes on")
