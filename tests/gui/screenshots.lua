-- Pictures of every panel and state, to be looked at:
--   build/handwheel run --gui tests/gui/screenshots.lua FOLDER [PART-OF-A-NAME [dark|light]]
-- FOLDER/STATE-SIZE-THEME.png, at 1440x900, at 1024x700 (medium), at 200 % in a window of 1440x900 pixels
-- (narrow), and a few at 200 % in one of 2880x1800 (wide).
local folder, wanted, only = hw.args[1] or ".", hw.args[2] or "", hw.args[3]
local wide = {1440, 900, 1, "1440"}
local sizes = {wide, {1024, 700, 1, "1024"}, {720, 450, 2, "narrow200"}}
local with_200 = {wide, sizes[2], sizes[3], {1440, 900, 2, "wide200"}}

local function window(size)
  ui.window(size[1], size[2], size[3])
  ui.frame(3)
end

local function pictures(name, of)
  if not name:find(wanted, 1, true) then return end
  for _, theme in ipairs{"dark", "light"} do
    if not only or only == theme then
      ui.theme(theme)
      for _, size in ipairs(of or sizes) do
        window(size)
        ui.screenshot(string.format("%s/%s-%s-%s.png", folder, name, size[4], theme))
      end
    end
  end
  ui.theme("dark")
  window(wide)
end
local function picture(name) pictures(name, {wide}) end

-- A state that needs hands at each size: `make` does it, `undo` takes it back.
local function by_hand(name, make, undo, of)
  if not name:find(wanted, 1, true) then return end
  for _, theme in ipairs{"dark", "light"} do
    if not only or only == theme then
      ui.theme(theme)
      for _, size in ipairs(of or sizes) do
        window(size)
        local done, why = pcall(make)
        if not done then print(string.format("%s at %s: %s", name, size[4], why)) end
        ui.frame(3)
        ui.screenshot(string.format("%s/%s-%s-%s.png", folder, name, size[4], theme))
        pcall(undo)
        ui.frame(2)
      end
    end
  end
  ui.theme("dark")
  window(wide)
end
local function escape() ui.key("Escape") ui.frame(2) end
local function tab(name) if ui.exists("tab/" .. name) then ui.click("tab/" .. name) end end
-- The mouse where it explains nothing.
local function aside() ui.click(ui.exists("tab/program") and "tab/program" or "page/connect") ui.frame(2) end

-- ---- without a controller
pictures("connect", with_200)
ui.type("connect/address", "vxm@serial\n")
pictures("connect-refused")
ui.click("help")
pictures("help", with_200)
ui.click("help/back")

-- ---- a controller as the factory sends it
local c = assert(hw.open("vxm@emulator,wire=real"))
hw.sleep(1)
pictures("motor-type-0")
for m = 1, 2 do c:set("M" .. m .. "M", 4) end
c.bench:place(1, {minus = -4000, plus = 60000})
c.bench:place(2, {minus = -4000, plus = 20000})
hw.sleep(1)
aside()
pictures("program-empty")

-- ---- as its user likes to see it
local function choose(list, choice)
  ui.click(list)
  ui.frame(2)
  ui.click(list .. "/" .. choice)
  ui.frame(2)
end
by_hand("units", function() tab("jog") ui.click("dro/unit") end, escape)
ui.click("dro/unit")
for m = 1, 2 do choose("dro/unit/axis/" .. m, "UniSlide K1, Q1 or BiSlide M01: 1 mm a turn") end
escape()
ui.click("menu")
ui.click("menu/names")
ui.type("names/controller", "VXM stage")
ui.type("names/1", "across")
ui.type("names/2", "rows")
by_hand("names", function() end, function() end)
ui.click("names/ok")
by_hand("menu", function() ui.click("menu") end, escape)
by_hand("axis-menu", function() ui.click("dro/1/position") end, escape)

-- ---- the program
local plate_scan = [[
; plate scan: 20 rows, camera flash on output 1
S1M2000, A1M2       ; across at 5 mm/s
S2M1000             ; rows at 2.5 mm/s
IA1M0               ; start at the left edge
LM0                 ; each row from here
I1M4800             ; across, 12 mm
PA5                 ; flash 0.5 s
I2M400              ; next row, 1 mm
L-20                ; 20 rows, back and forth]]
tab("program")
ui.type("program/text", plate_scan)
hw.sleep(0.5)
aside()
pictures("program-text")
ui.click("program/simulate")
hw.sleep(1)
aside()
pictures("program-rehearsed", with_200)
if ui.exists("rehearsal/expand") then
  by_hand("rehearsal-open", function() ui.click("rehearsal/expand") end, function() ui.click("rehearsal/expand") end)
end
by_hand("rehearsal-open", function() if ui.exists("rehearsal/expand") then ui.click("rehearsal/expand") end end,
        function() if ui.exists("rehearsal/expand") then ui.click("rehearsal/expand") end end, {sizes[2], sizes[3]})
by_hand("program-more", function() tab("program") ui.click("program/more") end, escape)
by_hand("program-find", function() tab("program") ui.click("program/text") ui.key("Ctrl+F") ui.type("program/text/find", "M4") end, escape)
by_hand("file-open", function() tab("program") ui.click("program/open") end, escape)
by_hand("file-save", function() tab("program") ui.click("program/save") end, escape)
ui.click("program/run")
hw.sleep(9)
aside()
pictures("program-running", with_200)
ui.type("program/text", "\nS2M8000")
hw.sleep(0.3)
pictures("program-running-edited", with_200)
ui.click("program/hold")
hw.sleep(4)
aside()
pictures("program-held")
c:halt()
c:wait(20)
ui.click("program/slot/1")
ui.type("program/text", "S1M2000\nI1Q400\nI2M9999999999\nU3,U200\nL0\n")
hw.sleep(0.5)
aside()
pictures("program-errors")
ui.click("program/slot/2")
ui.type("program/text", string.rep("I1M400,I2M400,P5,U4,I1M-400,I2M-400,P5,U5\n", 12))
hw.sleep(0.5)
aside()
pictures("program-too-long")
c:load("I1M100,P5,I1M-100", 3)
ui.click("program/slot/3")
ui.type("program/text", "I1M200")
ui.click("program/run")
hw.sleep(1)
aside()
pictures("program-replace")
ui.click("program/ask/leave")
ui.click("program/slot/0")

-- ---- the set-up
tab("setup")
ui.frame(5)
hw.sleep(1)
pictures("setup", with_200)
ui.type("setup/Bx", "20\n")
ui.type("setup/filter", "speed")
hw.sleep(0.2)
pictures("setup-search")
ui.type("setup/filter", "")
ui.click("setup/show/Changed")
pictures("setup-changed")
ui.click("setup/show/All")
ui.click("setup/M2M")
ui.frame(2)
by_hand("setup-choice", function() end, function() end, {wide})
ui.click("setup/M2M/" .. (function()
  for _, w in ipairs(ui.list()) do if w.id:match("^setup/M2M/5") then return w.id:sub(11) end end
  error("no choice 5")
end)())
ui.click("setup/write")
by_hand("setup-confirm", function() end, function() end)
ui.click("setup/confirm/no")

-- ---- the terminal
tab("program")
ui.type("terminal/command", "getM1M\n")
hw.sleep(0.3)
by_hand("terminal-completion", function() tab("terminal") ui.type("terminal/command", "S") ui.key("Tab") end,
        function() escape() ui.type("terminal/command", "") end)
by_hand("terminal-hint", function() tab("terminal") ui.type("terminal/command", "I1M4000,R") end,
        function() ui.type("terminal/command", "") escape() end)
by_hand("terminal-traffic", function() tab("terminal") end, function() end)

-- ---- hands
by_hand("goto-refused", function() tab("jog") ui.type("goto/1", "99999999\n") end, function() ui.type("goto/1", "") end)
tab("program")
c:move_to{[1] = 4000, [2] = 2000}
c:wait(60)
by_hand("jog-held", function() tab("jog") ui.press("jog/1/+") hw.sleep(0.8) end,
        function() ui.release("jog/1/+") c:wait(20) end, with_200)
c.bench:limit(1, "-", true)
c:home(2, "-")
c:wait(120)
hw.sleep(7)
pictures("limit")
c.bench:limit(1, "-", false)
by_hand("rail-open", function() if ui.exists("rail/open") then ui.click("rail/open") else tab("io") end end,
        function() if ui.exists("rail/open") then ui.click("rail/open") end end)

-- ---- trouble
c.bench:garble(4)
hw.sleep(1)
picture("garbled")
c:home(2, "+")
hw.sleep(0.5)
c.bench:unplug(true)
hw.sleep(0.8)
pictures("stale")
hw.sleep(3)
pictures("lost", with_200)
c.bench:unplug(false)
hw.sleep(6)
pictures("back")

-- ---- several controllers
local d = assert(hw.open("vxm@emulator,motors=4,wire=real"))
hw.sleep(1)
for m = 1, 4 do d:set("M" .. m .. "M", 4) end
d:move_to{[1] = 12400, [2] = -2200, [3] = 180, [4] = 99000}
hw.sleep(0.5)
pictures("four-axes", with_200)
by_hand("controllers", function() if ui.exists("controller/menu") then ui.click("controller/menu") end end, escape, {sizes[3]})
ui.click("menu")
ui.click("menu/close")
by_hand("close-moving", function() end, function() end)
ui.click("close/cancel")
ui.click("menu")
ui.click("menu/reset")
by_hand("reset", function() end, function() end)
ui.click("reset/cancel")
