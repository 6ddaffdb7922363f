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
