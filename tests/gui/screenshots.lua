-- Pictures of every panel in both themes: handwheel run --gui tests/gui/screenshots.lua FOLDER
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

pictures("connect")
local c = assert(hw.open("vxm@emulator"))
for m = 1, 2 do c:set("M" .. m .. "M", 4) end
c.bench:place(1, {minus = -4000, plus = 30000})
c:move_to{[1] = 12400, [2] = -2200}
c:wait(60)
ui.frame(10)

-- each tab of this controller, as the screen lists them
local tabs = {}
for _, w in ipairs(ui.list()) do
  local tab = w.id:match("^tab/([^/]+)$")
  if tab then tabs[#tabs + 1] = tab end
end
for _, tab in ipairs(tabs) do
  ui.click("tab/" .. tab)
  hw.sleep(0.3)
  pictures(tab)
end

-- a program at work
if ui.exists("tab/program") then
  ui.click("tab/program")
  ui.type("program/text", "; a slow stroke, five times\nS1M3000\nLM0\nI1M2400\nP5\nI1M-2400\nL5\n")
  ui.click("program/run")
  hw.sleep(1)
  pictures("program-running")
  c:halt()
  c:wait(20)
end

-- a hand on the jog pad
ui.press("jog/1/+")
hw.sleep(0.8)
ui.screenshot(folder .. "/jog-held-1440-dark.png")
ui.release("jog/1/+")
c:wait(20)

-- on the limit; the cable pulled
c:home(1, "-")
c:wait(120)
pictures("limit")
c.bench:unplug(true)
hw.sleep(2)
pictures("lost")
c.bench:unplug(false)
hw.sleep(6)

-- four motors, two controllers
local d = assert(hw.open("vxm@emulator,motors=4"))
hw.sleep(1)
pictures("four-axes")
if ui.exists("help") then
  ui.click("help")
  pictures("help")
end
