-- What the checklists of the makers' programs have in common: one block per line of the list, that works the widget as a
-- hand would and looks at the wire, or changes what a readout tells and looks at the readout.
local failed = {}

-- ---- messages and dialogs that may lie over what is used next

-- The messages on the screen, newest last: {id=, value=}.
local function messages()
  local found = {}
  for _, w in ipairs(ui.list()) do
    if w.id:match("^toast/") then found[#found + 1] = w end
  end
  return found
end

function read_messages()
  for _ = 1, 8 do
    local all = messages()
    if #all == 0 or not pcall(ui.click, "message/close/" .. all[#all].id:match("%d+")) then break end
  end
end

local function clear_log() return not ui.exists("terminal/clear") or pcall(ui.click, "terminal/clear") end

-- Closes what the block before has left open. What is found in the terminal afterwards was sent since.
local function put_away()
  read_messages()
  if clear_log() then return end
  ui.key("Escape")
  ui.frame(2)
  clear_log()
end

-- ---- blocks

function block(id, work)
  put_away()
  local ok, why = pcall(work)
  if not ok then
    failed[#failed + 1] = id .. ": " .. tostring(why)
    hw.log(failed[#failed])
  end
end

function over() hw.check(#failed == 0, #failed .. " lines of the checklist failed: " .. table.concat(failed, "; ")) end

function must(true_enough, why)
  if not true_enough then error(why, 2) end
end

-- ---- looking

-- Tries for ten seconds; the last answer of `look` is given back.
local function in_time(look, level)
  local good, what
  for _ = 1, 200 do
    good, what = look()
    if good then return good end
    hw.sleep(0.05)
  end
  error(what, (level or 1) + 2)
end

-- Brings it into view: a readout that nobody can see is asked for only now and then.
function look_at(id)
  if id:match("^readout/") then pcall(ui.click, id) end
end

-- The widget shows something that the pattern matches.
function shows(id, pattern)
  look_at(id)
  return in_time(function()
    local value = ui.value(id)
    return value and value:find(pattern) and value, id .. " shows " .. tostring(value) .. ", not " .. pattern
  end)
end

-- The widget shows just this.
function is(id, text)
  text = tostring(text)
  look_at(id)
  return in_time(function()
    local value = ui.value(id)
    return value == text, id .. " shows " .. tostring(value) .. ", not " .. text
  end)
end

-- What the widget shows does not stay as it is.
function changes(id)
  local before = ui.value(id)
  return in_time(function()
    local value = ui.value(id)
    return value ~= before and value, id .. " still shows " .. tostring(before)
  end)
end

-- A message that has these words came up.
function said(words)
  return in_time(function()
    local all = {}
    for _, m in ipairs(messages()) do
      if m.value:find(words, 1, true) then return m.value end
      all[#all + 1] = m.value
    end
    return false, "no message has \"" .. words .. "\", but: " .. table.concat(all, " | ")
  end)
end

-- ---- the wire

-- "12:00:01.234 > @01PX=0<cr>    ..." -> "@01PX=0"
local function line_sent(line) return line:match("^%S+ > (.-)<%w+>") end

local function logged(text)
  for line in (ui.value("terminal/log") or ""):gmatch("[^\n]+") do
    local whole = line_sent(line)
    if whole and (whole == text or whole:gsub("^@%d%d", "") == text) then return true end
  end
end

-- Just this command went out since the block began, with or without the address in front. The terminal's filter finds it
-- when polls have pushed it out of sight.
function sent(text)
  for _ = 1, 3 do
    ui.frame(2)
    if logged(text) then return end
  end
  read_messages()
  ui.type("terminal/filter", text .. "<cr>")
  local found
  for _ = 1, 200 do
    found = logged(text)
    if found then break end
    hw.sleep(0.05)
  end
  local log = ui.value("terminal/log")
  read_messages()
  ui.type("terminal/filter", "")
  if not found then error("not on the wire: " .. text .. "\n" .. tostring(log), 2) end
end

-- ---- hands

function choose(id, name)
  ui.click(id)
  ui.click(id .. "/" .. name)
end

function fill(id, text) ui.type(id, text) end

function tab(name)
  put_away()
  ui.click("tab/" .. name)
end

-- Opens a list and takes its nth row.
function pick(id, n)
  ui.click(id)
  local rows = {}
  for _, w in ipairs(ui.list()) do
    if w.id:sub(1, #id + 1) == id .. "/" then rows[#rows + 1] = w.id end
  end
  if not rows[n] then error(id .. " has " .. #rows .. " rows, not " .. n, 2) end
  ui.click(rows[n])
end

-- Types a command into the terminal.
function command(text) ui.type("terminal/command", text .. "\n") end

-- Puts another text into the program editor, whatever is there.
function write_program(text)
  ui.click("program/new")
  if ui.exists("program/replace/yes") then ui.click("program/replace/yes") end
  is("program/text", "")
  if text ~= "" then fill("program/text", text) end
end

-- Sends it down, over whatever the controller holds.
function download()
  ui.click("program/download")
  hw.sleep(1)
  if ui.exists("program/ask/overwrite") then ui.click("program/ask/overwrite") end
  said("The controller holds this program now.")
end

-- Answers the file dialog that is open; an older file of that name is written over.
function file(path)
  ui.type("file/path", path .. "\n")
  ui.frame(2)
  if ui.exists("file/sentence") and ui.value("file/sentence"):find("exists already") then ui.click("file/save") end
  must(not ui.exists("file/path"), "the dialog is still open: " .. tostring(ui.value("file/sentence")))
end

-- ---- the set-up

local function write_changes()
  ui.click("setup/write")
  if ui.exists("setup/confirm/yes") then ui.click("setup/confirm/yes") end
  in_time(function() return not ui.value("setup/state"):find("not written"), "not written: " .. ui.value("setup/state") end, 2)
end

-- Parameters typed (a text), chosen (the nth), or by bits to turn round (a table), written together and seen on the wire:
-- set_params{{"HS", "4000", "HS=4000"}, {"SCVX", 2, "SCVX=1"}, {"POX", {0, 3}, "POX=14"}}
function set_params(all)
  tab("setup")
  for _, p in ipairs(all) do
    local id = "setup/" .. p[1]
    if type(p[2]) == "string" then
      fill(id, p[2] .. "\n")
    elseif type(p[2]) == "number" then
      pick(id, p[2])
    else
      for _, bit in ipairs(p[2]) do ui.click(id .. "/" .. bit) end
    end
  end
  write_changes()
  for _, p in ipairs(all) do sent(p[3]) end
end

function set_param(mnemonic, value, on_wire) set_params{{mnemonic, value, on_wire}} end
