-- The demo in the window: one of each family with a program to try, which runs as it stands. Its line is followed.
ui.window(1440, 900)
ui.click("connect/demo")
hw.sleep(8)

local function front(name)
  for _, w in ipairs(ui.list()) do
    if w.id:match("^controller/%d+$") and w.label:find(name, 1, true) then
      ui.click(w.id)
      return ui.frame(3)
    end
  end
  error("no tab " .. name)
end

-- At how many places its live line was seen.
local function run_of(name)
  front(name)
  ui.click("tab/program")
  ui.frame(3)
  hw.check(#ui.value("program/text") > 50, name .. ": a program stands in its editor")
  ui.click("program/run")
  local seen, places, began = {}, 0, false
  for _ = 1, 300 do
    hw.sleep(0.2)
    local running = ui.value("status/text"):find("running", 1, true)
    if began and not running then return places end
    began = began or running
    local at = ui.exists("program/live") and ui.value("program/live")
    if at and not seen[at] then
      seen[at] = true
      places = places + 1
    end
  end
  error(name .. " does not end")
end

hw.check(run_of("PMX") >= 8, "the house is followed line by line")
hw.check(ui.value("dro/X/position") == "3000" and ui.value("dro/Y/position") == "0", "and drawn")
-- A drawing to try is open in its panel, and is cut as it stands there.
ui.click("tab/drawing")
hw.sleep(2)
hw.check(ui.value("drawing/chains"):match("^6,"), "a drawing stands in its panel, not " .. ui.value("drawing/chains"))
ui.click("drawing/cut")
ui.click("drawing/ask_cut/yes")
local at_work = 0
for _ = 1, 900 do
  hw.sleep(0.5)
  if ui.value("status/text") ~= "idle" and ui.value("drawing/cut_progress"):find(" left$") then at_work = at_work + 1 end
  if ui.value("drawing/cut_progress") == "Everything is drawn" then break end
end
hw.check(ui.value("drawing/cut_progress") == "Everything is drawn", ui.value("drawing/cut_progress"))
hw.check(at_work > 20, "and seen at it")
hw.check(run_of("DMX") >= 3, "the strokes are followed")
run_of("VME58")  -- it keeps no program, so it tells no line
for _, axis in ipairs{"X", "Y", "Z"} do hw.check(ui.value("dro/" .. axis .. "/position") == "0", axis .. " is back") end
front("VXM")
ui.click("tab/program")
hw.check(#ui.value("program/text") > 50, "VXM: a program stands in its editor")
