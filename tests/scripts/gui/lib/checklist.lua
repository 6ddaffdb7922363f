-- What the checklists of the makers' programs have in common: one block per line of the list, that works the widget as a
-- hand would and looks at the wire.
local list = {c = nil}

local failed = {}

-- Reads messages away: they may lie over what is used next.
function read_messages()
  for _ = 1, 8 do
    local message
    for _, w in ipairs(ui.list()) do
      if w.id:match("^toast/") then message = w.id end
    end
    if not message then break end
    if not pcall(ui.click, message) then break end
    ui.frame(2)
  end
end

-- The same, and closes what is still open.
function put_away()
  read_messages()
  if ui.exists("terminal/clear") and not pcall(ui.click, "terminal/clear") then
    ui.key("Escape")  -- a list or dialog that the block before has left open
    ui.frame(2)
  end
end

-- Empties the terminal, so that what is found there afterwards was sent by this block.
function block(id, work)
  put_away()
  if ui.exists("terminal/clear") then pcall(ui.click, "terminal/clear") end
  ui.frame(2)
  local ok, why = pcall(work)
  if not ok then failed[#failed + 1] = id .. ": " .. tostring(why) end
end

function over()
  for _, line in ipairs(failed) do hw.log(line) end
  hw.check(#failed == 0, #failed .. " lines of the checklist failed: " .. table.concat(failed, "; "))
end

function must(true_enough, why)
  if not true_enough then error(why, 2) end
end

-- The text went out since the block began. The terminal's filter finds it among the polls.
function sent(text)
  read_messages()
  ui.type("terminal/filter", text)
  local log
  for _ = 1, 20 do
    ui.frame(2)
    log = ui.value("terminal/log") or ""
    if log:find(text, 1, true) then break end
    hw.sleep(0.1)
  end
  read_messages()
  ui.type("terminal/filter", "")
  if not log:find(text, 1, true) then error("not on the wire: " .. text, 2) end
end

-- The widget shows something that the pattern matches, at once or within three seconds.
function shows(id, pattern)
  local value
  for _ = 1, 30 do
    value = ui.value(id)
    if value and value:find(pattern) then return value end
    hw.sleep(0.1)
  end
  error(id .. " shows " .. tostring(value) .. ", not " .. pattern, 2)
end

function there(id)
  if not ui.exists(id) then error(id .. " is not there", 2) end
end

-- Chooses one of a drop-down list.
function choose(id, name)
  ui.click(id)
  ui.click(id .. "/" .. name)
end

function fill(id, text)
  ui.type(id, text)
end

function tab(name)
  put_away()
  ui.click("tab/" .. name)
  ui.frame(2)
end

-- Opens a list and takes its nth row.
function pick(id, n)
  ui.click(id)
  ui.frame(2)
  local rows = {}
  for _, w in ipairs(ui.list()) do
    if w.id:sub(1, #id + 1) == id .. "/" then rows[#rows + 1] = w.id end
  end
  if not rows[n] then error(id .. " has " .. #rows .. " rows, not " .. n, 2) end
  ui.click(rows[n])
end

-- A parameter in Setup, typed (a text) or chosen (the nth), written, and seen on the wire.
function set_param(mnemonic, value, on_wire)
  tab("setup")
  fill("setup/filter", mnemonic)
  ui.frame(2)
  if type(value) == "string" then
    fill("setup/" .. mnemonic, value .. "\n")
  else
    pick("setup/" .. mnemonic, value)  -- the nth choice
  end
  write_changes()
  sent(on_wire)
end

function write_changes()
  ui.click("setup/write")
  ui.frame(3)
  if ui.exists("setup/confirm/yes") then ui.click("setup/confirm/yes") end
  hw.sleep(0.5)
end

-- A bit of a bit field.
function flip(mnemonic, bit, on_wire)
  tab("setup")
  fill("setup/filter", mnemonic)
  ui.frame(2)
  ui.click("setup/" .. mnemonic .. "/" .. bit)
  write_changes()
  sent(on_wire or (mnemonic .. "="))
end

return list
