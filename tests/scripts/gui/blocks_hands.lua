-- Blocks under a user's hands on a PMX, a VME58 and a VXM: carried, moved by keys, doubled, left out, grouped, taught, run,
-- held, stepped and stopped, with the one at work lit; and a typed text shown as blocks, or why not.
require("lib.blocks")

ui.window(1440, 1000)

-- The titles in their order: "Speed, Move to, Delay".
local function titles()
  local all = {}
  ui.frame(2)
  for _, w in ipairs(ui.list()) do
    local n = w.id:match("^blocks/(%d+)$")
    if n then all[#all + 1] = w.label end
  end
  return table.concat(all, ", ")
end
local function stand(wanted)
  if not in_time(function() return titles() == wanted end) then error("there are: " .. titles(), 2) end
end
local function enabled(id)
  for _, w in ipairs(ui.list()) do if w.id == id then return w.enabled end end
end
-- The first block that is lit by these words while it runs.
local function lit(n, words)
  return in_time(function()
    local value = ui.value("blocks/" .. n .. "/time")
    return value and value:find(words) ~= nil
  end)
end
local function agree()
  ui.frame(3)
  for _, w in ipairs(ui.list()) do
    if w.id:match("/yes$") or w.id:match("doubt/once$") or w.id:match("/overwrite$") then return ui.click(w.id) end
  end
end
local function run()
  read_messages()
  ui.click("blocks/run")
  for _ = 1, 3 do agree() hw.sleep(0.3) end
end

-- `first`: the block that is at work just after Run. A PMX goes on to the delay while its axes still move.
local machines = {
  {model = "pmx-4ex-sa", x = "X", y = "Y", first = 3, holds = true,
   typed = "ABS\nX500\nDELAY=100\nEND\n", none = "GOSUB 1\nEND\nSUB 1\nDELAY=1\nENDSUB\n", why = "subroutine"},
  {model = "vme58", x = "X", y = "Y", first = 2, typed = "AA\nMA500; GO\nWT100\n",
   none = "AX MR100; GO AY MR100; GO\n", why = "a single axis"},
  {model = "vxm", x = "1", y = "2", first = 2, holds = true, steps = true,
   typed = "IA1M500\nP1\n", none = "JM3\n", why = "goes to another program"},
}
for _, m in ipairs(machines) do
  local c = hw.check(hw.open(m.model .. "@emulator"))
  if m.model == "vxm" then for n = 1, 2 do hw.check(c:set("M" .. n .. "M", 4)) end end
  if m.model == "pmx-4ex-sa" then c:send("EO=15") end
  for _, a in ipairs{m.x, m.y} do c.bench:place(a, {minus = -500000, plus = 500000}) end
  hw.sleep(1)
  local function step(name, work) block(m.model .. ": " .. name, work) end

  step("carried", function()
    blocks("Speed", "Move to", "Delay", "Output")
    stand("Speed, Move to, Delay, Output")
    ui.click("blocks/end")
    ui.drag("blocks/4", "blocks/2", 0.1)
    stand("Speed, Output, Move to, Delay")
    ui.click("blocks/end")
    ui.drag("blocks/2", "blocks/4", 0.9)
    stand("Speed, Move to, Delay, Output")
    ui.click("blocks/undo")
    stand("Speed, Output, Move to, Delay")
    ui.click("blocks/redo")
  end)
  step("moved by keys", function()
    open_block(3)
    ui.key("Alt+Down")
    stand("Speed, Move to, Output, Delay")
    ui.key("Alt+Up")
    stand("Speed, Move to, Delay, Output")
    ui.click("blocks/up")
    stand("Speed, Delay, Move to, Output")
    ui.click("blocks/down")
    stand("Speed, Move to, Delay, Output")
  end)
  step("doubled", function()
    open_block(3)
    ui.key("Ctrl+D")
    stand("Speed, Move to, Delay, Delay, Output")
    ui.click("blocks/remove")
    stand("Speed, Move to, Delay, Output")
    open_block(3)
    ui.click("blocks/duplicate")
    stand("Speed, Move to, Delay, Delay, Output")
    ui.key("Delete")
    stand("Speed, Move to, Delay, Output")
  end)
  step("left out", function()
    open_block(3)
    local before = block_text()
    ui.click("blocks/skip")
    must(in_time(function() return block_text() ~= before end), "its text is left out")
    is("blocks/3/time", "left out")
    ui.key("Escape")
    ui.key("Ctrl+Z")
    writes(before)
    open_block(3)
    ui.click("blocks/skip")
    ui.click("blocks/skip")
    writes(before)
  end)
  step("grouped", function()
    open_block(2)
    ui.key("Shift+Down")
    is("blocks/chosen", "2 blocks are chosen")
    ui.key("Ctrl+G")
    stand("Speed, Loop, Move to, Delay, Output")
    ui.type("blocks/2/times", "3\n")
    open_block(3)
    ui.key("Alt+Up")  -- out of the loop
    stand("Speed, Move to, Loop, Delay, Output")
    ui.key("Alt+Down")
    stand("Speed, Loop, Move to, Delay, Output")
    open_block(2)
    ui.click("blocks/unloop")
    stand("Speed, Move to, Delay, Output")
  end)
  step("taught", function()
    hw.check(c:move_to{[m.x] = 1234} and c:wait(30))
    hw.check(c:move_to{[m.y] = 567} and c:wait(30))
    hw.sleep(0.5)
    open_block(2)
    ui.click("blocks/here")
    is("blocks/2/to/" .. m.x, "1234")
    is("blocks/2/to/" .. m.y, "567")
    must(block_text():find("1234", 1, true), block_text())
  end)
  step("run and lit", function()
    ui.type("blocks/2/to/" .. m.y, "7000\n")
    open_block(3)
    ui.type("blocks/3/ms", "4000\n")
    run()
    must(lit(m.first, "^runs"), "block " .. m.first .. " is lit: " .. tostring(ui.value("blocks/" .. m.first .. "/time")))
    if m.holds then
      ui.click("blocks/hold")
      must(lit(m.first, "held here") or lit(m.first + 1, "held here"), "it is held here")
    end
    if m.steps then
      ui.click("blocks/step")
      must(lit(3, "here") or lit(4, "here"), "one step further")
    end
    if m.holds and not m.steps then ui.click("blocks/run") end  -- Go on
    must(m.holds or not enabled("blocks/hold"), "it cannot be held")
    if not m.steps then must(lit(3, "^runs"), "the delay is lit: " .. tostring(ui.value("blocks/3/time"))) end
    ui.click("blocks/stop")
    must(in_time(function() return not enabled("blocks/stop") end), "it is stopped")
    local value = tostring(ui.value("blocks/3/time"))
    must(not value:find("^runs"), "nothing is lit any more: " .. value)
  end)
  step("text as blocks", function()
    blocks("Delay")
    ui.click("blocks/to_program")
    agree()
    tab("program")
    must(ui.value("program/text") ~= "", "the text went over: " .. ui.value("program/text"))
    -- Some text in place of what the editor has, as blocks.
    local function as_blocks(text)
      tab("program")
      ui.click("program/text")
      ui.key("Ctrl+A")
      ui.key("Delete")
      ui.type("program/text", text)
      tab("blocks")
      ui.click("blocks/from_text")
      agree()
    end
    as_blocks(m.typed)
    stand("Move to, Delay")
    ui.click("blocks/undo")
    stand("Delay")
    as_blocks(m.none)
    said(m.why)
    stand("Delay")
  end)
end

over()
