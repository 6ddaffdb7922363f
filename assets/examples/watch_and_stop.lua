-- Stops everything when a door is opened (input 2), whatever the script is doing at that moment.
local a = hw.arguments{about = "Stops everything when input 2 is operated.",
  {name = "address", default = "pmx-4ex-sa@emulator", help = "the controller"},
  {name = "speed", kind = "number", default = 3000, help = "steps/s"},
}
local c = hw.check(hw.open(a.address))
hw.check(c:query("EO=15"))                  -- motor power
local opened
c:on("input", function(n, on)
  if n == 2 and on then
    opened = hw.now()
    c:stop()
  end
end)
c:on("lost", function(why) hw.log("the link is lost: " .. why) end)
if c.bench then c.bench:at(hw.now() + 2, function() c.bench:input(2, true) end) end
hw.check(c:move_to({X = 100000}, {speed = a.speed}))
hw.check(c:wait(60))                        -- true: the script's own stop ended it
hw.check(opened, "the door stayed shut")
print("stopped at " .. c:position("X"))
