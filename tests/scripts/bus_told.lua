-- A bus names the device: in its own wait and stop, and in what sets functions going.
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end
local c = assert(hw.open("dmx-k-sa@emulator,id=01-03"))
local limit, stopped, input, lost
c:on("limit", function(id, sign) limit = id .. sign end)
c:on("stopped", function(id) c:position(id) stopped = id end)
c:on("input", function(id, n, on) input = id .. " " .. n .. " " .. tostring(on) end)
c:on("lost", function(id, why) lost = id .. " " .. why end)
c.devices["02"].bench:input(2, true)
hw.sleep(1)
same(input, "02 2 true", "an input of the second")
c.devices["03"].bench:at(hw.now() + 1, function() c.devices["03"].bench:limit("X", "+", true) end)
assert(c:jog("03", "+"))
local done, why, more = c:wait(10)
hw.check(done == nil and why:find("^03: ") and why:find("limit"), why)
hw.check(more.device and more.device:find("id=03", 1, true), "device: " .. tostring(more.device))
same(more.kind, "controller", "kind")
hw.sleep(0.5)
same(limit, "03+", "limit") same(stopped, "03", "stopped") same(lost, nil, "none is lost")
c.devices["02"].bench:at(hw.now() + 1, function() c.devices["02"].bench:input(2, false) end)
assert(c:wait_until(function() return not c.devices["02"]:input(2) end, 5))
c.devices["02"].bench:power(false)
hw.sleep(6)
hw.check(lost and lost:find("^02 "), "lost: " .. tostring(lost))
for how, ask in pairs{stop = function() return c:stop() end, wait = function() return c:wait(5) end,
                      position = function() return c:position("02") end,
                      query = function() return c.devices["02"]:query("PX") end} do
  local ok, reason, what = ask()
  hw.check(ok == nil and reason:find("^02: ") and not reason:find("^02: 02"), how .. ": " .. tostring(reason))
  hw.check(what.device:find("id=02", 1, true), how .. ": " .. tostring(what.device))
end
