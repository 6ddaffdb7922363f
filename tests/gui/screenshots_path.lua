-- Pictures of a path in three axes and of running the rest of it, to be looked at; from the root of the house:
--   build/handwheel run --gui tests/gui/screenshots_path.lua FOLDER [PART-OF-A-NAME [dark|light]]
require("lib.pictures")

local c = assert(hw.open("pmx-4ex-sa@emulator"))
hw.sleep(1)
tab("blocks")
ui.click("blocks/open")
ui.type("file/path", "tests/gui/lib/pocket.toml")
ui.click("file/open")
hw.sleep(0.5)
ui.click("blocks/to_program")
tab("path")
ui.click("path/simulate")
hw.sleep(1)
ui.click("path/tool") ui.click("path/tool/DO5")
hw.sleep(0.5)
pictures("two-axes", function() tab("path") end)
ui.click("path/third") ui.click("path/third/Z")
hw.sleep(0.5)
for _, from in ipairs{"top", "front", "side", "iso"} do
  pictures("from-" .. from, function() tab("path") ui.click("path/view/" .. from) ui.frame(3) end)
end
