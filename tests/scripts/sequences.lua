-- A sequence in a file's words is loaded and run on each controller, and moves its axis as it says.
local text = [[
handwheel_sequence = 1
unit = "mm"
axes = [ { name = "%s", per_unit = 10 } ]
pen_down = [ { do = "output", output = %d, on = true }, { do = "delay", ms = 20 } ]
pen_up = [ { do = "output", output = %d, on = false } ]
steps = [
  { do = "speed", high = 100, ramp_ms = 200 },
  { do = "move", to = { "%s" = 40 } },
  { do = "wait_motion" },
  { do = "pen", down = true },
  { do = "loop", times = 3, steps = [ { do = "move", relative = true, to = { "%s" = 5 } }, { do = "wait_motion" } ] },
  { do = "pen", down = false },
]
]]
for address, it in pairs{
  ["vxm@emulator"] = {axis = "1", output = 1},
  ["pmx-4ex-sa@emulator"] = {axis = "X", output = 5, power = "EO=15"},
  ["dmx-k-sa@emulator"] = {axis = "X", output = 3, power = "EO=1"},
  ["vme58@emulator"] = {axis = "X", output = 8},
} do
  local c = hw.check(hw.open(address))
  hw.sleep(1)
  if address:find("^vxm") then for m = 1, 2 do c:set("M" .. m .. "M", 4) end end
  if it.power then c:send(it.power) end
  hw.sleep(1)
  local own = text:format(it.axis, it.output, it.output, it.axis, it.axis)
  hw.check(c:load(own, 0), address)
  hw.check(c:run(0), address)
  hw.check(c:wait(60), address)
  hw.check(c:position(1) == 550, address .. " stands at " .. tostring(c:position(1)))
  local ok, why = c:load(own:gsub('do = "wait_motion"', 'do = "output", output = 61', 1), 0)
  hw.check(not ok and why:find("Step 3 (output): ", 1, true), address .. ": " .. tostring(why))
end
