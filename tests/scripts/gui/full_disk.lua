-- Everything that the window writes where a hand says, onto a disk that is full: each says so in a sentence, and what was
-- to be saved stays as it is. command_line.py makes the folder: its files are links to a full device.
require("lib.checklist")
local folder = hw.args[1]
ui.window(1440, 900)
local c = assert(hw.open("pmx-4ex-sa@emulator"))
assert(c:query("EO=15"))

local function fails(what, ending, opens)
  block(what, function()
    opens()
    file(folder .. "/full" .. ending)
    said("full" .. ending .. " was not written: the disk is full.")
    must(said("Free some space"), "what to do")
  end)
end

fails("traffic", ".log", function()
  tab("control")
  if ui.exists("terminal/save") then ui.click("terminal/save") else choose("terminal/log_menu", "Save") end
end)
fails("set-up", ".toml", function()
  tab("setup")
  ui.click("setup/save")
end)
fails("list of moves", ".moves", function()
  tab("list")
  ui.click("list/add")
  ui.click("list/save")
end)
fails("blocks", ".toml", function()
  tab("blocks")
  ui.type("blocks/add_by_name", "Delay\n")
  ui.click("blocks/save")
end)
local text = "PRG 0\nX1000\nWAITX\nEND"
fails("program", ".prg", function()
  tab("program")
  write_program(text)
  ui.click("program/save")
end)
block("the text is kept", function() shows("program/text", "X1000") end)
for _, ending in ipairs{".svg", ".png"} do
  fails("path " .. ending, ending, function()
    tab("path")
    if ui.exists("path/simulate") then ui.click("path/simulate") end
    hw.sleep(1)
    ui.click("path/save")
  end)
end
local ok, why = pcall(ui.screenshot, folder .. "/full.png")
hw.check(not ok and why:find("the disk is full", 1, true), "a picture: " .. tostring(why))
over()
