-- Four motors on one line: each is a controller like any other, and the bus takes their ids as axes.
local c = assert(hw.open("dmx-k-sa@emulator,id=01-04"))
local ids = {"01", "02", "03", "04"}
for _, id in ipairs(ids) do
  hw.check(c.devices[id], "device " .. id)
  hw.check(c:position(id) == 0, "position of " .. id)
end
hw.check(c.devices["05"] == nil, "there is no fifth")
hw.check(c.devices["03"]:query("DN") == "DMK03", "the third answers for itself")

-- Moves of several begin together; each device has its own.
assert(c:move_to{["01"] = 500, ["03"] = -700})
hw.check(c:wait(30))
hw.check(c:position("01") == 500 and c:position("03") == -700, "both have arrived")
hw.check(c:position("02") == 0, "nobody else has moved")
assert(c.devices["02"]:move_by{[1] = 120})
hw.check(c.devices["02"]:wait(30))
hw.check(c:position("02") == 120)

-- One is stopped, the other goes on.
assert(c:jog("01", "+"))
assert(c:jog("04", "-"))
hw.sleep(0.3)
assert(c:stop("01"))
hw.sleep(1)
hw.check(c:status("01").idle and c:status("04").moving, "only 01 has stopped")

-- A stop without an id is one of all.
assert(c:jog("02", "+"))
hw.sleep(0.3)
assert(c:stop())
hw.sleep(1)
for _, id in ipairs(ids) do hw.check(c:status(id).idle, id .. " has stopped") end

-- What needs one device says so.
local ok, why = pcall(c.query, c, "PX")
hw.check(not ok and why:find("c.devices", 1, true), why)
local none, reason = c:position("09")
hw.check(none == nil and reason:find("01, 02, 03, 04", 1, true), reason)
hw.check(c.bench == nil, "a bench belongs to a device")

-- Benches are their own; the cable is everybody's.
c.devices["03"].bench:jam(1)
c.devices["02"].bench:power(false)
hw.sleep(3)
hw.check(c:status("02") == nil, "02 is switched off")
hw.check(c:position("01"), "the others are there")
c.devices["02"].bench:power(true)
hw.sleep(10)
hw.check(c:position("02"), "02 is back")
c.devices["01"].bench:unplug(true)
hw.sleep(1)
for _, id in ipairs(ids) do hw.check(c:position(id) == nil, id .. " is lost") end
c.devices["01"].bench:unplug(false)
hw.sleep(10)
for _, id in ipairs(ids) do hw.check(c:position(id), id .. " is back") end

-- What is sent to all goes out also where the first of them is switched off.
c.devices["01"].bench:power(false)
hw.sleep(3)
hw.check(c:position("01") == nil, "01 is switched off")
assert(c:jog("04", "+"))
hw.sleep(0.5)
assert(c:send("STOP"))
hw.sleep(2)
hw.check(c:status("04").idle, "04 has heard the stop")
