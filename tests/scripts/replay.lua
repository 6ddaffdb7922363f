-- A minute with two controllers, a jog, a program and a pulled cable. command_line.py runs it twice and compares
-- every byte of both wires.
local a, b = assert(hw.open("vxm@emulator")), assert(hw.open("vxm@emulator,motors=4,wire=real"))
a:set("M1M", 4)
a:jog(1, "+")
b:load("LM0\nI1M400\nP3\nI1M-400\nL3", 0)
hw.sleep(1.25)
a:stop()
a:wait(10)
b:run(0)
b.bench:at(6, function() b.bench:unplug(true) end)
b.bench:at(9.5, function() b.bench:unplug(false) end)
a:move_to{[1] = 0}
a:wait(20)
hw.sleep(12 - hw.now())
b.bench:garble(3)
b:position(1)
b:move_by{[3] = 800}
b:wait(30)
a.bench:at(30, function() a.bench:input(2, true) end)
while hw.now() < 60 do
  a:move_by{[1] = 250}
  a:wait(10)
  hw.sleep(2)
end
