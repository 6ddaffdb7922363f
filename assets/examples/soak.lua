-- Runs an axis to and fro within limits for a while, and looks whether it loses steps.
local a = hw.arguments{about = "Runs an axis to and fro, and looks whether it loses steps.",
  {name = "minutes", kind = "number", default = 5, help = "how long"},
  {name = "speed", kind = "number", default = 4000, help = "steps/s"},
}
local c = hw.check(hw.open("dmx-k-sa@emulator"))
c:send("EO=1")
hw.check(c:limits("X", {minus = -100, plus = 5100}))
local pace = {speed = a.speed, acceleration = 200}   -- ms of the ramp
local rounds = 0
while hw.now() < a.minutes * 60 do
  hw.check(c:move_to({X = 5000}, pace) and c:wait(60))
  hw.check(c:move_to({X = 0}, pace) and c:wait(60))
  hw.check(c:position("X") == 0, "it has lost its place")
  rounds = rounds + 1
end
local gone, why = c:move_to{X = 6000}       -- past the limit: nothing is sent
hw.check(not gone, "the limit holds")
print(rounds .. " rounds; " .. why)
