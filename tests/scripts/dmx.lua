-- Every method of a controller, against an emulated DMX-K-SA.
local c = assert(hw.open("dmx-k-sa@emulator"))
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end

same(c:query("ID"), "DriveMax-K-SA", "query ID")
same(c:query("FOO"), "?FOO", "a refusal")
same(c:get("DN"), "DMK01", "name")
same(c:get("SLR"), 0.8, "ratio")
same(c:set("SLR", 0.8), true, "set the ratio")
same(c:set("HSPD", 5000), true, "set HSPD")
same(c:get("HSPD"), 5000, "get HSPD")
local ok, why = c:set("CURR", 50)
hw.check(ok == nil and why:find("100 to 2500"), tostring(why))

same(c:move_to{X = 4000}, true, "move_to")
local moving = c:status("X")
hw.check(moving.moving, "moves")
hw.check(c:wait(30))
same(c:position("X"), 4000, "position")
hw.check(math.abs(c:encoder("X") - 4000) <= 20, "encoder " .. tostring(c:encoder("X")))
same(c:move_by{X = -1000}, true, "move_by")
hw.check(c:wait(30))
same(c:position(1), 3000, "by number")

hw.check(c:jog("X", "-"))
hw.sleep(1)
hw.check(c:velocity("X") ~= 0, "velocity")
hw.check(c:stop("X"))
hw.check(c:wait(10) == nil or true)
same(c:status("X").activity, "idle", "after stop")

-- a limit, and clearing it by the maker's own word
c.bench:limit("X", "+", true)
hw.check(c:move_by{X = 1000})
local done, reason = c:wait(10)
hw.check(done == nil and reason:find("limit"), tostring(reason))
c.bench:limit("X", "+", false)
same(c:query("CLR"), "OK", "CLR")

same(c:output(2, true), true, "output")
hw.check(c:output(2), "output 2 is on")
ok, why = c:output(1, false)
hw.check(ok == nil and why:find("DO1 stays on: it shows in-position while EDO=1", 1, true), tostring(why))
ok, why = c:resume()
hw.check(ok == nil and why:find("No program is held", 1, true), tostring(why))
ok, why = c:run(1)
hw.check(ok == nil and why:find("There is no program 1 in the stored code", 1, true), tostring(why))
c.bench:input(4, true)
hw.check(c:input(4), "input 4 is on")

-- a program with a loop and a variable
hw.check(c:load([[
V1=0
WHILE V1<3
  X1000
  WAITX
  X0
  WAITX
  V1=V1+1
ENDWHILE
END
]]))
hw.check(c:run(0))
hw.sleep(0.5)
same(c:status().program, "running", "program")
hw.check(c:wait(120))
same(c:query("V1"), "3", "V1")
hw.check(c:program():find("ENDWHILE"), c:program())
