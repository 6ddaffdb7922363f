-- Pictures of what the second family shows, in both themes: handwheel run --gui tests/gui/screenshots_arcus.lua FOLDER
local folder = hw.args[1] or "."
local sizes = {{1440, 900, 1, "1440"}, {1024, 700, 1, "1024"}, {1440, 900, 2, "200"}}

local function pictures(name)
  for _, theme in ipairs{"dark", "light"} do
    ui.theme(theme)
    for _, size in ipairs(sizes) do
      ui.window(size[1], size[2], size[3])
      ui.frame(3)
      ui.screenshot(string.format("%s/%s-%s-%s.png", folder, name, size[4], theme))
    end
  end
  ui.theme("dark")
  ui.window(1440, 900, 1)
  ui.frame(2)
end

-- a table of four axes with a program at work
local c = assert(hw.open("pmx-4ex-sa@emulator"))
for _, axis in ipairs{"X", "Y", "Z", "U"} do c.bench:place(axis, {minus = -500000, plus = 500000}) end
hw.sleep(2)
ui.click("tab/program")
ui.type("program/text", table.concat({"; a square, again and again", "ABS", "HSPD=4000", "LSPD=200", "ACC=200", "WHILE 1=1",
  "  X8000Y0", "  WAITX", "  X8000Y8000", "  WAITX", "  X0Y8000", "  WAITX", "  X0Y0", "  WAITX", "  V50=V50+1",
  "ENDWHILE", "END", "PRG 1", "WHILE 1=1", "  V1=DI", "  DELAY=200", "ENDWHILE", "END", ""}, "\n"))
ui.frame(3)
pictures("arcus-program-text")
ui.click("program/download")
hw.sleep(5)
if ui.exists("program/ask/overwrite") then ui.click("program/ask/overwrite") hw.sleep(5) end
ui.click("thread/0/run")
ui.click("thread/1/run")
hw.sleep(2)
pictures("arcus-program")
ui.click("program/view")
ui.frame(3)
pictures("arcus-compiled")
ui.click("program/view")
for _, tab in ipairs{"control", "variables"} do
  ui.click("tab/" .. tab)
  hw.sleep(2)
  pictures("arcus-" .. tab)
end
c:halt()
c:stop()
c:wait(10)
ui.click("tab/list")
for n, row in ipairs{{0, 0}, {8000, 0}, {8000, 8000}, {0, 8000}, {0, 0}} do
  ui.click("list/add")
  ui.type("list/" .. n .. "/x", tostring(row[1]))
  ui.type("list/" .. n .. "/y", tostring(row[2]))
  ui.type("list/" .. n .. "/speed", "3000")
end
ui.click("list/start")
hw.sleep(1)
pictures("arcus-moves")
c:stop()
c:wait(10)
ui.click("tab/setup")
pictures("arcus-setup")

-- a bus of four, one of them without power
local bus = assert(hw.open("dmx-k-sa@emulator,id=01-04"))
hw.sleep(3)
bus.devices["02"]:move_by{[1] = 20000}
hw.sleep(1)
ui.click("tab/control")
pictures("arcus-bus")
bus.devices["03"].bench:limit(1, "+", true)
bus.devices["03"]:move_by{[1] = 20000}
hw.sleep(2)
pictures("arcus-bus-trouble")

ui.click("controller/new")
ui.frame(3)
pictures("arcus-connect")
