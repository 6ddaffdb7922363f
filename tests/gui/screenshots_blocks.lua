-- Pictures of the blocks of one controller, to be looked at; from the root of the house:
--   build/handwheel run --gui tests/gui/screenshots_blocks.lua FOLDER [PART-OF-A-NAME [dark|light [MODEL]]]
require("lib.pictures")

local kinds = {"speed", "move", "move_by", "arc", "circle", "jog", "home", "stop", "speed_stairs", "wait_motion",
               "delay", "wait_input", "move_on_input", "output", "enable", "pen", "loop", "comment", "custom"}
local model = hw.args[4] or "pmx-4ex-sa"
local of_model = {vxm = "vxm", ["pmx-4ex-sa"] = "pmx", ["dmx-k-sa"] = "dmx", vme58 = "vme58"}

local c = assert(hw.open(model .. "@emulator"))
if model == "vxm" then for m = 1, 2 do c:set("M" .. m .. "M", 4) end end
hw.sleep(1)
local function name(state) return of_model[model] .. "-blocks-" .. state end
local function at_blocks() tab("blocks") ui.frame(3) end
local function add(kind)
  at_blocks()
  ui.click("blocks/end")
  for _, w in ipairs(ui.list()) do
    if w.id == "blocks/add/" .. kind then
      if not w.enabled then return false end
      ui.click(w.id)
      ui.frame(3)
      return true
    end
  end
end
-- A block is opened, whatever the size of the window has closed.
local function open(row)
  at_blocks()
  ui.click("blocks/end")
  ui.click("blocks/" .. row)
  ui.frame(3)
end

pictures(name("none"), at_blocks)
local rows = {}
local count = 0
for _, kind in ipairs(kinds) do
  if add(kind) then
    count = count + 1
    rows[kind] = count
    pictures(name("new-" .. kind), function() open(rows[kind]) end)
  end
end
hw.sleep(1)
pictures(name("all"), function() at_blocks() ui.click("blocks/end") end, nil, with_200)

-- ---- a short one that runs
ui.click("blocks/end")
while ui.exists("blocks/1") do
  ui.click("blocks/1")
  if not ui.exists("blocks/remove") then ui.click("blocks/1") end
  ui.click("blocks/remove")
  ui.frame(2)
end
local first = model == "dmx-k-sa" and "X" or model == "vxm" and "1" or "X"
add("speed")
add("move") ui.type("blocks/2/to/" .. first, "4000\n")
if rows.wait_motion then add("wait_motion") end
add("output")
add("move_by")
local last = rows.wait_motion and 5 or 4
ui.type("blocks/" .. last .. "/to/" .. first, "-1500\n")
ui.click("blocks/loop")
hw.sleep(1)
pictures(name("short"), function() at_blocks() ui.click("blocks/end") end, nil, with_200)
pictures(name("text-aside"), function() at_blocks() if ui.exists("blocks/aside") then ui.click("blocks/aside") end end,
         function() if ui.exists("blocks/aside") then ui.click("blocks/aside") end end, {medium, narrow})
ui.click("blocks/2")
ui.type("blocks/2/to/" .. first, "x")
pictures(name("typed-wrong"), function() open(2) end)
ui.type("blocks/2/to/" .. first, "4000\n")
ui.click("blocks/end")
ui.click("blocks/run")
hw.sleep(1.5)
pictures(name("running"), at_blocks, nil, with_200)
c:wait(60)
hw.sleep(1)
pictures(name("ran"), at_blocks)
