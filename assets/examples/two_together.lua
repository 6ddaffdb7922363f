-- Two controllers side by side: one turns a table, the other measures, until both are through.
local a = hw.arguments{about = "Turns a table and moves a slide side by side.",
  {name = "table", default = "vxm@emulator", help = "the controller of the table"},
  {name = "slide", default = "dmx-k-sa@emulator", help = "that of the slide"},
  {name = "speed", kind = "number", default = 2000, help = "of the table, steps/s"},
}
local turn = hw.check(hw.open(a.table))
local slide = hw.check(hw.open(a.slide))
hw.check(turn:set("M1M", 4))
hw.check(slide:query("EO=1"))
local table_job = hw.spawn(function()
  for _ = 1, 4 do
    hw.check(turn:move_by({[1] = 1000}, {speed = a.speed}) and turn:wait(60))
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
