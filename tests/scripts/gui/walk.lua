-- A technician's way through the console, button by button: units, names, program, set-up, terminal, bench, several
-- controllers. What a button promises is looked up on the screen and on the controller.
local folder = hw.args[1] or "."
local c = assert(hw.open("vxm@emulator"))
hw.sleep(0.5)

local function toast(words)
  for _, w in ipairs(ui.list()) do
    if w.id:match("^toast/") and w.value:find(words, 1, true) then return true end
  end
  return false
end
local function label(id)
  for _, w in ipairs(ui.list()) do if w.id == id then return w.label end end
end
local function enabled(id)
  for _, w in ipairs(ui.list()) do if w.id == id then return w.enabled end end
end
local function row(list, words)
  for _, w in ipairs(ui.list()) do
    if w.id:sub(1, #list + 1) == list .. "/" and w.label:find(words, 1, true) then return w.id end
  end
  error("no row " .. words .. " in " .. list)
end

-- ---- motor type 0 is said before the first move, with the way to Setup
hw.check(ui.exists("fault/setup"), "the banner has a way to Setup")
hw.check(ui.value("fault/unset"):find("motor 1", 1, true), ui.value("fault/unset"))
ui.click("fault/setup")
ui.frame(3)
hw.check(ui.exists("setup/M1M"), "Setup is in front")

-- ---- a motor type: chosen, confirmed by name, written, marked as not stored
for m = 1, 2 do
  ui.click("setup/M" .. m .. "M")
  ui.frame(2)
  hw.check(not pcall(row, "setup/M" .. m .. "M", "not read"), "nothing can be chosen that is no value")
  ui.click(row("setup/M" .. m .. "M", "4: Slo-Syn M063"))
end
ui.click("setup/write")
ui.frame(2)
ui.click("setup/confirm/yes")
hw.sleep(2)
hw.check(c:get("M1M") == 4 and c:get("M2M") == 4, "both types were written")
hw.check(ui.exists("status/unsaved"), "what is in RAM only is marked")
ui.click("setup/store")
hw.sleep(1)
hw.check(toast("Stored in the controller. 1 of 100000 writes used."), "that it was stored is said, and how often")
hw.check(not ui.exists("status/unsaved"), "nothing is unsaved any more")

-- ---- search, show, undo of one value
ui.type("setup/filter", "backlash")
ui.frame(2)
hw.check(ui.exists("setup/Bx") and not ui.exists("setup/M1M"), "the search narrows the list")
ui.type("setup/Bx", "20\n")
hw.check(label("setup/write") == "Write 1 change", label("setup/write"))
ui.click("setup/Bx/was")
hw.check(not enabled("setup/write"), "nothing to write any more")
ui.type("setup/filter", "")

-- ---- units: what hangs on an axis, per axis, also turned round
ui.click("tab/program")
ui.click("dro/unit")
ui.frame(2)
ui.click("dro/unit/axis/1")
ui.frame(2)
ui.click(row("dro/unit/axis/1", "UniSlide K1"))
ui.frame(2)
ui.click("dro/unit/axis/2")
ui.frame(2)
ui.click(row("dro/unit/axis/2", "Rotary table B5990"))
ui.frame(2)
ui.key("Escape")
hw.sleep(0.3)
c:move_to{[1] = 400, [2] = 9000}
c:wait(60)
hw.sleep(0.3)
hw.check(ui.value("dro/1/position") == "1.000", "1 mm: " .. ui.value("dro/1/position"))
hw.check(ui.value("dro/2/position") == "90.00", "90 degrees: " .. ui.value("dro/2/position"))
ui.type("goto/1", "2,5\n")
c:wait(30)
hw.check(c:position(1) == 1000, "2.5 mm are 1000 steps: " .. c:position(1))
ui.click("dro/1/position")
ui.frame(2)
ui.type("dro/1/set", "0\n")
hw.sleep(0.5)
hw.check(c:position(1) == 0, "it stands at 0 now")

-- ---- names
ui.click("menu")
ui.click("menu/names")
ui.type("names/controller", "Stage")
ui.type("names/1", "across")
ui.click("names/ok")
ui.frame(2)
hw.check(label("controller/1") == "Stage", label("controller/1"))

-- ---- the program: typed, find, comment, undo, run, live line, hold, step
ui.type("program/text", "S1M2000\nLM0\nI1M2000\nP5\nI1M-2000\nL4")
ui.click("program/more")
ui.frame(2)
ui.click("program/more/Find")
ui.frame(2)
ui.type("program/text/find", "M2000")
hw.check(ui.exists("program/text/find"), "the find bar is open")
ui.key("Escape")
ui.frame(2)
ui.click("program/simulate")
hw.sleep(0.5)
hw.check(ui.value("rehearsal/result"):find("s", 1, true), "a time: " .. ui.value("rehearsal/result"))
ui.click("program/run")
hw.sleep(3)
hw.check(ui.value("program/live"):find("pass", 1, true) and ui.value("program/live"):find("worked out", 1, true),
         "the live line is worked out: " .. tostring(ui.value("program/live")))
ui.click("program/hold")
hw.sleep(3)
hw.check(ui.value("program/live"):find("held here", 1, true), "the controller has told it: " .. ui.value("program/live"))
local held_at = ui.value("program/live")
ui.click("program/step")
hw.sleep(3)
hw.check(ui.value("program/live") ~= held_at, "one command on")
ui.click("program/stop")
hw.sleep(3)
hw.check(not ui.exists("program/live"), "no live line at rest")

-- ---- the terminal: an answer to a question, completion, filter, copy, clear
ui.type("terminal/command", "getM1M\n")
hw.sleep(0.5)
hw.check(ui.value("terminal/log"):find("the type of motor 1 is 4", 1, true), ui.value("terminal/log"))
hw.check(not ui.value("terminal/log"):find("not understood", 1, true), ui.value("terminal/log"))
ui.type("terminal/command", "set")
ui.key("Tab")
ui.frame(2)
hw.check(row("terminal/offer", "set"), "Tab shows what could come")
ui.key("Escape")
ui.type("terminal/command", "")
ui.type("terminal/filter", "motor 1 is")
hw.sleep(0.2)
hw.check(not ui.value("terminal/log"):find("choose program", 1, true), "the filter leaves others out")
ui.type("terminal/filter", "")
ui.click("terminal/copy")
hw.check(toast("The traffic was copied."), "copied")
ui.click("terminal/clear")
ui.frame(2)

-- ---- everything larger, smaller, and the theme
ui.key("Ctrl+=")
ui.frame(3)
ui.click("menu")
hw.check(ui.exists("menu/smaller"), "the menu can be reached at 110 %")
ui.click("menu/smaller")
ui.frame(2)
ui.key("Ctrl+0")
ui.click("menu")
ui.click("menu/theme")
ui.frame(2)
ui.screenshot(folder .. "/walk.png")

-- ---- all programs in use: a move asks which may be emptied, and its text is kept
c:send("PM-0,I1M10,PM-1,I1M11,PM-2,I1M12,PM-3,I1M13,PM-4,I1M14,PM0,")
hw.sleep(1)
ui.click("jog/1/+")
hw.sleep(1)
hw.check(ui.exists("room/4") and ui.exists("room/0"), "the five programs are offered")
ui.screenshot(folder .. "/walk-room.png")
ui.click("room/4")
hw.sleep(1)
hw.check(toast("Its text is kept in the editor. Move again."), "emptied, and its text kept")
hw.check(not toast("All five programs"), "what a dialog has asked is not complained of as well")
hw.check(c:program(3):find("I1M13", 1, true) and not c:program(4):find("I1M14", 1, true), "only the chosen one")
ui.click("program/slot/4")
ui.frame(2)
hw.check(ui.value("program/text"):find("I1M14", 1, true), "in the editor: " .. ui.value("program/text"))
local before = c:position(1)
c:move_by{[1] = 100}
c:wait(10)
hw.check(c:position(1) == before + 100, "and moves are possible")

-- ---- two controllers: Stop reaches both; one is closed, the other stays; the cable heals
local d = assert(hw.open("vxm@emulator"))
hw.sleep(0.5)
hw.check(label("controller/2") == "VXM", label("controller/2"))
local e = assert(hw.open("vxm@emulator"))
hw.sleep(0.5)
hw.check(label("controller/3") == "VXM 2", "two of one kind have two names: " .. label("controller/3"))
ui.click("menu")
ui.click("menu/close")
ui.frame(3)
ui.click("controller/2")
ui.frame(2)
d:set("M1M", 4)
c:move_by{[1] = 40000}
d:move_by{[1] = 40000}
hw.sleep(0.3)
ui.click("stop_all")
hw.check(c:wait(10) == nil or true)
d:wait(10)
hw.sleep(1)
hw.check(not c:status().moving and not d:status().moving, "both stand")
ui.click("menu")
ui.click("menu/close")
ui.frame(3)
hw.check(not ui.exists("controller/2") and label("controller/1") == "Stage", "the other is left")
-- ---- closed while a move goes on: what stays in the controller is said
local f = assert(hw.open("vxm@emulator"))
hw.sleep(0.5)
f:move_by{[1] = 60000}
hw.sleep(0.5)
ui.click("menu")
ui.click("menu/close")
ui.frame(2)
ui.click("close/leave")
hw.sleep(0.5)
hw.check(toast("the Run button would repeat it"), "the last words of a controller are heard")
hw.check(not ui.exists("controller/2"), "and its tab is gone")

c.bench:unplug(true)
hw.sleep(3)
hw.check(ui.exists("fault/try_now"), "lost is said, with a way out")
c.bench:unplug(false)
ui.click("fault/try_now")
hw.sleep(2)
hw.check(not ui.exists("fault/try_now") and ui.value("link/health"):find("good", 1, true), "connected again")
