-- Every object of the maker's graphical programmer with each of its settings, on the controllers beside the one that
-- checklist_blocks.lua works: what the blocks write then, or why not. Where a setting stands without text here, the
-- controller cannot do it, and its sentence has these words.
require("lib.blocks")

ui.window(1440, 1000)
local function works(row)
  local list, sets, wanted, why = row[1], row[2], row[3], row[4]
  blocks(table.unpack(list))
  for _, words in ipairs(sets) do set(words) end
  if why then refuses(#list, why) else writes(wanted) end
end

-- ---- what each writes

local function of_one()  -- an Arcus with one axis
  return {
    {{"Speed"}, {"blocks/1/high = 4000", "blocks/1/low = 400", "blocks/1/ramp_ms = 200"}, "HSPD=4000 | LSPD=400 | ACC=200"},
    {{"Move to"}, {"blocks/1/to/X = 100"}, "ABS | X100"},
    {{"Move by"}, {"blocks/1/to/X = -100"}, "INC | X-100"},
    {{"Move to"}, {"blocks/1/own/its own", "blocks/1/high = 2500", "blocks/1/low = 250", "blocks/1/ramp_ms = 150"},
     "HSPD=2500 | LSPD=250 | ACC=150 | ABS | X0"},
    {{"Jog"}, {"blocks/1/direction/+"}, "JOGX+"},
    {{"Jog"}, {"blocks/1/direction/-"}, "JOGX-"},
    {{"Jog"}, {"blocks/1/own/its own", "blocks/1/high = 2500", "blocks/1/low = 250", "blocks/1/ramp_ms = 150"},
     "HSPD=2500 | LSPD=250 | ACC=150 | JOGX+"},
    {{"Home"}, {"blocks/1/direction/+"}, "HOMEX+"},
    {{"Home"}, {"blocks/1/direction/-"}, "HOMEX-"},
    {{"Home"}, {"blocks/1/own/its own", "blocks/1/high = 2500"}, "HSPD=2500 | HOMEX-"},
    {{"Stop"}, {}, "STOPX"},
    {{"Stop"}, {"blocks/1/at_once/yes", "blocks/1/axis/X"}, "ABORTX"},
    {{"Until still"}, {"blocks/1/axis/X"}, "WAITX"},
    {{"Delay"}, {"blocks/1/ms = 1234"}, "DELAY=1234"},
    {{"Wait for input"}, {"blocks/1/input = 2"}, "WHILE DI2=0 | ENDWHILE"},
    {{"Wait for input"}, {"blocks/1/on/off"}, "WHILE DI1=1 | ENDWHILE"},
    {{"Move on input"}, {"blocks/1/input = 3", "blocks/1/on/off", "blocks/1/to = 70"}, "ABS | IF DI3=0 |   X70 | ENDIF"},
    {{"Move on input"}, {"blocks/1/stops_first/yes"}, "ABS | IF DI1=1 |   STOPX |   WAITX |   X0 | ENDIF"},
    {{"Move on input"}, {"blocks/1/kind/jog", "blocks/1/direction/-"}, "IF DI1=1 |   JOGX- | ENDIF"},
    {{"Move on input"}, {"blocks/1/kind/home", "blocks/1/direction/+"}, "IF DI1=1 |   HOMEX+ | ENDIF"},
    {{"Move on input"}, {"blocks/1/own/its own", "blocks/1/high = 2500"}, "HSPD=2500 | ABS | IF DI1=1 |   X0 | ENDIF"},
    {{"Output"}, {"blocks/1/output = 2", "blocks/1/on/off"}, "DO2=0"},
    {{"Output"}, {"blocks/1/output/which/all", "blocks/1/value = 3"}, "DO=3"},
    {{"Motor power"}, {}, "EO=1"},
    {{"Motor power"}, {"blocks/1/on/off"}, "EO=0"},
    {{"Own text"}, {"blocks/1/about = count", "blocks/1/text = V1=V1+1"}, "V1=V1+1"},
    {{"Delay"}, {"blocks/loop", "blocks/1/times = 0"}, "WHILE 1=1 |   DELAY=500 | ENDWHILE"},
    never = {arc = "one axis", circle = "one axis", speed_stairs = "stairs"}}
end

local no_low = "A VXM has no low speed"
local vxm = {
  {{"Speed"}, {"blocks/1/high = 4000", "blocks/1/ramp_ms = 200"}, "S1M4000 | A1M20 | S2M4000 | A2M20"},
  {{"Speed"}, {"blocks/1/low = 400"}, nil, no_low},
  {{"Move to"}, {"blocks/1/to/1 = 100", "blocks/1/to/2 = 200"}, "IA1M100 | IA2M200"},
  {{"Move by"}, {"blocks/1/to/1 = ", "blocks/1/to/2 = -100"}, "I2M-100"},
  {{"Move by"}, {"blocks/1/to/1 = 100", "blocks/1/own/its own", "blocks/1/high = 2500", "blocks/1/ramp_ms = 150"},
   "S1M2500 | A1M17 | I1M100"},
  {{"Home"}, {}, "I1M-0 | IA1M-0"},
  {{"Home"}, {"blocks/1/axis/2", "blocks/1/direction/+"}, "I2M0 | IA2M-0"},
  {{"Home"}, {"blocks/1/own/its own", "blocks/1/high = 2500"}, "S1M2500 | I1M-0 | IA1M-0"},
  {{"Delay"}, {"blocks/1/ms = 1234"}, "P-12340"},
  {{"Delay"}, {"blocks/1/ms = 1200"}, "P12"},
  {{"Wait for input"}, {"blocks/1/input = 2"}, "PM-0 | JM1 | PM-1 ; waits until input 2 is on | P-10 | U22 | L0"},
  {{"Wait for input"}, {"blocks/1/input = 2", "blocks/1/on/off"},
   "PM-0 | JM1 | PM-1 ; waits until input 2 is off | P-10 | U12 | L0"},
  {{"Move on input"}, {"blocks/1/input = 2", "blocks/1/axis/2", "blocks/1/to = 4321"}, "U12 | IA2M4321"},
  {{"Move on input"}, {"blocks/1/input = 2", "blocks/1/on/off"}, "U22 | IA1M0"},
  {{"Move on input"}, {"blocks/1/own/its own", "blocks/1/high = 2500"}, "S1M2500 | U11 | IA1M0"},
  {{"Move on input"}, {"blocks/1/kind/home", "blocks/1/direction/-"},
   "PM-0 | U11 | JM1 | PM-1 ; motor 1 to its limit switch | I1M-0 | IA1M-0"},
  {{"Move on input"}, {"blocks/1/kind/jog"}, nil, "A stored program of a VXM has no jog"},
  {{"Output"}, {"blocks/1/on/off"}, "U4"},
  {{"Output"}, {"blocks/1/output = 2"}, "U15"},
  {{"Output"}, {"blocks/1/output/which/all", "blocks/1/value = 3"}, "U5 | U15 | U16 | U18"},
  {{"Own text"}, {"blocks/1/about = count", "blocks/1/text = P3"}, "P3"},
  {{"Delay"}, {"blocks/loop", "blocks/1/times = 0"}, "LM0 | P5 | L0"},
  never = {jog = "no jog", stop = "", enable = "motor power", arc = "draws no arcs", circle = "draws no arcs"}}

-- Speeds are of all eight axes: only X is looked at.
local function of_all(command, value) return command .. (value .. ","):rep(7) .. value .. ";" end
local vme58 = {
  {{"Speed"}, {"blocks/1/high = 4000", "blocks/1/low = 400", "blocks/1/ramp_ms = 200"},
   "AA | " .. of_all("VL", 4000) .. " | " .. of_all("VB", 400) .. " | " .. of_all("AC", 18000)},
  {{"Move to"}, {"blocks/1/to/X = 100", "blocks/1/to/Y = 200"}, "AA | MT100,200; GO"},
  {{"Move by"}, {"blocks/1/to/X = ", "blocks/1/to/S = -100"}, "AA | MR,,,,,,,-100; GO"},
  {{"Move to"}, {"blocks/1/relative/yes", "blocks/1/to/X = 5"}, "AA | MR5; GO"},
  {{"Home"}, {"blocks/1/axis", "blocks/1/axis/S", "blocks/1/direction/-"}, "AA | HR,,,,,,,0;"},
  {{"Home"}, {"blocks/1/axis", "blocks/1/axis/Y"}, "AA | HR,0;"},
  {{"Until still"}, {"blocks/1/axis", "blocks/1/axis/all"}, "AA | WA"},
  {{"Delay"}, {"blocks/1/ms = 1234"}, "AA | WT1234"},
  {{"Wait for input"}, {"blocks/1/input = 3"}, "AA | SW3"},
  {{"Output"}, {"blocks/1/output = 9", "blocks/1/on/off"}, "AA | BH9"},
  {{"Comment"}, {"blocks/1/text = count"}, "AA | # count"},
  {{"Own text"}, {"blocks/1/about = count", "blocks/1/text = AX SP0;"}, "AA | AX SP0; | AA"},
  {{"Delay"}, {"blocks/loop", "blocks/1/times = 3"}, "AA | LS3 | WT500 | LE"},
  never = {stop = "", enable = "", move_on_input = ""}}

for model, rows in pairs{vxm = vxm, ["dmx-k-sa"] = of_one(), vme58 = vme58} do
  local c = hw.check(hw.open(model .. "@emulator"))
  if model == "vxm" then for m = 1, 2 do hw.check(c:set("M" .. m .. "M", 4)) end end
  hw.sleep(1)
  for n, row in ipairs(rows) do
    block(model .. " " .. n .. " " .. row[1][1], function() works(row) end)
  end
  at_blocks()
  for _, w in ipairs(ui.list()) do
    local kind = w.id:match("^blocks/add/(.+)$")
    if kind and rows.never[kind] and w.enabled then error(model .. " is offered " .. kind) end
  end
end

over()
