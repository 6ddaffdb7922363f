-- Functions side by side, and functions that news of a controller sets going.
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end

-- A reaction to an input comes within 20 ms and one transaction, with byte times, on every controller, at rest and while
-- it moves. The transaction is the longest question of a round; a board in a memory window has no byte times.
local function transaction(c, question)
  local shortest = math.huge
  for _ = 1, 12 do
    hw.sleep(0.037)
    local asked = hw.now()
    assert(c:query(question))
    shortest = math.min(shortest, hw.now() - asked)  -- the others have waited for a round
  end
  return shortest
end
local function reacts_in_time(address, question, prepare)
  local c = assert(hw.open(address))
  for _, line in ipairs(prepare) do c:send(line) end
  hw.sleep(1)
  local allowed = 0.02 + (question and transaction(c, question) or 0)
  local told
  local function check(how, took)
    hw.check(took and took >= 0 and took <= allowed,
             string.format("%s: %s took %s of %.4f s", address, how, tostring(took), allowed))
  end
  for _, moving in ipairs{false, true} do
    if moving then assert(c:jog(1, "+", {speed = 500})) hw.sleep(0.5) end
    for i = 1, 9 do
      local on, at = i % 2 == 1, hw.now() + 0.3 + 0.0137 * i
      c.bench:at(at, function() c.bench:input(2, on) end)
      assert(c:wait_until(function() return c:input(2) == on end, 5))
      check("wait_until", hw.now() - at)
    end
    local at = hw.now() + 0.3071
    c.bench:at(at, function() c.bench:input(2, false) end)
    same(hw.wait_any{function() c:wait_until(function() return not c:input(2) end) end, function() hw.sleep(5) end}, 1,
         address .. ": the first")
    check("wait_any", hw.now() - at)
    local reaction = c:on("input", function(n, on) told = {n = n, on = on, at = hw.now()} end)
    for i = 1, 9 do
      local on, at = i % 2 == 1, hw.now() + 0.3 + 0.0137 * i
      told = nil
      c.bench:at(at, function() c.bench:input(2, on) end)
      hw.sleep(1)
      hw.check(told and told.n == 2 and told.on == on, address .. ": what it is told")
      check("on", told.at - at)
    end
    reaction:cancel()
    told = nil
    c.bench:input(2, false)
    hw.sleep(1)
    same(told, nil, address .. ": cancelled")
  end
  assert(c:stop())
end
reacts_in_time("vxm@emulator,wire=real", "X", {"setM1M4"})
reacts_in_time("pmx-4ex-sa@emulator,wire=real", "MST", {"EO=15"})
reacts_in_time("dmx-k-sa@emulator,wire=real", "SASTAT0", {"EO=1"})
reacts_in_time("vme58@emulator", nil, {})

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
same(more.kind, "refused", "kind")
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
hw.sleep(0.5)
same(limit, "X+", "limit") same(stopped, "X", "stopped") same(lost, nil, "not lost")
c.bench:unplug(true)
hw.sleep(15)
hw.check(lost and #lost > 10, "lost")
local ok, message = pcall(c.on, c, "inputs", print)
hw.check(not ok and message:find('Did you mean "input"?', 1, true), message)
ended, why = c:wait_until(function() return false end, 0.5)
same(ended, nil, "never true") hw.check(why:find("0.5 s", 1, true), why)

-- A refusal says of what.
c = assert(hw.open("vxm@emulator"))
ok, why, more = c:move_to{[1] = 99999999}
same(ok, nil, "refused") same(more.kind, "refused", "kind") same(more.axis, "1", "axis") same(more.device, "vxm@emulator", "device")
same(tostring(more), "refused", "as it prints")
