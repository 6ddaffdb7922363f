-- A rehearsal speaks for the axes as they stand, or says that it does not.
local function value(id) return ui.exists(id) and ui.value(id) or "" end
local function expect(id, words)
  hw.check(value(id):find(words, 1, true), id .. ": " .. value(id) .. ", expected: " .. words)
end
local function rehearse(text)
  ui.click("tab/program")
  ui.click("program/text")
  ui.key("Ctrl+A") ui.key("Delete")
  ui.type("program/text", text)
  ui.click("program/simulate")
  hw.sleep(0.5)
end

-- By model: the axis, a text that moves it by 90,000, one that moves it by 100, and how many of its positions
-- are a step of the bench (a closed loop counts its encoder).
local languages = {
  {"vxm@emulator", 1, "I1M90000", "I1M100"},
  {"pmx-4ex-sa@emulator", "X", "PRG 0\nEO=15\nINC\nX90000\nWAITX\nEND", "PRG 0\nEO=15\nINC\nX100\nWAITX\nEND"},
  {"dmx-k-sa@emulator", "X", "PRG 0\nEO=1\nINC\nX90000\nWAITX\nEND", "PRG 0\nEO=1\nINC\nX100\nWAITX\nEND", 1.25},
  {"vme58@emulator", "X", "AX VL50000 AC500000\nMR90000 GO ID", "AX VL50000 AC500000\nMR100 GO ID"},
}

for _, language in ipairs(languages) do
  local address, axis, far, near, counts = table.unpack(language)
  local function plus(position) return {plus = math.floor(position / (counts or 1))} end
  hw.log(address)
  local c = hw.check(hw.open(address))
  if address:find("vxm") then c:set("M1M", 4) end
  c.bench:place(axis, plus(100000))
  hw.sleep(0.2)
  rehearse(far)
  expect("rehearsal/begins", "at 0")
  expect("rehearsal/limits", "none touched")

  -- It stands at 20,000, and the limit at 100,000: the same text runs onto it.
  hw.check(c:move_to{[axis] = 20000})
  ui.frame(5)
  expect("rehearsal/limits", "not judged")
  expect("rehearsal/stand", "is moving")
  hw.check(c:wait(60))
  ui.frame(2)
  expect("rehearsal/limits", "not judged")
  expect("rehearsal/stand", "Rehearsed from 0; axis " .. axis .. " stands at 20000 ")
  ui.click("rehearsal/again")
  hw.sleep(0.5)
  expect("rehearsal/limits", "touched")
  hw.check(not value("rehearsal/limits"):find("none", 1, true))
  expect("rehearsal/begins", "where the axes stand")
  expect("rehearsal/stop/1", "Line ")
  expect("rehearsal/stop/1", "runs into its plus limit switch.")
  hw.check(not ui.exists("rehearsal/again"))

  rehearse(near)
  expect("rehearsal/limits", "none touched")
  -- A switch that is placed elsewhere takes it back too.
  c.bench:place(axis, plus(20050))
  hw.sleep(0.2)
  expect("rehearsal/stand", "Switches on the bench have been moved since")
  ui.click("rehearsal/again")
  hw.sleep(0.5)
  expect("rehearsal/limits", "touched")

  -- Run rehearses it again, from where it begins; at the end the axis stands elsewhere.
  c.bench:place(axis, plus(100000))
  hw.sleep(0.2)
  ui.click("program/run")
  hw.sleep(5)
  expect("rehearsal/stand", "Rehearsed from 20000; axis " .. axis .. " stands at 20100 ")
  ui.click("menu") ui.click("menu/close")
  hw.sleep(0.2)
end

-- It begins from all that is known of the controller: what has changed since is named.
local c = hw.check(hw.open("vxm@emulator"))
c:set("M1M", 4)
hw.sleep(5)
rehearse("I1M100")
expect("program/rehearsed", "Rehearsed: this text")
expect("rehearsal/assumed", "S1M: 2000 steps/s")
hw.check(c:set("Bx", 9))
hw.sleep(0.5)
expect("rehearsal/stand", "Rehearsed with Bx 0 steps; it is 9 steps now")
expect("program/rehearsed", "Rehearsed before a parameter was changed.")
ui.click("rehearsal/again")
hw.sleep(0.5)
expect("program/rehearsed", "Rehearsed: this text")
c.bench:input(1, true)
hw.sleep(1)
expect("rehearsal/stand", "Rehearsed with In 1 high; it is low now")
