-- Somebody else writes another program into the controller: Run does not take it for the text on the screen.
local moves = "EO=1\nINC\nX%d\nWAITX\nEND"
local families = {
  {"vxm@emulator", 1, "I1M%d", true},
  {"pmx-4ex-sa@emulator", "X", moves, true},
  {"dmx-k-sa@emulator", 1, moves, true},
  {"vme58@emulator", "X", "AX MR%d GO ID", false},  -- keeps no programs: Run sends the text each time
}
for _, family in ipairs(families) do
  local address, axis, text, kept = table.unpack(family)
  local c = assert(hw.open(address))
  hw.sleep(0.5)
  local function run_and_wait()
    ui.click("program/run")
    hw.sleep(0.5)
    c:wait(10)
    hw.sleep(0.3)
  end
  ui.type("program/text", text:format(400))
  hw.sleep(0.3)
  run_and_wait()
  hw.check(c:position(axis) == 400, address .. " ran the text")
  hw.check(c:load(text:format(-400), 0))
  hw.sleep(1)
  run_and_wait()
  if kept then
    hw.check(ui.exists("program/ask/overwrite"), address .. " asks")
    hw.check(c:position(axis) == 400, address .. " moved nothing meanwhile")
    ui.click("program/ask/overwrite")
    hw.sleep(0.5)
    c:wait(10)
    hw.sleep(0.3)
  end
  hw.check(c:position(axis) == 800, address .. " ran the text again: " .. c:position(axis))
end
