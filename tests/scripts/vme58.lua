-- A wait lasts until the board has worked off what it was sent, and its words say what is amiss.
local c = assert(hw.open("vme58@emulator"))

local function same(got, wanted, what)
  hw.check(got == wanted, what .. ": " .. tostring(got) .. " instead of " .. tostring(wanted))
end
local function takes(text, at_least, where)
  local began = hw.now()
  c:send(text)
  same(c:wait(20), true, text)
  hw.check(hw.now() - began > at_least, text .. " was waited for")
  same(c:position("X"), where, text)
end
takes("AX VL1000 AC10000 MR1000 GO", 1, 1000)
takes("AX WT1000 MR10 GO", 1, 1010)
takes("MR500 GO WT2000 MR500 GO", 3, 2010)

-- the axis belongs to the name of a parameter
local value, why = c:get("KP")
hw.check(value == nil and why:find("Say which axis: KPX to KPS", 1, true), why)
same(select(2, c:get("nope")):find("which axis"), nil, "no such parameter at all")

-- a program that is rejected has not ended well
hw.check(c:load("AX VL1000 MA99999999 GO ID"))
c:run(0)
local ended, why_ended = c:wait(20)
hw.check(ended == nil and why_ended:find('rejected "MA99999999"', 1, true), why_ended)

-- what waited in a queue and is rejected when its turn comes is blamed on nothing else
hw.check(c:load("AX VL1000 AC10000\nMR10 GO\nMP MV500,500\nMV100,500\nSP0\nMR20 GO"))
c:run(0)
ended, why_ended = c:wait(20)
hw.check(ended == nil and not why_ended:find("RQ", 1, true), "a late rejection: " .. tostring(why_ended))
hw.check(c:load("AX VL1000 AC10000\nMR10 GO\nMP MV500,500\nMV100,500\nSP0\n" .. ("MR1 GO\n"):rep(150)))
c:run(0)
ended, why_ended = c:wait(60)
hw.check(ended == nil and why_ended:find("when a queue reached it", 1, true), "a late rejection: " .. tostring(why_ended))
c:stop()
c:wait(20)

-- a text that is refused is told by the wait behind it, once
c:send("AX QQ17 ")
ended, why_ended = c:wait(20)
hw.check(ended == nil and why_ended:find("QQ17", 1, true), "a refused text: " .. tostring(why_ended))
same(c:wait(20), true, "it is told once")

-- user units and the selected axis stay on the board through a pulled cable
c:send("AX LP0 UU10 AY LP0 VL1000 ")
same(c:wait(20), true, "units are on")
c.bench:unplug(true)
hw.sleep(2)
c.bench:unplug(false)
hw.sleep(5)
hw.check(c:move_to{X = 200})
same(c:wait(20), true, "200 counts")
same(c:position("X"), 200, "not 200 units")
c:send("MR100 GO ")
same(c:wait(20), true, "the selected axis")
same(c:position("Y"), 100, "is Y still")

-- a slip is a flag of its axis until it is cleared
c.bench:place("Z", {motor = true})
c:send("AZ HN KP2 KD8 ES20 TN VL2000 ")
same(c:wait(20), true, "slip is watched")
c.bench:jam("Z", true)
c:send("AZ MR2000 GO ")
c:wait(20)
hw.sleep(0.5)
same(c:status("Z").slip, true, "Z is jammed")
same(c:status("Y").slip, false, "Y is not")
c.bench:jam("Z", false)
c:send("IC ")
c:wait(20)
hw.sleep(0.5)
same(c:status("Z").slip, false, "IC clears it")
