-- Thirty devices on a slow line: a wait asks all of them at once, not one after the other.
local c = assert(hw.open("dmx-k-sa@emulator,id=01-30,wire=real"))
local goals = {}
for i = 1, 30 do goals[string.format("%02d", i)] = 100 * i end
hw.check(c:move_to(goals))
hw.check(c:wait(60))
for id, goal in pairs(goals) do hw.check(c.devices[id]:position("X") == goal, id .. " is there") end
local began = hw.now()
hw.check(c:wait(60))
hw.check(hw.now() - began < 15, "at rest it took " .. hw.now() - began .. " s")
