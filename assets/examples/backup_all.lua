-- Writes the set-up and the programs of each controller into a file beside this script, and reads one back.
for name, address in pairs{
  stage = "vxm@emulator", table = "pmx-4ex-sa@emulator", slide = "dmx-k-sa@emulator", board = "vme58@emulator",
} do
  local c = hw.check(hw.open(address))
  hw.check(c:backup(name .. ".toml"))
  print(name, #c:axes() .. " axes")
end
local c = hw.check(hw.open("vxm@emulator"))
c:set("j1M", 777)
hw.check(c:restore("stage.toml"))
hw.check(c:get("j1M") ~= 777)
