-- Stops everything when a door is opened (input 2), whatever the script is doing at that moment.
local a = hw.arguments{about = "Stops everything when input 2 is operated.",
  {name = "address", default = "pmx-4ex-sa@emulator", help = "the controller"},
}
local c = hw.check(hw.open(a.address))
c:send("EO=15")
local opened
c:on("input", function(n, on)
  if n == 2 and on then
    opened = hw.now()
    c:stop()
  end
end)
if c.bench then c.bench:at(hw.now() + 2, function() c.bench:input(2, true) end) end
hw.check(c:move_to({X = 100000}, {speed = 3000}))
hw.check(c:wait(60))                        -- true: the script's own stop ended it
hw.check(opened and c:position("X") < 100000)
print("stopped at " .. c:position("X"))
