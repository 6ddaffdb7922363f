-- Every method of a controller, against an emulated PMX-4EX-SA.
local c = assert(hw.open("pmx-4ex-sa@emulator"))
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end

same(c:query("ID"), "Performax-4EX-SA", "query ID")
same(c:get("DN"), "4EX00", "name")
same(c:set("DN", "4EX07"), true, "set the name")
same(c:query("DN"), "4EX07", "the new name")
same(c:set("DN", "4EX00"), true, "and back")
same(c:set("SLRX", 1.25), true, "ratio")
same(c:query("SLRX"), "1.250", "as the controller says it")

-- four axes on a straight line
same(c:move_to{X = 4000, Y = 2000, Z = -1000, U = 500}, true, "move_to")
hw.check(c:wait(60))
same(c:position("X"), 4000, "X")
same(c:position("Y"), 2000, "Y")
same(c:position(3), -1000, "Z")
same(c:position(4), 500, "U")

-- a circle about the origin by the maker's own text
same(c:query("CIRP0:0"), "OK", "circle")
hw.sleep(0.5)
hw.check(c:status("X").moving, "circle runs")
hw.check(c:wait(120))
same(c:position("X"), 4000, "back where it began")

-- two jogs at once, one stopped alone
hw.check(c:jog("Z", "+"))
hw.check(c:jog("U", "-"))
hw.sleep(1)
hw.check(c:stop("Z"))
hw.check(not c:status("Z").moving and c:status("U").moving, "only Z has stopped")
hw.check(c:stop())
hw.check(not c:status("U").moving, "now U too")

-- homing onto an index mark
c.bench:place("X", {index_every = 4000})
hw.check(c:home("X", "+", "index"))
hw.check(c:wait(60))
same(c:position("X"), 0, "zero at the index")

c.bench:analog(2, 1234)
hw.sleep(3)
same(c:analog(2), 1234, "analog")
for n = 1, 8 do
  c.bench:analog(n, 2000 + n)
  same(c:analog(n), 2000 + n, "analog " .. n .. ", at once")
end

-- two programs at once, each with its own thread
hw.check(c:load([[
PRG 0
WHILE 1=1
V1=V1+1
DELAY=10
ENDWHILE
END
PRG 1
X1000
WAITX
V2=7
END
]]))
hw.check(c:run(0) and c:run(1))
hw.sleep(5)
same(c:query("V2"), "7", "program 1 came to its end")
same(c:query("SASTAT0"), "1", "program 0 runs on")
hw.check(c:pause(0))
same(c:query("SASTAT0"), "2", "paused")
hw.check(c:resume(0) and c:halt(0))
same(c:query("SASTAT0"), "0", "halted")

-- What is read while it moves is read for whoever asks: no line is left out.
hw.check(c:stop() and c:wait(20))
c:send("EO=15")
hw.check(c:move_by{X = 20000})
for _ = 1, 50 do
  hw.sleep(0.013)
  local input, why = c:input(1)
  hw.check(input ~= nil, why)
  local output, why_not = c:output(1)
  hw.check(output ~= nil, why_not)
end
hw.check(c:status("X").moving, "and it moves")
hw.check(c:stop() and c:wait(20))
