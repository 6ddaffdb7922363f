-- A jog whose speed could not be asked was not sent: what else moves or runs goes on.
for _, bytes in ipairs {8, 12, 16, 20} do
  local c = assert(hw.open("pmx-4ex-sa@emulator"))
  assert(c:set("HS", 1000))
  assert(c:move_by {X = 20000})
  hw.sleep(1)
  c.bench:drop(bytes)
  local begun, why = c:jog("Y", "+", 500)
  hw.check(not begun and why:find("The jog was not sent", 1, true), why)
  hw.sleep(2)
  hw.check(c:status("X").moving, "X goes on")
  hw.check(c:position("Y") == 0, "Y never moved")
  c:close()
end
