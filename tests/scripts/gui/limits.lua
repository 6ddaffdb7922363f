-- Limits, units, places and backlash as a user sets them in the window, on every controller.
ui.window(1440, 900)

local function say(...) return string.format(...) end
local function same(got, want, what)
  hw.check(got == want, say("%s: got %s, want %s", what, tostring(got), tostring(want)))
end
local function has(text, words, what)
  hw.check(tostring(text):find(words, 1, true), say("%s: %q has no %q", what, tostring(text), words))
end
local function told(words)
  for _, w in ipairs(ui.list()) do
    if w.id:find("^toast/") and tostring(w.value):find(words, 1, true) then return true end
  end
  return false
end
local function choose(dropdown, label)
  ui.click(dropdown)
  ui.frame(2)
  for _, w in ipairs(ui.list()) do
    if w.id:find(dropdown .. "/", 1, true) == 1 and w.label == label then return ui.click(w.id) end
  end
  error(dropdown .. " has no " .. label)
end

local kinds = {
  {address = "vxm@emulator", axis = "1", text = "I1M%d,R"},
  {address = "pmx-4ex-sa@emulator", axis = "X", power = "EO=15", text = "X%d", absolute = true},
  {address = "dmx-k-sa@emulator", axis = "X", power = "EO=1", text = "X%d", absolute = true, counts = true},
  {address = "vme58@emulator", axis = "X", text = "AX MR%d GO", counts = true},
}
for _, k in ipairs(kinds) do
  local axis, what = k.axis, k.address
  local c = hw.check(hw.open(k.address))
  if k.axis == "1" then c:set("M1M", 4) end
  if k.power then hw.check(c:query(k.power)) end
  hw.sleep(1)

  -- 200 full steps, 2 micro steps each, or 400 counts: one turn goes 1 mm
  ui.click("dro/unit")
  choose("dro/unit/axis/" .. axis, "another conversion")
  ui.frame(2)
  local micro = ui.exists(say("dro/unit/own/%s/micro", axis))  -- an encoder has counts a turn
  same(not micro, k.counts or false, what .. ": micro steps")
  ui.type(say("dro/unit/own/%s/full", axis), micro and "200\n" or "400\n")
  if micro then ui.type(say("dro/unit/own/%s/micro", axis), "2\n") end
  ui.type(say("dro/unit/own/%s/travel", axis), "1\n")
  ui.frame(2)
  ui.click(say("dro/unit/own/%s/drive", axis))
  ui.key("Escape")
  ui.key("Escape")
  hw.sleep(0.5)
  same(ui.value(say("dro/%s/position", axis)), "0.000", what)

  ui.click(say("dro/%s/position", axis))
  ui.type(say("dro/%s/limit/-", axis), "-2\n")
  ui.type(say("dro/%s/limit/+", axis), "10\n")
  ui.key("Escape")
  hw.sleep(0.3)
  same(ui.value(say("dro/%s/travel", axis)), "-2.000 to 10.000 mm", what)
  same(c:limits(axis).plus, 4000, what)

  -- a held jog is a move to the limit, and ends there while it is still held
  ui.click("jog/speed/number")
  ui.frame(2)
  local by_axis = ui.exists("jog/speed/" .. axis)
  ui.type(by_axis and "jog/speed/" .. axis or "jog/speed/field", "5\n")
  ui.key("Escape")
  ui.frame(2)
  ui.press(say("jog/%s/+", axis))
  hw.sleep(1)
  hw.check(ui.exists(say("dro/%s/stop", axis)), what .. ": where it would stop now")
  hw.sleep(5)
  ui.release(say("jog/%s/+", axis))
  hw.sleep(0.5)
  same(c:position(axis), 4000, what .. ": the controller ended the jog")
  for _, w in ipairs(ui.list()) do
    if w.id == say("jog/%s/+", axis) then hw.check(not w.enabled, what .. ": only the way back is left") end
  end

  -- refused with the rule and by how much, with a button for the nearest that is allowed
  ui.type("goto/" .. axis, "12\n")
  hw.sleep(0.5)
  has(ui.value(say("goto/%s/refused", axis)), "12.000 mm lies 2.000 mm past the + limit of", what)
  ui.type("goto/" .. axis, "9.5\n")
  hw.sleep(1)
  hw.check(c:wait(30))
  ui.click("jog/step/1")
  ui.click(say("jog/%s/+", axis))
  hw.sleep(0.5)
  has(ui.value(say("jog/%s/refused", axis)), "10.500 mm lies 0.500 mm past the + limit of", what)
  ui.click(say("jog/%s/nearest", axis))
  hw.sleep(1)
  hw.check(c:wait(30))
  same(c:position(axis), 4000, what .. ": the nearest place")

  -- a text goes anyway, and is warned about in the unit of the axis
  ui.type("terminal/command", say(k.text, k.absolute and 4600 or 600) .. "\n")
  hw.sleep(0.2)
  hw.check(told("This text moves past a limit: 11.500 mm lies 1.500 mm past the + limit of"), what)
  hw.sleep(3)
  hw.check(c:wait(30))
  hw.check(told("has passed its + limit, 10.000 mm: nothing ends this motion there."), what)

  -- moving back inside is always allowed, also to a place still outside
  ui.type("goto/" .. axis, "11\n")
  hw.sleep(1)
  hw.check(c:wait(30))
  same(c:position(axis), 4400, what)

  -- a place is saved, gone to and changed; one outside offers the nearest inside
  ui.click("places")
  ui.type("places/name", "far\n")
  ui.key("Escape")
  ui.type("goto/" .. axis, "1\n")
  hw.sleep(1)
  hw.check(c:wait(30))
  ui.click("places")
  ui.click("places/far/go")
  hw.sleep(0.5)
  local first = axis
  has(ui.value(say("goto/%s/refused", first)), "11.000 mm lies 1.000 mm past the + limit of", what)
  ui.click(say("goto/%s/nearest", first))
  hw.sleep(1)
  hw.check(c:wait(60))
  same(c:position(axis), 4000, what .. ": the nearest to the place")
  ui.click("places")
  ui.click("places/far/edit")
  ui.type("places/far/" .. axis, "2\n")
  ui.click("places/far/go")
  hw.sleep(1)
  hw.check(c:wait(60))
  same(c:position(axis), 800, what .. ": the place as it was changed")

  -- backlash: every move ends upwards
  ui.click(say("dro/%s/position", axis))
  ui.type(say("dro/%s/backlash", axis), "0.5\n")
  ui.key("Escape")
  hw.sleep(0.3)
  local low = 800
  ui.type("goto/" .. axis, "1\n")
  for _ = 1, 40 do
    hw.sleep(0.1)
    low = math.min(low, c:position(axis))
  end
  hw.check(c:wait(30))
  same(c:position(axis), 400, what)
  hw.check(low <= 220, what .. ": it came from below, " .. low)
  ui.click(say("dro/%s/position", axis))
  ui.type(say("dro/%s/backlash", axis), "0\n")
  ui.key("Escape")
end
