-- A power cut of any length, whatever the axis does and however its motors come on again, leaves no count that
-- is trusted; what only looks like one does.
local function same(seen, expected, what)
  hw.check(seen == expected, ("%s: %s, not %s"):format(what, tostring(seen), tostring(expected)))
end

local function dip(c, seconds)
  c.bench:power(false)
  hw.sleep(seconds)
  c.bench:power(true)
  hw.sleep(8)
end

-- ---- motors that power-up switches on: only the counters tell
local motions = {
  rest = function() end,
  home = function(c) assert(c:home("X", "-")) end,
  to_zero = function(c) assert(c:move_to{X = 0}) end,
  jog_away = function(c) assert(c:jog("X", "+", 1000)) end,
}
for _, model in ipairs{{"pmx-4ex-sa", 15}, {"dmx-k-sa", 1}} do
  for name, begin in pairs(motions) do
    for _, seconds in ipairs{0.3, 1, 3} do
      local what = ("%s, %s, %g s"):format(model[1], name, seconds)
      local c = assert(hw.open(model[1] .. "@emulator"))
      for _, text in ipairs{"EO=" .. model[2], "EOBOOT=" .. model[2], "STORE"} do assert(c:query(text)) end
      assert(c:move_to{X = 9000})
      assert(c:wait(60))
      begin(c)
      hw.sleep(1.2)
      dip(c, seconds)
      same(c:trust("X"), "untrusted", what)
      same(c:move_to{X = 500}, nil, what)
    end
  end

  -- A program that power-up starts, and that switches the motors on.
  local c = assert(hw.open(model[1] .. "@emulator"))
  assert(c:load(("EO=%d\nWHILE 1=1\nX1000\nWAITX\nX0\nWAITX\nENDWHILE\nEND\n"):format(model[2]), 0))
  assert(c:query("EO=" .. model[2]) and c:query("SLOAD=1") and c:query("STORE"))
  assert(c:move_to{X = 5000})
  assert(c:wait(60))
  dip(c, 3)
  same(c:trust("X"), "untrusted", model[1] .. ", a program at power-up")
end

-- ---- what is no power cut: the motors have power that power-up would not have given
local harmless = {
  to_zero = function(c) assert(c:move_to{X = 0}) end,
  home = function(c) assert(c:home("X", "-")) end,
  program_zeroes = function(c)
    assert(c:load("DELAY=2000\nPX=0\nEX=0\nEND\n", 0))
    assert(c:run(0))
  end,
}
for _, model in ipairs{{"pmx-4ex-sa", 15}, {"dmx-k-sa", 1}} do
  for name, begin in pairs(harmless) do
    local c = assert(hw.open(model[1] .. "@emulator"))
    c.bench:place("X", {minus = -50000, plus = 50000, home = {1000, 1200}})
    assert(c:query("EO=" .. model[2]))
    assert(c:move_to{X = 5000})
    assert(c:wait(60))
    begin(c)
    hw.sleep(0.5)
    c.bench:unplug(true)
    hw.sleep(12)
    c.bench:unplug(false)
    hw.sleep(8)
    hw.check(c:trust("X") ~= "untrusted", model[1] .. ", unplugged: " .. name)
  end
end

-- ---- a VME58 that stops dead at its home switch: a step motor overshoots, a servo's encoder tells
for address, word in pairs{["vme58@emulator,variant=8"] = "untrusted", ["vme58@emulator"] = "counted"} do
  local c = assert(hw.open(address))
  c.bench:place("X", {home = {2000, 2200}})
  c:send("AX VL8000 AC50000")
  hw.sleep(0.5)
  assert(c:home("X", "+", "kill"))
  assert(c:wait(60))
  same(c:trust("X"), word, address)
end
