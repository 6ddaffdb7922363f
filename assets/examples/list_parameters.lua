-- Lists the parameters that differ from the factory's.
local c = hw.check(hw.open(hw.args[1] or "vxm@emulator"))
c:set("j1M", 1200)
for name, p in pairs(hw.check(c:parameters())) do
  if p.value ~= nil and p.value ~= p.default then
    print(name, p.value, p.unit or "", p.label)
  end
end
