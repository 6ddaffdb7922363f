-- Lists the parameters that differ from the factory's.
local a = hw.arguments{about = "Lists the parameters that differ from the factory's.",
  {name = "address", default = "vxm@emulator", help = "the controller"},
}
local c = hw.check(hw.open(a.address))
if c.bench then c:set("j1M", 1200) end       -- so that there is one
for name, p in pairs(hw.check(c:parameters())) do
  if p.value ~= nil and p.value ~= p.default then
    print(name, p.value, p.unit or "", p.label)
  end
end
