-- Writes the set-up and the programs of each controller into a file beside this script, and reads one back.
local a = hw.arguments{about = "Writes the set-up and the programs of controllers into files.",
  {name = "stage", default = "vxm@emulator", help = "its address"},
  {name = "table", default = "pmx-4ex-sa@emulator", help = "its address"},
  {name = "slide", default = "dmx-k-sa@emulator", help = "its address"},
  {name = "board", default = "vme58@emulator", help = "its address"},
}
for name, address in pairs(a) do
  local c = hw.check(hw.open(address))
  hw.check(c:backup(name .. ".toml"))
  print(name, #c:axes() .. " axes")
end
local c = hw.check(hw.open("vxm@emulator")) -- another one, with the same set-up
hw.check(c:set("j1M", 777))
hw.check(c:restore("stage.toml"))
hw.check(c:get("j1M") ~= 777)
