-- Runs an axis to and fro within limits for a while, and looks whether it loses steps.
local a = hw.arguments{about = "Runs an axis to and fro, and looks whether it loses steps; each round goes into soak.csv.",
  {name = "address", default = "dmx-k-sa@emulator", help = "the controller"},
  {name = "minutes", kind = "number", default = 5, help = "how long"},
  {name = "speed", kind = "number", default = 4000, help = "steps/s"},
}
local c = hw.check(hw.open(a.address))
hw.check(c:query("EO=1"))                   -- motor power
hw.check(c:limits("X", {minus = -100, plus = 5100}))
local pace = {speed = a.speed, acceleration = 200}   -- ms of the ramp
local rows = {{"s", "steps", "encoder"}}
while hw.now() < a.minutes * 60 do
  hw.check(c:move_to({X = 5000}, pace) and c:wait(60))
  hw.check(c:move_to({X = 0}, pace) and c:wait(60))
  rows[#rows + 1] = {hw.now(), c:position("X"), c:encoder("X")}
  hw.check(c:position("X") == 0, "it has lost its place")
end
hw.check(hw.write_csv("soak.csv", rows))
local gone, why, more = c:move_to{X = 6000} -- past the limit: nothing is sent
hw.check(not gone and more.kind == "refused", "the limit holds")
print(#rows - 1 .. " rounds; " .. why)
