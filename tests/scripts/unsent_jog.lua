-- A jog whose speed could not be asked was not sent: what else moves goes on.
local unsent = 0
for bytes = 40, 80, 20 do
  local c = assert(hw.open("pmx-4ex-sa@emulator"))
  assert(c:move_by {X = 200000})
  hw.sleep(1)
  c.bench:drop(bytes)
  local begun, why = c:jog("Y", "+", 500)
  if not begun and (why:find("not sent", 1, true) or why:find("Nothing was sent", 1, true)) then
    unsent = unsent + 1
  end
  hw.sleep(20)
  hw.check(c:status("X").moving, "X goes on")
end
hw.check(unsent > 0)
