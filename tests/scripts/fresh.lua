-- What a script reads is never older than its call, while a VXM moves too; and wait tells what ended a program.

local function same(got, wanted, what)
  hw.check(got == wanted, what .. ": " .. tostring(got) .. " instead of " .. tostring(wanted))
end

for _, address in ipairs{"vxm@emulator", "vxm@emulator,wire=real,baud=9600"} do
  local c = assert(hw.open(address))
  c:move_by{[1] = 30000}
  hw.sleep(0.3)
  for i = 1, 12 do
    local on = i % 2 == 1
    c.bench:input(2, on)
    same(c:input(2), on, address .. ", input " .. i)
    c.bench:limit(2, "+", on)
    same(c:status(2).limit_plus, on, address .. ", limit " .. i)
    c.bench:analog(1, 100 + i)
    same(c:analog(1), 100 + i, address .. ", analog input " .. i)
    hw.sleep(0.013)
  end
  same(c:status(1).moving, true, "it moves meanwhile")
  c:stop()
  c:wait(20)

  -- a stored program that runs into a switch has not ended as it should; one that looks for the switch has
  c.bench:place(1, {minus = -2000, plus = c:position(1) + 1000})
  hw.check(c:load("I1M9000", 1))
  hw.check(c:run(1))
  local ended, why = c:wait(60)
  hw.check(ended == nil and why:find("limit"), address .. ", a program that a switch has ended: " .. tostring(why))
  hw.check(c:load("I1M-400", 1))
  hw.check(c:run(1))
  same(c:wait(60), true, address .. ", away from the switch")
  hw.check(c:load("I1M0", 1))
  hw.check(c:run(1))
  same(c:wait(60), true, address .. ", it was to go there")
end
