-- A rehearsal begins from the controller as it is: each kind of state is changed there, and the rehearsal of the same
-- text changes with it. On each controller; that it is also what the run does, the agreement tests show.
local open = {vxm = "vxm@emulator", pmx = "pmx-4ex-sa@emulator", dmx = "dmx-k-sa@emulator", vme58 = "vme58@emulator"}

local function rehearsed(c, text)
  local r = hw.check(c:rehearse(text))
  hw.check(r.finished, r.error)
  return r
end
-- `change` makes another value of `look` out of the same text.
local function follows(c, what, text, look, change, wanted)
  local before = look(rehearsed(c, text))
  change()
  hw.sleep(0.5)
  local after = look(rehearsed(c, text))
  hw.check(before ~= after, what .. ": it stays " .. tostring(before))
  hw.check(wanted == nil or after == wanted, what .. ": " .. tostring(after) .. ", expected " .. tostring(wanted))
end
local function duration(r) return math.floor(r.duration * 1000 + 0.5) end
local function at(axis) return function(r) return r.axes[axis].position end end
local function out(n) return function(r) return r.outputs[n] end end

-- ---- one program of several, motors in turn
local c = hw.check(hw.open(open.vxm))
for m = 1, 2 do hw.check(c:set("M" .. m .. "M", 4)) end
follows(c, "position", "IA1M1000\n", duration, function() hw.check(c:move_to{[1] = 600} and c:wait(30)) end)
follows(c, "parameter", "IA1M0\n", function(r) return r.axes[1].min end, function() hw.check(c:set("Bx", 9)) end, -9)
follows(c, "input", "U11,I2M77\n", at(2), function() c.bench:input(1, true) end)
follows(c, "output", "I2M10\n", out(1), function() hw.check(c:output(1, true)) end, true)
hw.check(c:load("I2M44", 2))
follows(c, "stored program", "JM2\n", at(2), function() hw.check(c:load("I2M55", 2)) end, 55)

-- ---- programs with variables
for _, model in ipairs{"pmx", "dmx"} do
  local a = hw.check(hw.open(open[model]))
  local power = model == "pmx" and "EO=15\n" or "EO=1\n"
  if model == "dmx" then hw.check(a:set("SL", 0)) end
  hw.sleep(0.5)
  local move = power .. "ABS\nX1000\nWAITX\nEND\n"
  follows(a, "parameter", move, duration, function() hw.check(a:set(model == "pmx" and "HS" or "HSPD", 400)) end)
  follows(a, "position", move, duration, function() hw.check(a:query(power:sub(1, -2)) and a:move_to{X = 600} and a:wait(30)) end)
  follows(a, "variable", power .. "XV7\nWAITX\nEND\n", at("X"),
          function() hw.check(a:query("V7=321")) end, 321)
  follows(a, "input", power .. "IF DI2=1\nX77\nELSE\nX88\nENDIF\nWAITX\nEND\n", at("X"), function() a.bench:input(2, true) end)
  follows(a, "output", power .. "X10\nWAITX\nEND\n", out(2), function() hw.check(a:output(2, not a:output(2))) end)
  local r = rehearsed(a, "PRG 0\nSR1=1\nEND\nPRG 1\n" .. power .. "ABS\nX5\nWAITX\nEND\n")
  hw.check(r.axes.X.position == 5, "the program that the first one starts")
end

-- ---- a board that stores nothing: what it runs is what waits in its queues
local b = hw.check(hw.open(open.vme58))
local move = "AX VL5000 AC50000\nMA10000 GO ID\n"
follows(b, "position", move, duration, function() hw.check(b:move_to{X = 6000} and b:wait(30)) end)
-- The text names no speed: those that are set up count.
local slow = "AX MA2000 GO ID\nMA6000 GO ID\n"
follows(b, "speed", slow, duration, function() hw.check(b:set("VLX", 2500)) end)
follows(b, "acceleration", slow, duration, function() hw.check(b:set("ACX", 12500)) end)
follows(b, "base speed", slow, duration, function() hw.check(b:set("VBX", 900)) end)
follows(b, "ramp", slow, duration, function() hw.check(b:set("PN", 3)) end)
follows(b, "other axis", "AY MR500 GO ID\n", at("Y"), function() hw.check(b:query("AY LP-40")) end, 460)
-- A line that is low makes SW wait.
local waits = "AX SW1 MR100 GO ID\n"
hw.check(rehearsed(b, waits).duration < 1)
b.bench:input(1, true)
hw.sleep(0.5)
hw.check(not hw.check(b:rehearse(waits)).finished, "nobody lets go of it")
b.bench:input(1, false)
hw.sleep(0.5)
for _, o in ipairs{8, 13, 14, 21} do -- the last two are auxiliary
  local was = out(o)(rehearsed(b, "AX MR10 GO ID\n"))
  follows(b, "output " .. o, "AX MR10 GO ID\n", out(o), function() hw.check(b:output(o, not was)) end, not was)
end
-- What its queues say it does not tell: that is named.
b:send("AX WT5000")
b:send("AX MR1000 GO ID")
hw.sleep(0.5)
local named = hw.check(b:rehearse("AY MR100 GO ID\n")).assumptions
hw.check(named["queue of X"] and named["queue of X"]:find("empty, since the board does not report", 1, true), "the queue")
