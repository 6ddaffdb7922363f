-- Pictures of the panels of a board in a memory window: build/handwheel run --gui tests/gui/screenshots_board.lua FOLDER
-- [PART-OF-A-NAME [dark|light]]. What was seen in them: PICTURES.md.
require("lib.pictures")
local with_200 = {wide, medium, narrow}
local c = assert(hw.open("vme58@emulator"))
hw.sleep(1)
pictures("board-idle", function() tab("program") end, nil, in_all)
ui.type("program/text", "AA MT125000,-18240,,,,-33000000; GO\nAZ MA-12000 GO WT5 MR400 GO MR-400 GO\nAX WT2 MR4000 GO MR-4000 GO\n")
ui.click("program/run")
hw.sleep(1)
aside()
pictures("board-program", function() tab("program") end, nil, in_all)
pictures("board-right", open_right, close_right)
pictures("board-jog", function() tab("jog") end, nil, {narrow})
pictures("board-control", function() tab("control") hw.sleep(0.5) end, nil, with_200)
pictures("board-setup", function() tab("setup") hw.sleep(0.5) end)
c:halt()
c:stop()
c:wait(20)
c.bench:limit("U", "-", true)
c:send("AX MA125000 GO")
c:send("AZ JG2000")
hw.sleep(1)
pictures("board-memory", function() tab("memory") hw.sleep(0.5) end, nil, with_200)
c:stop()
c:wait(20)

c.bench:place("Y", {motor = true})
c:send("AY LP40000 VL1000000 AC8000000 HN KP2 KD0")
hw.sleep(0.5)
tab("tuning")
ui.click("tuning/axis") ui.click("tuning/axis/Y")
ui.type("tuning/step", "400")
ui.type("tuning/length", "230")
for _, gains in ipairs{"KP2 KD3", "KP2 KD8"} do
  c:send("AY " .. gains)
  hw.sleep(0.5)
  ui.click("tuning/record")
  hw.sleep(1)
end
ui.type("tuning/KDY", "9\n")
pictures("board-tuning", function() tab("tuning") end, nil, with_200)

pictures("board-contour", function()
  tab("contour")
  if not ui.exists("contour/2/x") then
    ui.click("contour/add/output")
    for _, arc in ipairs{{0, 5000, 180}, {0, 0, 360}} do
      ui.click("contour/add/arc")
      local n = arc[2] == 5000 and 2 or 3
      ui.type("contour/" .. n .. "/x", tostring(arc[1]))
      ui.type("contour/" .. n .. "/y", tostring(arc[2]))
      ui.type("contour/" .. n .. "/angle", tostring(arc[3]))
    end
    ui.click("contour/add/output")
    ui.click("contour/add/line")
    ui.type("contour/5/x", "-2000")
    ui.type("contour/5/y", "10000")
    ui.type("contour/lead_in", "1500")
  end
end, nil, with_200)
pictures("board-staircase", function()
  tab("contour")
  ui.click("contour/kind/Staircase")
  if not ui.exists("stairs/1/until") then
    for n, step in ipairs{{60000, 1000}, {90000, 4000}, {120000, 2000}} do
      ui.click("stairs/add")
      ui.type("stairs/" .. n .. "/until", tostring(step[1]))
      ui.type("stairs/" .. n .. "/speed", tostring(step[2]))
    end
    ui.type("stairs/stop", "125000")
    ui.click("stairs/axis") ui.click("stairs/axis/Z")
  end
end)
