-- What the console says of stored programs: the source line of one that is in error while others run, and code that
-- means nothing here.
local c = assert(hw.open("pmx-4ex-sa@emulator"))
ui.window(1440, 900)
hw.sleep(1)
local function has(id, part)
  local said = ui.value(id)
  assert(said:find(part, 1, true), ("%s says %q, not %q"):format(id, said, part))
end
local function hasnt(id, part)
  local said = ui.value(id)
  assert(not said:find(part, 1, true), ("%s says %q"):format(id, said))
end

ui.type("program/text", table.concat({"PRG 0", "WHILE 1=1", "DELAY=100", "ENDWHILE", "END", "PRG 1", "V1=0", "  V2=5/V1",
  "END", ""}, "\n"))
hw.sleep(0.5)
ui.click("program/download")
hw.sleep(3)
ui.click("thread/0/run")
ui.click("thread/1/run")
hw.sleep(3)
has("status/text", "Program 1 stopped with an error in line 8: V2=5/V1.")
has("status/text", "Program 0 is running")
ui.click("thread/1/stop")
hw.sleep(2)
hasnt("status/text", "error")
ui.click("thread/0/stop")
hw.sleep(2)

-- the line is named as the controller tells it where the text is not what it holds
c:query("SA0=GARBAGE")
hw.sleep(1)
ui.click("program/upload")
hw.sleep(3)
hasnt("program/note", "same program")
has("program/note", "cannot be read here")
assert(c:query("SA0") == "GARBAGE")
-- and it is not overwritten without asking
ui.click("program/download")
hw.sleep(3)
assert(ui.exists("program/ask/overwrite"))
ui.click("program/ask/leave")
