-- Every object of the graphical programmer with each of its settings on a VME58, as a user builds them: added by the
-- palette, changed in its fields, seen as text, saved, opened again with the same text, taken back and made again.
require("lib.blocks")
local folder = hw.args[1] or "."
local file_name = folder .. "/blocks_vme58.toml"

ui.window(1440, 1000)
local c = hw.check(hw.open("vme58@emulator"))
hw.sleep(1)

-- Values of all eight axes.
local function all(command, value) return command .. (value .. ","):rep(7) .. value .. ";" end
local speed = all("VL", 1000) .. " | " .. all("VB", 100) .. " | " .. all("AC", 3000)

local at = "AA | " .. speed .. " | MT1000,0; GO | "

-- A shape behind a speed and a move to where it begins.
local function from(to, name, ...)
  local sets = {2}
  for axis, place in to:gmatch("(%u)(%d+)") do sets[#sets + 1] = "blocks/2/to/" .. axis .. " = " .. place end
  for _, words in ipairs{3, ...} do sets[#sets + 1] = words end
  return {"Speed", "Move to", name}, sets
end
local function row(list, sets, wanted) return {list, sets, wanted} end
local function shape(to, name, sets, wanted)
  local list, all_sets = from(to, name, table.unpack(sets))
  return {list, all_sets, wanted}
end

local rows = {
  shape("X1000Y0", "Arc", {"blocks/3/x = 0", "blocks/3/y = 0"},
      at .. "CV1000; | CD1000,0; | CR0,0,1.570796327; | CK | MT1000,0; GO | CX"),
  shape("X1000Y0", "Arc", {"blocks/3/x = 0", "blocks/3/degrees = 45", "blocks/3/way/clockwise"},
      at .. "CV1000; | CD1000,0; | CR0,0,-0.785398163; | CK | MT1000,0; GO | CX"),
  shape("X1000Y0", "Circle", {"blocks/3/x = 0", "blocks/3/y = 500"},
      at .. "CV1000; | CD1000,0; | CR0,500,6.283185307; | CK | MT1000,0; GO | CX"),
  shape("X1000Y0", "Circle", {"blocks/3/x = 0", "blocks/3/way/clockwise"},
      at .. "CV1000; | CD1000,0; | CR0,0,-6.283185307; | CK | MT1000,0; GO | CX"),
  shape("X1000Y0", "Arc", {"blocks/3/x = 0", "blocks/3/own/its own", "blocks/3/high = 2500"},
      at .. "CV2500; | CD1000,0; | CR0,0,1.570796327; | CK | MT1000,0; GO | CX"),
  shape("Z1000T0", "Arc", {"blocks/3/axes/1", "blocks/3/axes/1/Z", "blocks/3/axes/2", "blocks/3/axes/2/T",
                           "blocks/3/x = 0", "blocks/3/y = 0"},
        "AA | " .. speed .. " | MT0,,1000,0; GO | CV1000; | CD,,1000,0; | CR0,0,1.570796327; | CK | MT,,1000,0; GO | CX"),
  row({"Speed", "Jog"}, {}, "AA | " .. speed .. " | JG1000;"),
  row({"Speed", "Jog"}, {"blocks/2/axis", "blocks/2/axis/T", "blocks/2/direction/-"},
      "AA | " .. speed .. " | JG,,,-1000;"),
  row({"Jog"}, {"blocks/1/own/its own", "blocks/1/high = 2500"}, "AA | JG2500;"),
  row({"Move to"}, {"blocks/1/own/its own", "blocks/1/high = 2500", "blocks/1/low = 250", "blocks/1/ramp_ms = 150"},
      "AA | VL2500; | VB250; | AC15000; | MA0; GO"),
  row({"Move by"}, {"blocks/1/to/X = 10", "blocks/1/to/S = -20", "blocks/1/own/its own", "blocks/1/high = 2500"},
      "AA | VL2500,,,,,,,2500; | ML10,,,,,,,-20; GO"),
  row({"Home"}, {"blocks/1/own/its own", "blocks/1/high = 2500", "blocks/1/low = 250", "blocks/1/ramp_ms = 150"},
      "AA | VL2500; | VB250; | AC15000; | HR0;"),
  row({"Move to", "Speed stairs"},
      {2, "blocks/2/stairs/1/until = 500", "blocks/2/stairs/1/speed = 800", "blocks/2/stop_at = 4500"},
      "AA | MA0; GO | WA | WQ | AX MP | MV500,800; | MV3000,2000; | SP4500; | WQ AA WA"),
  row({"Move to", "Speed stairs"},
      {1, "blocks/1/to/U = 0", 2, "blocks/2/axis", "blocks/2/axis/U", "blocks/2/stairs/add",
       "blocks/2/stairs/3/until = 3500", "blocks/2/stairs/3/speed = 300"},
      "AA | MT0,,,,0; GO | WA | WQ | AU MP | MV1000,1000; | MV3000,2000; | MV3500,300; | SP4000; | WQ AA WA"),
  row({"Move to", "Speed stairs"}, {"blocks/2/stairs/remove"},
      "AA | MA0; GO | WA | WQ | AX MP | MV1000,1000; | SP4000; | WQ AA WA"),
  row({"Tool"}, {"blocks/1/pen_down = Out 9 on, wait 250 ms", "blocks/1/pen_up = Out 9 off, wait 100 ms"},
      "AA | # Tool off: output 9 off | BL9 | WT250"),
  row({"Tool"}, {"blocks/1/down/up"}, "AA | # Tool off: output 9 off | BH9 | WT100"),
  row({"Tool"}, {"blocks/1/pen_down = Z to -200, wait 20 ms", "blocks/1/pen_up = Z to 0"},
      "AA | MA,,-200; GO | WA | WT20"),
  row({"Contour"}, {"blocks/1/x = 100", "blocks/1/y = 50", "blocks/1/lead_in = 200"},
      "AA | CV1000; | CD100,50; | MT1000,0; | CE | MT-100,61; GO | CX"),
  row({"Contour"}, {"blocks/1/ends_ramped/no"}, "AA | CV1000; | CD0,0; | MT1000,0; | CK | MT0,0; GO | CX"),
  row({"Speed", "Contour"}, {2, "blocks/2/own/as before"},
      "AA | " .. speed .. " | CV1000; | CD0,0; | MT1000,0; | CE | MT0,0; GO | CX"),
  row({"Contour"}, {"blocks/1/own/its own", "blocks/1/high = 3000"},
      "AA | CV3000; | CD0,0; | MT1000,0; | CE | MT0,0; GO | CX"),
  row({"Contour"},
      {"blocks/1/axes/1", "blocks/1/axes/1/T", 2, "blocks/2/to/X = ", "blocks/2/to/Y = 0", "blocks/2/to/T = 900"},
      "AA | CV1000; | CD,0,,0; | MT0,900; | CE | MT,0,,0; GO | CX"),
  row({"Contour", "Output", "Arc"}, {4, "blocks/4/x = 1000", "blocks/4/y = 500"},
      "AA | CV1000; | CD0,0; | MT1000,0; | AN0; | CR1000,500,1.570796327; | CE | MT0,0; GO | CX"),
  row({"Output"}, {"blocks/1/output = 14"}, "AA | WA | WQ | AX AN AA"),
  row({"Output"}, {"blocks/1/output/which/all", "blocks/1/value = 5"}, "AA | BL8 | BH9 | BL10 | BH11 | BH12 | BH13"),
  row({"Delay"}, {"blocks/loop", "blocks/1/times = 0"}, "AA | WH | WT500 | WG"),
  row({"Delay", "Loop"}, {1, "blocks/skip", 2}, "AA | LS2 | LE"),
  row({"Own text"}, {"blocks/1/about = count", "blocks/1/text = AX SP0;"}, "AA | AX SP0; | AA"),
}
for n, r in ipairs(rows) do
  block("vme58 " .. n .. " " .. table.concat(r[1], ", "), function()
    blocks(table.unpack(r[1]))
    for _, words in ipairs(r[2]) do set(words) end
    writes(r[3])
    undone("AA")
    saved_and_opened(file_name)
  end)
end

over()
