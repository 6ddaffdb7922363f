-- Drawings that are damaged, or that no machine can draw, opened by hand: each is told in a sentence that can be read.
local folder = hw.args[1] or "."
local files = "../../../tests/core/drawing/files/own/"
ui.window(1024, 700)
local c = assert(hw.open("pmx-4ex-sa@emulator"))
c:send("EO=15")
hw.sleep(1)
ui.click("tab/drawing")

local function open(name)
  ui.click("drawing/open")
  ui.type("file/path", files .. name .. ".dxf\n")
  hw.sleep(1)
end

-- All that is said: messages, and what stands beside the drawing.
local function said()
  local all = ""
  for _, w in ipairs(ui.list()) do
    if w.id:match("^toast/") or w.id == "drawing/problem" or w.id == "drawing/outline" or w.id == "drawing/left_out" then
      all = all .. tostring(w.value) .. "\n"
    end
  end
  return all
end

local function told(name, words)
  open(name)
  local all = said()
  hw.check(all:find(words, 1, true), name .. ": \"" .. words .. "\" in \"" .. all .. "\"")
  ui.screenshot(folder .. "/drawing_bad_" .. name .. ".png")
end

told("cut_off", "is cut off")
told("binary", "binary")
told("a_dwg", "DWG")
told("empty", "empty")
hw.check(not ui.exists("drawing/drawn"), "none of them is a drawing")
told("inserts_of_themselves", "itself")
told("no_length", "it has no size")
told("no_numbers", "holds no number")
told("splines_wrong", "its knots are not in order")
told("huge", "the range of a ")

-- A radius beyond the counters of the controller.
open("circles")
ui.type("drawing/times", "10000000\n")
hw.sleep(1)
hw.check(said():find("the range of a ", 1, true), "a radius out of range: " .. said())
for _, w in ipairs(ui.list()) do
  if w.id == "drawing/cut" then hw.check(not w.enabled, "it is not cut") end
end
ui.screenshot(folder .. "/drawing_bad_radius.png")
ui.type("drawing/times", "1\n")
hw.sleep(1)
hw.check(ui.exists("drawing/drawn"), "and what is good is drawn again")
