-- No line of the text is named for a program that somebody else has written into the controller meanwhile.
ui.window(1440, 900)
local function status(word, what)
  local said = ui.value("status/text")
  hw.check(said:find(word, 1, true), what .. ": " .. said)
end
local text = "V1=0\nDELAY=30000\nV2=7\nEND\n"
local other = "X100\nV3=1\nDELAY=30000\nV4=1\nEND\n"
local neighbour_writes = {
  {"a script", function(c) assert(c:load(other, 0)) end},
  {"raw text", function(c) hw.check(c:query("SA0=" .. c:query("SA0")) == "OK") end},
}
for _, model in ipairs{"pmx-4ex-sa", "dmx-k-sa"} do
  for _, way in ipairs(neighbour_writes) do
    local what = model .. ", " .. way[1]
    local c = assert(hw.open(model .. "@emulator"))
    hw.sleep(1)
    ui.type("program/text", text)
    hw.sleep(0.3)
    ui.click("program/run")
    hw.sleep(1.5)
    status("Program 0 is running in line 2.", what)
    hw.check(ui.value("thread/0/source") == "2 DELAY=30000", what .. ": its row")
    c:halt()
    hw.sleep(0.5)

    way[2](c)
    hw.sleep(0.5)
    ui.click("thread/0/run")
    hw.sleep(1.5)
    status(("Program 0 is running at line %s of its stored code."):format(c:query("SPC0")), what .. ", afterwards")
    hw.check(not ui.exists("thread/0/source"), what .. ": its row names no line of the text")
    c:halt()
    hw.sleep(0.5)
  end
end

-- A text that changes nothing leaves it known, and so does a wire that is gone for a while under a running program.
local c = assert(hw.open("pmx-4ex-sa@emulator"))
hw.sleep(1)
ui.type("program/text", text)
hw.sleep(0.3)
ui.click("program/run")
hw.sleep(1.5)
ui.type("terminal/command", "PX\n")
hw.sleep(0.5)
status("Program 0 is running in line 2.", "after a question")
c.bench:unplug(true)
hw.sleep(4)
c.bench:unplug(false)
hw.sleep(10)
status("Program 0 is running in line 2.", "after the wire was gone")
c:halt()
hw.sleep(1)
ui.click("thread/0/run")
hw.sleep(1.5)
status("Program 0 is running at line", "the next run")

-- Where it stands in a loop that only waits.
c = assert(hw.open("pmx-4ex-sa@emulator"))
hw.sleep(1)
ui.type("program/text", "WHILE DI1=0\nDELAY=900\nENDWHILE\nEND\n")
hw.sleep(0.3)
ui.click("program/run")
hw.sleep(1)
local in_delay = 0
for _ = 1, 20 do
  hw.sleep(0.37)
  if ui.value("thread/0/source") == "2 DELAY=900" then in_delay = in_delay + 1 end
end
hw.check(in_delay >= 18, "in the DELAY: " .. in_delay)
