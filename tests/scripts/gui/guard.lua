-- The guard in the controller, under a hand: the badge says who ends a held jog, the guard is installed with consent,
-- stops the jog when the link is dead, and is taken away without a trace.
local function same(got, want, what)
  hw.check(got == want, ("%s: %s, not %s"):format(what, tostring(got), tostring(want)))
end

for _, kind in ipairs{{"pmx-4ex-sa@emulator", "EO=15"}, {"dmx-k-sa@emulator", "EO=1"}} do
  local address, power = table.unpack(kind)
  local c = assert(hw.open(address))
  assert(c:query(power))
  assert(c:set("TOC", 7000))
  ui.frame(10)
  hw.sleep(3)
  ui.frame(5)
  same(ui.value("jog/guarantee"), "ends it", address .. ": the emulator ends with this program")

  -- nothing is written before its user has said so
  ui.click("jog/guarantee")
  ui.frame(5)
  hw.check(ui.value("jog/guard/state"):find("The program memory is empty", 1, true), ui.value("jog/guard/state"))
  ui.click("jog/guard/close")
  ui.frame(5)
  same(c:query("SA0"), "", address .. ": closed without consent")
  ui.click("jog/guarantee")
  ui.frame(5)
  ui.click("jog/guard/install")
  hw.sleep(20)
  ui.frame(5)
  hw.check(ui.value("jog/guarantee"):find("a guess", 1, true), ui.value("jog/guarantee"))
  same(c:get("TOC"), 7000, address .. ": TOC after the guard was installed")

  -- a hand holds a jog, and the link dies
  local axis = "X"
  ui.press("jog/X/+")
  hw.sleep(1.5)
  hw.check(c:status(axis).moving, address .. ": it jogs")
  local speed, place = c:velocity(axis), c:position(axis)
  hw.check(speed > 100, address .. ": at " .. speed)
  c.bench:unplug(true)
  hw.sleep(6)
  ui.release("jog/X/+")
  c.bench:unplug(false)
  hw.sleep(12)
  local gone = c:position(axis) - place
  hw.check(gone > 0.4 * speed, ("%s: it went on for %d, the guard waits half a second"):format(address, gone))
  hw.check(gone < 1.6 * speed, ("%s: it went on for %d, at %d a second"):format(address, gone, speed))
  same(c:get("TOC"), 7000, address .. ": TOC after the jog")

  -- taken away
  ui.click("jog/guarantee")
  ui.frame(5)
  hw.check(ui.value("jog/guard/state"):find("The guard is installed", 1, true), ui.value("jog/guard/state"))
  ui.click("jog/guard/remove")
  hw.sleep(20)
  ui.frame(5)
  same(c:query("SA0"), "", address .. ": the program memory")
  same(c:get("TOC"), 7000, address .. ": TOC after all")
  same(ui.value("jog/guarantee"), "ends it", address .. ": the badge")
end
