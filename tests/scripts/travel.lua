-- How far axes may go, and the places that a script saves, on every kind of controller.
local function same(got, want, what)
  hw.check(got == want, string.format("%s: got %s, want %s", what, tostring(got), tostring(want)))
end

local function refused(ok, why, words)
  same(ok, nil, "refused")
  hw.check(why:find(words, 1, true), why)
end

for _, kind in ipairs{
  {"vxm@emulator", 1}, {"pmx-4ex-sa@emulator", "X", "EO=15"}, {"dmx-k-sa@emulator", "X", "EO=1"},
  {"vme58@emulator", "X"},
} do
  local address, axis, power = table.unpack(kind)
  local c = assert(hw.open(address))
  if power then assert(c:query(power)) end
  local none = c:limits(axis)
  same(none.minus, nil, address) same(none.plus, nil, address)
  assert(c:limits(axis, {minus = -200, plus = 900}))
  same(c:limits(axis).plus, 900, address)
  local ok, why = c:move_to{[axis] = 1000}
  refused(ok, why, " lies 100 ")
  refused(ok, why, " past the + limit of ")
  ok, why = c:move_by{[axis] = -201}
  refused(ok, why, "Nothing was sent.")
  assert(c:jog(axis, "+", 500))
  same(c:wait(30), true, "a jog ends there by itself")
  same(c:position(axis), 900, address)
  ok, why = c:jog(axis, "+")
  refused(ok, why, "is at the + limit set for it")
  assert(c:limits(axis, {minus = -200}))
  assert(c:move_to{[axis] = 1000})
  assert(c:wait(30))
  same(c:limits(axis).plus, nil, address)
  ok, why = c:limits(axis, {minus = 5, plus = 5})
  refused(ok, why, "must lie on the − side of its + limit")
  hw.check(not pcall(c.limits, c, axis, {low = 5}), "an unknown key")
  assert(c:limits(axis, {}))

  assert(c:place("far"))
  assert(c:place("load", {[axis] = 40}))
  assert(c:go("load"))
  assert(c:wait(30))
  same(c:position(axis), 40, address)
  assert(c:go("far"))
  assert(c:wait(30))
  same(c:position(axis), 1000, address)
  ok, why = c:go("nowhere")
  refused(ok, why, 'There is no place "nowhere". There is: far, load.')
  assert(c:place("load", {}))
  ok, why = c:go("load")
  refused(ok, why, "There is: far.")
  assert(c:limits(axis, {plus = 500}))
  assert(c:send(address:find("vxm") and "I1M10,R" or address:find("vme") and "AX MR10 GO" or
                (address:find("dmx") and "X1010" or "X1010")))
  hw.sleep(2)
  hw.check(c:wait(30))
  same(c:position(axis), 1010, "what is typed goes")
end
