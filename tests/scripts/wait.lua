-- A wait right behind raw text: the text goes out first, and what it moves has come to rest when the wait ends.
local moves = {
  {"vxm@emulator", 1, "I1M400,R", 400},
  {"pmx-4ex-sa@emulator", "X", "X1000", 1000, "EO=1"},
  {"dmx-k-sa@emulator", 1, "X1000", 1000, "EO=1"},
}
for _, m in ipairs(moves) do
  local address, axis, text, target, before = table.unpack(m)
  local c = assert(hw.open(address))
  if before then assert(c:query(before)) end
  assert(c:position(axis) == 0)
  c:send(text)
  assert(c:wait(30))
  hw.check(c:position(axis) == target, address .. " waited for what was sent: " .. c:position(axis))
  c:stop()
  hw.check(c:wait(1), address .. " is at rest")
end
