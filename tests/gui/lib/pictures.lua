-- Takes a picture of one state in all sizes and both themes: FOLDER/STATE-SIZE-THEME.png
-- Arguments of the scripts that use it: FOLDER [PART-OF-A-NAME [dark|light]]
folder, wanted, only_theme = hw.args[1] or ".", hw.args[2] or "", hw.args[3]
wide = {1440, 900, 1, "1440"}
laptop = {1366, 768, 1, "1366"}
medium = {1024, 700, 1, "1024"}
narrow = {720, 450, 2, "narrow200"}  -- 200 % in a window of 1440x900 pixels
wide_200 = {1440, 900, 2, "wide200"}
huge = {480, 300, 3, "huge300"}          -- 300 % in one of 1440x900: smaller than the look asks for
local usual = {wide, medium, narrow}
with_200 = {wide, medium, narrow, wide_200}
in_all = {wide, medium, narrow, wide_200, huge}

local function window(size)
  ui.window(size[1], size[2], size[3])
  ui.frame(3)
end

-- `make` is done anew at each size, `undo` takes it back. Without them the state is there already.
function pictures(name, make, undo, sizes)
  if not name:find(wanted, 1, true) then return end
  for _, theme in ipairs{"dark", "light"} do
    if not only_theme or only_theme == theme then
      ui.theme(theme)
      for _, size in ipairs(sizes or usual) do
        window(size)
        if make then
          local done, why = pcall(make)
          if not done then print(string.format("%s at %s: %s", name, size[4], why)) end
          ui.frame(3)
        end
        ui.screenshot(string.format("%s/%s-%s-%s.png", folder, name, size[4], theme))
        if undo then
          pcall(undo)
          ui.frame(2)
        end
      end
    end
  end
  ui.theme("dark")
  window(wide)
end

function escape() ui.key("Escape") ui.frame(2) end
function tab(name) if ui.exists("tab/" .. name) then ui.click("tab/" .. name) end end
-- The mouse where it explains nothing.
function aside() ui.click(ui.exists("tab/program") and "tab/program" or "page/connect") ui.frame(2) end
-- What stands in the right column: it lies over the centre in a medium window, and is a tab in a narrow one.
function open_right()
  if ui.exists("rail/open") then ui.click("rail/open") else tab("io") end
  ui.frame(3)
end
function close_right()
  if ui.exists("rail/open") then ui.click("rail/open") else tab("program") end
end
-- Brings a widget of the bench into view without changing anything.
function look_at(id)
  open_right()
  if ui.exists(id) then ui.press(id) ui.release(id) ui.press(id) ui.release(id) end
end
-- Messages that stay until they are read.
function read_messages()
  for _ = 1, 8 do
    local message
    for _, w in ipairs(ui.list()) do
      if w.id:match("^message/close/") then message = w.id end
    end
    if not message or not pcall(ui.click, message) then return end
    ui.frame(2)
  end
end
-- Picks a row of a list by part of its words.
function choose(list, words)
  ui.click(list)
  ui.frame(2)
  for _, w in ipairs(ui.list()) do
    if w.id:sub(1, #list + 1) == list .. "/" and w.label:find(words, 1, true) then
      ui.click(w.id)
      return ui.frame(2)
    end
  end
  error("nothing in " .. list .. " reads " .. words)
end
