-- Functions side by side, and functions that news of a controller sets going.
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end

-- A reaction to an input comes within 20 ms and one transaction, with byte times, on every controller, at rest and while
-- it moves, at 9600 and 38400 baud. The transaction is the longest question of a round, with the address
-- of RS-485; a board in a memory window has no byte times.
local function transaction(c, kind)
  return kind.longest and (#kind.address + #kind.longest + 1 + #assert(c:query(kind.longest)) + 1) * 10 / kind.rate or 0
end
local function opened(kind)
  local c = assert(hw.open(kind.model))
  if kind.code then
    assert(c:set(kind.rate_name, kind.code))
    if kind.rate_name == "DB" then assert(c:store()) c.bench:power_cycle() end  -- it counts from the next start
    hw.sleep(10)
    hw.check(c:status().link == "good", kind.model .. ": at its new rate")
  end
  for _, line in ipairs(kind.prepare) do c:send(line) end
  hw.sleep(1)
  return c
end
local function reacts_in_time(kind)
  local c = opened(kind)
  local allowed = 0.02 + transaction(c, kind)
  local told
  local function check(how, took)
    hw.check(took and took >= 0 and took <= allowed,
             string.format("%s at %d: %s took %s of %.4f s", kind.model, kind.rate, how, tostring(took), allowed))
  end
  for _, moving in ipairs{false, true} do
    if moving then assert(c:jog(1, "+", {speed = 500})) hw.sleep(0.5) end
    for i = 1, 15 do
      local on, at = i % 2 == 1, hw.now() + 0.3 + 0.0137 * i
      c.bench:at(at, function() c.bench:input(2, on) end)
      assert(c:wait_until(function() return c:input(2) == on end, 5))
      check("wait_until", hw.now() - at)
    end
    local at = hw.now() + 0.3071
    c.bench:at(at, function() c.bench:input(2, false) end)
    same(hw.wait_any{function() c:wait_until(function() return not c:input(2) end) end, function() hw.sleep(5) end}, 1,
         kind.model .. ": the first")
    check("wait_any", hw.now() - at)
    local reaction = c:on("input", function(n, on) told = {n = n, on = on, at = hw.now()} end)
    for i = 1, 15 do
      local on, at = i % 2 == 1, hw.now() + 0.3 + 0.0137 * i
      told = nil
      c.bench:at(at, function() c.bench:input(2, on) end)
      hw.sleep(1)
      hw.check(told and told.n == 2 and told.on == on, kind.model .. ": what it is told")
      check("on", told.at - at)
    end
    reaction:cancel()
    told = nil
    c.bench:input(2, false)
    hw.sleep(1)
    same(told, nil, kind.model .. ": cancelled")
  end
  assert(c:stop() and c:wait(10))
end

-- A limit switch is seen as fast, or one transaction later: a PMX tells its switches in the answer that is the longest of
-- all, and when one ends a move of a VXM the end is read first.
local function sees_limits_in_time(kind)
  local c = opened(kind)
  local axis = c:axes()[1]
  local allowed, told = 0.02 + (kind.answers or 1) * transaction(c, kind), nil
  c:on("limit", function(name, sign) told = {axis = name, sign = sign, at = hw.now()} end)
  for _, moving in ipairs{false, true} do
    for i = 1, 9 do
      if moving then assert(c:jog(axis, "+", {speed = 500})) hw.sleep(0.5) end
      local at = hw.now() + 0.3 + 0.0137 * i
      told = nil
      c.bench:at(at, function() c.bench:limit(axis, "+", true) end)
      hw.sleep(1.5)
      hw.check(told and tostring(told.axis) == axis and told.sign == "+", kind.model .. ": what it is told of a limit")
      hw.check(told.at >= at and told.at - at <= allowed, string.format("%s at %d: a limit, %s, took %.4f of %.4f s",
        kind.model, kind.rate, moving and "in motion" or "at rest", told.at - at, allowed))
      c.bench:limit(axis, "+", false)
      hw.sleep(0.5)
      c:clear_errors()
    end
  end
end
local vxm = {model = "vxm@emulator,wire=real", address = "", longest = "X", prepare = {"setM1M4"}, rate_name = "B", fast = 38, answers = 2}
local pmx = {model = "pmx-4ex-sa@emulator,wire=real", address = "@01", longest = "MST", prepare = {"EO=15"},
             rate_name = "DB", fast = 3, answers = 2}
local dmx = {model = "dmx-k-sa@emulator,wire=real", address = "@01", longest = "SASTAT0", prepare = {"EO=1"}, rate_name = "DB", fast = 3}
for _, kind in ipairs{vxm, pmx, dmx} do
  for _, rate in ipairs{9600, 38400} do
    kind.rate, kind.code = rate, rate > 9600 and kind.fast or nil
    reacts_in_time(kind)
    sees_limits_in_time(kind)
  end
end
-- On a line of RS-485 the devices take turns: a transaction of each stands in between.
local line = assert(hw.open("dmx-k-sa@emulator,wire=real,id=01-02"))
for _, device in pairs(line.devices) do assert(device:query("EO=1")) end
dmx.rate = 9600
local second, at_input = line.devices["02"], nil
local allowed = 0.02 + 2 * transaction(second, dmx)
hw.sleep(2)
line:on("input", function(id, n, on) at_input = id == "02" and n == 2 and hw.now() end)
for _, moving in ipairs{false, true} do
  if moving then assert(line:jog("01", "+", {speed = 500})) hw.sleep(0.5) end
  for i = 1, 16 do
    local at = hw.now() + 0.3 + 0.0137 * i
    second.bench:at(at, function() second.bench:input(2, i % 2 == 1) end)
    hw.sleep(1)
    hw.check(at_input and at_input >= at and at_input - at <= allowed,
             string.format("on a line of two: took %s of %.4f s", tostring(at_input and at_input - at), allowed))
    at_input = nil
  end
end
assert(line:stop())

local board = {model = "vme58@emulator", rate = 0, prepare = {}}
reacts_in_time(board)
sees_limits_in_time(board)

-- Side by side.
local a = hw.spawn(function(x) hw.sleep(2) return x, "done" end, 7)
local b = hw.spawn(function() hw.sleep(1) end)
same(hw.wait_any{a, b}, 2, "the first")
same(a:over(), false, "the other goes on")
local x, word = a:wait()
same(x, 7, "its argument") same(word, "done", "its second result")
same(a:over(), true, "over")
local ticks = 0
local which, what = hw.wait_any{
  function() while true do hw.sleep(0.1) ticks = ticks + 1 end end,
  function() hw.sleep(1.05) return "up" end,
}
same(which, 2, "the function that ends") same(what, "up", "its result")
local before = ticks
hw.sleep(1)
same(ticks, before, "a function that has lost is ended")
local began = hw.now()
local none, why, more = hw.wait_any({function() hw.sleep(10) end}, 0.5)
same(none, nil, "too late") hw.check(why:find("Timeout", 1, true), why)
same(more.kind, "timeout", "kind")
hw.check(math.abs(hw.now() - began - 0.5) < 1e-6, "in time")
local never = hw.spawn(function() error("it has been cancelled") end)
never:cancel()
same(never:over(), true, "cancelled before it began")
hw.check(not pcall(hw.spawn, 5) and not pcall(hw.wait_any, {}) and not pcall(hw.wait_any, {5}), "misuse")

-- What happens to a controller.
local c = assert(hw.open("pmx-4ex-sa@emulator"))
assert(c:query("EO=15"))
c.bench:place("X", {plus = 500})
local limit, stopped, lost
c:on("limit", function(axis, sign) limit = axis .. sign end)
c:on("stopped", function(axis) c:position(axis) stopped = axis end)  -- it may wait
c:on("lost", function(reason) lost = reason end)
assert(c:move_to{X = 4000})
local ended
ended, why, more = c:wait(30)
same(ended, nil, "a limit") same(more.kind, "controller", "kind") same(more.device, "pmx-4ex-sa@emulator", "device")
same(more.axis, "X", "which axis")
hw.sleep(0.5)
same(limit, "X+", "limit") same(stopped, "X", "stopped") same(lost, nil, "not lost")
c.bench:place("Y", {plus = 500})
assert(c:query("EO=15"))
assert(c:clear_errors() and c:move_by{X = -300} and c:wait(30))
assert(c:jog("Y", "+"))
hw.sleep(5)  -- it has met its limit
assert(c:move_by{X = 4000})
ended, why, more = c:wait(30)
same(ended, nil, "a limit after another's") hw.check(why:find("Axis X", 1, true), why)
same(more.axis, "X", "the axis that is named")
c.bench:unplug(true)
hw.sleep(15)
hw.check(lost and #lost > 10, "lost")
local ok, message = pcall(c.on, c, "inputs", print)
hw.check(not ok and message:find('Did you mean "input"?', 1, true), message)
ended, why = c:wait_until(function() return false end, 0.5)
same(ended, nil, "never true") hw.check(why:find("0.5 s", 1, true), why)

-- A refusal says of what.
c = assert(hw.open("vxm@emulator"))
ok, why, more = c:run(9)
hw.check(ok == nil and why:find("There is no such program.", 1, true) and more.kind == "refused", why)
ok, why, more = c:move_to{[1] = 99999999}
same(ok, nil, "refused") same(more.kind, "refused", "kind") same(more.axis, "1", "axis") same(more.device, "vxm@emulator", "device")
same(tostring(more), "refused", "as it prints")
c.bench:unplug(true)
hw.sleep(15)
ok, why, more = c:position(2)
same(ok, nil, "not old") same(more.kind, "lost", "kind") same(more.axis, "2", "axis") hw.check(#why > 10, why)

