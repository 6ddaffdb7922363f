-- The jog pad under a hand: a tap, a hold, Esc, a lost focus, the cable.
local c = assert(hw.open("vxm@emulator"))
c:set("M1M", 4)
c:set("M2M", 4)
ui.frame(5)

-- a tap moves exactly the chosen step
local before = c:position(1)
ui.click("jog/1/+")
c:wait(10)
local step = c:position(1) - before
hw.check(step > 0 and step <= 4000, "a tap moved " .. step)
ui.click("jog/1/-")
c:wait(10)
hw.check(c:position(1) == before, "the tap back")

-- longer is continuous, until the hand lets go
ui.press("jog/1/+")
hw.sleep(1)
hw.check(c:status(1).moving, "moving while held")
ui.release("jog/1/+")
c:wait(10)
local stopped = c:position(1)
hw.check(stopped > before + 400, "held: " .. stopped)
hw.sleep(2)
hw.check(c:position(1) == stopped, "stays where it is")

-- Esc stops what the mouse still holds
ui.press("jog/2/-")
hw.sleep(0.8)
ui.key("Escape")
c:wait(10)
stopped = c:position(2)
hw.sleep(1.5)
hw.check(c:position(2) == stopped, "stopped by Esc though held")
ui.release("jog/2/-")
hw.sleep(1)
hw.check(c:position(2) == stopped, "releasing starts nothing")

-- a window that loses the focus holds nothing
ui.press("jog/1/-")
hw.sleep(0.6)
ui.lose_focus()
hw.sleep(1.5)
stopped = c:position(1)
hw.sleep(1)
hw.check(c:position(1) == stopped and not c:status(1).moving, "stopped with the focus")

-- the number on the screen is the controller's
hw.check(ui.value("dro/1/position"):gsub("[^%d-]", "") == tostring(c:position(1)), ui.value("dro/1/position"))

-- stop all, by its button
c:move_by{[1] = 20000}
hw.sleep(0.5)
ui.click("stop_all")
c:wait(10)
hw.check(c:status(1).ended_by == "stop", "ended by " .. c:status(1).ended_by)
