-- Pictures of a path in three axes and of running the rest of it, to be looked at:
--   build/handwheel run --gui tests/gui/screenshots_path.lua FOLDER [PART-OF-A-NAME [dark|light]]
require("lib.pictures")

local c = assert(hw.open("pmx-4ex-sa@emulator"))
hw.sleep(1)

-- A pocket in three depths, its corners cut on the way down.
local steps = {}
local function step(text) steps[#steps + 1] = "  { do = " .. text .. " }," end
step('"speed", high = 40000, low = 1000, ramp_ms = 100')
step('"pen", down = false')
for depth = 1, 3 do
  local in_by = (depth - 1) * 700
  local low, right, up = in_by, 12000 - in_by, 8000 - in_by
  step(string.format('"move", to = { X = %d, Y = %d }', low, low))
  step('"wait_motion"')
  step(string.format('"move", to = { Z = %d }', -1500 * depth))
  step('"wait_motion"')
  step('"pen", down = true')
  for _, corner in ipairs{{right, low}, {right, up}, {low, up}, {low, low}} do
    step(string.format('"move", to = { X = %d, Y = %d, Z = %d }', corner[1], corner[2], -1500 * depth))
    step('"wait_motion"')
  end
  step('"pen", down = false')
  step('"move", to = { Z = 2000 }')
  step('"wait_motion"')
end
local file = os.tmpname() .. ".toml"
local out = assert(io.open(file, "w"))
out:write('handwheel_sequence = 1\nunit = "steps"\n',
          'axes = [ { name = "X", per_unit = 1 }, { name = "Y", per_unit = 1 }, { name = "Z", per_unit = 1 } ]\n',
          'pen_up = [ { do = "output", output = 5, on = false } ]\n',
          'pen_down = [ { do = "output", output = 5, on = true } ]\n',
          "steps = [\n", table.concat(steps, "\n"), "\n]\n")
out:close()

tab("blocks")
ui.click("blocks/open")
ui.type("file/path", file)
ui.click("file/open")
hw.sleep(0.5)
os.remove(file)
ui.click("blocks/to_program")
tab("path")
ui.click("path/simulate")
hw.sleep(1)
ui.click("path/tool") ui.click("path/tool/Out 5")
hw.sleep(0.5)
pictures("two-axes", function() tab("path") end)
ui.click("path/third") ui.click("path/third/Z")
hw.sleep(0.5)
for _, from in ipairs{"top", "front", "side", "iso"} do
  pictures("from-" .. from, function() tab("path") ui.click("path/view/" .. from) ui.frame(3) end)
end
pictures("clicked", function() tab("path") ui.click("path/view/top") ui.click("path/view/iso") ui.frame(3)
  ui.click("path/view") end)
pictures("run-from", function() tab("path") ui.click("path/run_here") ui.frame(3) end, escape)
