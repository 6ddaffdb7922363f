-- What a script cannot reach, and what it can.
for _, name in ipairs{"io", "os", "dofile", "loadfile", "package", "debug"} do
  hw.check(_G[name] == nil, name .. " is withheld")
end
hw.check(string.dump == nil, "string.dump is withheld")
hw.check(load("\27Lua") == nil, "no binary chunks")
hw.check(load("return 1 + 1")() == 2, "texts may be loaded")
hw.check(not pcall(collectgarbage, "stop"), "the collector cannot be stopped")
hw.check(collectgarbage("count") > 0)
hw.check(not pcall(setmetatable, {}, {__gc = print}), "no finalizers")
hw.check(not pcall(require, "../sandbox"), "no way up")
hw.check(not pcall(require, "/etc/passwd"), "no absolute paths")
local ok, why = pcall(require, "nowhere")
hw.check(not ok and why:find("there is no nowhere.lua in the script's folder", 1, true), why)
hw.check(require("lib.greet").hello() == "hello", "a module beside the script")
hw.check(require("lib.greet") == require("lib.greet"), "loaded once")

-- pairs goes in order, so that what is sent does not change from run to run
local seen = {}
for k in pairs{b = 1, a = 2, [2] = 3, [1] = 4} do seen[#seen + 1] = tostring(k) end
hw.check(table.concat(seen, " ") == "1 2 a b", table.concat(seen, " "))
local t = {x = 1, y = 2, z = 3}
for k in pairs(t) do t[k] = nil end
hw.check(next(t) == nil, "clearing while walking")

-- chance is the same each time
math.randomseed(7)
local first = math.random(1000000)
math.randomseed(7)
hw.check(math.random(1000000) == first)

-- coroutines of its own are fine, but only the script waits
local wrapped = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
hw.check(wrapped() == 1 and wrapped() == 2)
ok, why = pcall(coroutine.wrap(function() hw.sleep(1) end))
hw.check(not ok and why:find("cannot wait", 1, true), why)
ok, why = pcall(table.sort, {3, 2, 1}, function() hw.sleep(1) end)
hw.check(not ok and why:find("cannot wait", 1, true), why)
hw.check(pcall(hw.sleep, 0.1), "waiting inside pcall")

ok, why = pcall(hw.sleep, "x")
hw.check(not ok and why:find("sleep: argument 1 (seconds) must be a number, not string", 1, true), why)
ok, why = pcall(function() return ui.list end)
hw.check(not ok and why:find("--gui", 1, true), why)
local none, reason = hw.open("nonsense")
hw.check(none == nil and reason:find("MODEL@TRANSPORT", 1, true), reason)
none, reason = hw.open("vxm@serial:/dev/does-not-exist")
hw.check(none == nil and reason:find("/dev/does-not-exist", 1, true), reason)
