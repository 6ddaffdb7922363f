-- What the checklists of both Arcus programs work in the same way; `c` is the controller that is worked.
local arcus = {}

arcus.counting = "WHILE 1=1\nV1=V1+1\nDELAY=100\nENDWHILE\nEND\n"

-- ---- inputs and outputs

function arcus.inputs_follow(c, count)
  for n = 1, count do
    is("io/in/" .. n, "low")
    c.bench:input(n, true)
    is("io/in/" .. n, "high")
    c.bench:input(n, false)
    is("io/in/" .. n, "low")
  end
end

function arcus.output_switches(n)
  ui.click("io/out/" .. n)
  sent("DO" .. n .. "=1")
  is("io/out/" .. n, "on")
  ui.click("io/out/" .. n)
  sent("DO" .. n .. "=0")
  is("io/out/" .. n, "off")
end

-- ---- the program and its editor

local function editor_height()
  for _, w in ipairs(ui.list()) do
    if w.id == "program/text" then return w.rectangle.height end
  end
end

function arcus.editor_grows()
  local was = editor_height()
  ui.click("splitter/below")
  ui.key("Tab")
  ui.key("Shift+Tab")
  ui.key("-")
  ui.key("-")
  must(editor_height() > was, "the editor is larger")
end

-- The compiled lines, as they are shown.
function arcus.listing()
  local lines = {}
  ui.click("program/view")
  for line in shows("program/listing", "V1"):gmatch("[^\n]+") do lines[#lines + 1] = line end
  must(#lines == tonumber(ui.value("program/memory"):match("^%d+")), "as many lines as the meter says")
  ui.click("program/view")
  return lines
end

function arcus.lines_go_down(listing)
  download()
  for n, line in ipairs(listing) do sent("SA" .. n - 1 .. "=" .. line) end
end

function arcus.text_comes_back(text)
  write_program("")
  ui.click("program/upload")
  said("was loaded from")
  sent("SA0")
  is("program/text", text)
end

function arcus.is_emptied(c)
  must(c:query("SA0") ~= "", "there is a program")
  ui.click("program/empty")
  ui.click("program/clear/yes")
  said("in the controller is empty")
  sent("SA0=")
  must(c:query("SA0") == "", "there is none any more")
end

-- ---- threads

local on_wire = {run = 1, stop = 0, pause = 2, continue = 3}
local then_is = {run = "RUNNING", stop = "IDLE", pause = "PAUSED", continue = "RUNNING"}

local function press(n, button)
  ui.click("thread/" .. n .. "/" .. button)
  sent("SR" .. n .. "=" .. on_wire[button])
end

function arcus.thread(n, button)
  press(n, button)
  is("thread/" .. n .. "/state", then_is[button])
end

function arcus.threads_run_at_once(count)
  local text = ""
  for n = 0, count - 1 do text = text .. ("PRG %d\nWHILE 1=1\nV%d=V%d+1\nDELAY=50\nENDWHILE\nEND\n"):format(n, n, n) end
  write_program(text)
  download()
  for n = 0, count - 1 do press(n, "run") end
  for n = 0, count - 1 do
    is("thread/" .. n .. "/state", "RUNNING")
    changes("thread/" .. n .. "/line")
  end
  for n = 0, count - 1 do arcus.thread(n, "stop") end
end

-- ---- variables and the set-up

function arcus.variables_by_command()
  fill("var/command", "V12=440\n")
  sent("V12=440")
  is("var/12", 440)
  fill("var/command", "V[99]=-5\n")
  sent("V99=-5")
  is("var/99", -5)
end

function arcus.setup_is_stored()
  must(ui.exists("status/unsaved"), "that it is not stored is said")
  ui.click("setup/store")
  sent("STORE")
  said("Stored in the controller.")
  must(not ui.exists("status/unsaved"), "it is stored")
end

-- For good: what is said then names these things to look at.
function arcus.falls_silent(c, supply, wires)
  c.bench:drop(100000000)
  hw.sleep(12)
  local why = shows("status/text", "supply")
  must(why:find(supply, 1, true) and why:find(wires, 1, true), why)
end

return arcus
