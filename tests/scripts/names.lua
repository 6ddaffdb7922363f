-- What a controller has, by name; and what is said of a name that it has not.
local function refused(words, ok, why)
  hw.check(ok == nil and why:find(words, 1, true), tostring(why))
end

for _, kind in ipairs{
  {"vxm@emulator", {"1", "2"}, "j1M", "jM1"}, {"pmx-4ex-sa@emulator", {"X", "Y", "Z", "U"}, "HSX", "HSXX"},
  {"dmx-k-sa@emulator", {"X"}, "HSPD", "HSDP"}, {"vme58@emulator", {"X", "Y", "Z", "T", "U", "V", "R", "S"}, "VLX", "VLXX"},
} do
  local address, names, known, slip = table.unpack(kind)
  local c = assert(hw.open(address))
  hw.check(table.concat(c:axes(), " ") == table.concat(names, " "), address .. ": " .. table.concat(c:axes(), " "))
  local all = assert(c:parameters())
  local one = all[known]
  hw.check(one and one.label and one.min < one.max, address .. " has " .. known)
  local count, read = 0, 0
  for _, p in pairs(all) do
    hw.check(p.label and p.min ~= nil and p.max ~= nil and p.default ~= nil)
    count = count + 1
    if p.value ~= nil then read = read + 1 end
  end
  hw.check(count > 10 and read > count / 3, string.format("%s: %d, %d read", address, count, read))
  hw.check(one.value == c:get(known), address .. ": as c:get reads it")

  refused('Did you mean "' .. known .. '"?', c:get(slip))
  refused('Did you mean "' .. known .. '"?', c:set(slip, 1))
  local ok, why = c:get("nothing like it")
  hw.check(not ok and not why:find("Did you mean"), why)
  refused("There is no such axis.", c:jog("axis", "+"))
end

local c = hw.open("pmx-4ex-sa@emulator")
refused('Did you mean "X"?', c:position("x"))
refused('Did you mean "U"?', c:move_to{u = 5})
local bus = hw.open("dmx-k-sa@emulator,id=01-02")
hw.check(table.concat(bus:axes(), " ") == "01 02")
