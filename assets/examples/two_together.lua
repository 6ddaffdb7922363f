-- Two controllers side by side: one turns a table, the other measures, until both are through.
local turn = hw.check(hw.open("vxm@emulator"))
local slide = hw.check(hw.open("dmx-k-sa@emulator"))
turn:set("M1M", 4)
slide:send("EO=1")
local table_job = hw.spawn(function()
  for _ = 1, 4 do
    hw.check(turn:move_by({[1] = 1000}, {speed = 2000}) and turn:wait(60))
  end
  return turn:position(1)
end)
local slide_job = hw.spawn(function()
  for i = 1, 3 do
    hw.check(slide:move_to({X = i * 1000}, {speed = 3000}) and slide:wait(60))
  end
  return slide:position("X")
end)
local first = hw.wait_any{table_job, slide_job}
print((first == 1 and "table" or "slide") .. " first", table_job:wait(), (slide_job:wait()))
