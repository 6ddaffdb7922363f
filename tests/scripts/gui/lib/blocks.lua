-- The blocks of the active controller by hand, with lib.checklist.
require("lib.checklist")

function at_blocks() ui.click("tab/blocks") ui.frame(2) end

-- The blocks are these and no others, added by their names; the last one is open.
function blocks(...)
  at_blocks()
  ui.click("blocks/end")
  ui.frame(30)  -- the list scrolls back
  for _ = 1, 40 do
    if not ui.exists("blocks/1") then break end
    if not ui.exists("blocks/remove") then ui.click("blocks/1") ui.frame(30) end
    ui.click("blocks/remove")
    ui.frame(30)
  end
  for _, name in ipairs{...} do
    ui.type("blocks/add_by_name", name .. "\n")
    ui.frame(2)
  end
end

-- The text that they write, in one line and without its end.
function block_text()
  return (ui.value("blocks/text") or ""):gsub("\n", " | "):gsub("[ |]*END[ |]*$", ""):gsub("[ |]+$", "")
end

function in_time(look)
  for _ = 1, 100 do
    ui.frame(3)
    if look() then return true end
    hw.sleep(0.05)
  end
end

function writes(wanted)
  if not in_time(function() return block_text() == wanted end) then
    error("the blocks write " .. block_text() .. ", expected: " .. wanted, 2)
  end
end

-- The block n is not written, for a reason that has these words.
function refuses(n, why)
  local id = "blocks/" .. n .. "/refusal"
  if not in_time(function() return ui.exists(id) and ui.value(id):find(why, 1, true) end) then
    error((ui.exists(id) and ui.value(id) or "no refusal; " .. block_text()) .. ", expected: " .. why, 2)
  end
end

-- Opens the block n, whichever is open.
function open_block(n)
  ui.click("blocks/end")
  ui.click("blocks/" .. n)
  ui.frame(2)
end

-- "blocks/1/high = 4000" is typed, "blocks/1/on/off" is clicked, 2 opens the second block.
function set(words)
  if type(words) == "number" then return open_block(words) end
  local id, value = words:match("^(%S+) = (.*)$")
  if id then ui.type(id, value .. "\n") else ui.click(words) end
  ui.frame(2)
end

-- Into a file, and out of it into empty blocks: the text is the same.
function saved_and_opened(path)
  local before = block_text()
  ui.click("blocks/save")
  file(path)
  said("Saved as")
  read_messages()
  blocks()
  writes(before:match("^AA") and "AA" or "")
  ui.click("blocks/open")
  file(path)
  if ui.exists("blocks/discard/yes") then ui.click("blocks/discard/yes") end
  writes(before)
end

-- What was done to them since is taken back, change by change, and made again.
function undone(to)
  local after, changes = block_text(), 0
  while block_text() ~= to and changes < 20 do
    ui.click("blocks/undo")
    changes = changes + 1
    in_time(function() return block_text() ~= after end)
  end
  must(block_text() == to, "undo leads to " .. block_text() .. ", expected: " .. to)
  for _ = 1, changes do ui.click("blocks/redo") ui.frame(3) end
  writes(after)
end
