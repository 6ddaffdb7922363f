#include "core/devices/pmx_4ex_sa/catalog.h"

#include <tuple>

#include <fmt/core.h>

#include "core/devices/arcus/address.h"
#include "core/devices/arcus/catalog.h"
#include "core/devices/pmx_4ex_sa/arc_reach.h"
#include "core/devices/pmx_4ex_sa/facts.h"

namespace hw::pmx_4ex_sa {
namespace {

using arcus::followed;
using arcus::make_action;
using arcus::number_field;
using arcus::position_field;
using arcus::value_readout;

const arcus::Wording& wording() {
  static const arcus::Wording words{
      "PMX manual ch. 6",
      {{0, "Home switch active when its input conducts"},
       {1, "Alarm active when its input conducts"},
       {2, "Limit switches active when their inputs conduct (the bit of X governs all axes)"},
       {3, "Direction output inverted"}}};
  return words;
}

void add_readouts(Catalog& c) {
  arcus::add_common_readouts(c, model);
  arcus::add_readout(c, arcus::motion, "TR",
                     value_readout("Timer", "ms", "A timer of the controller that counts down to 0."));
  c.readout_groups.insert(c.readout_groups.end(), {"Buffer", "Analog inputs"});
  ReadoutInfo mode = value_readout("Buffer", "", "Whether the controller accepts buffered moves.");
  mode.words = {{0, "off"}, {1, "on"}};
  arcus::add_readout(c, arcus::buffer, "BUF", mode);
  for (const auto& [id, label, help] :
       {std::tuple{"BUFSTART", "Present place", "Place in the ring, 0 to 35, of the running move."},
        std::tuple{"BUFEND", "Last place", "Place in the ring, 0 to 35, of the newest move."}}) {
    ReadoutInfo place = value_readout(label, "", help);
    place.for_scripts = true;
    arcus::add_readout(c, arcus::buffer, id, place);
  }
  arcus::add_readout(c, arcus::buffer, "BUFFREE",
                     value_readout("Free places of 36", "", "For buffered moves."));
}

ActionField angle(const char* id, const char* label, std::int64_t minimum, std::int64_t maximum,
                  std::int64_t fallback) {
  ActionField f = number_field(id, label, "°", minimum, maximum, fallback);
  f.decimals = 3;
  return f;
}

void add_actions(Catalog& c) {
  arcus::add_common_actions(c, model, "PMX manual ch. 6");
  c.actions.push_back(
      make_action("arc", "Draw arc",
                  "X and Y turn about the centre by this many degrees from their present place: + is "
                  "counter-clockwise, - is clockwise. 360 is a full circle. Possible only in absolute mode.",
                  "Arc and circle",
                  {followed(position_field("centre_x", "Centre X", "pulses"), 0),
                   followed(position_field("centre_y", "Centre Y", "pulses"), 1),
                   angle("sweep", "Sweep", -arcus::full_turn, arcus::full_turn, -arcus::full_turn / 4)},
                  "PMX manual ch. 6 Arc Interpolation Moves"));
  c.actions.back().moves = c.actions.back().is_arc = true;
  c.actions.back().reaches = arc_reaches;
  const std::size_t buffer_begin = c.actions.size();
  c.actions.push_back(make_action(
      "buffer_on", "Switch buffer on",
      "Switch StepNLoop of X, Y and Z off first. The controller then accepts buffered moves of these axes.",
      "Buffer", {}, "PMX manual ch. 6 Buffered Linear Interpolation Moves"));
  c.actions.back().sets = "BUF";
  c.actions.back().sets_to = 1;
  c.actions.push_back(make_action("buffer_off", "Switch buffer off",
                                  "The running move is completed; the moves in the buffer are dropped.",
                                  "Buffer", {}, "PMX manual ch. 6 Buffered Linear Interpolation Moves"));
  c.actions.back().while_busy = true;
  c.actions.back().sets = "BUF";
  for (std::size_t i = buffer_begin; i < c.actions.size(); ++i) c.actions[i].of_move_buffer = true;
  c.actions.push_back(make_action("timer", "Start", "Starts the countdown from this value.", "Motion",
                                  {number_field("time", "Time", "ms", 0, arcus::max_number, 1000)},
                                  "PMX manual ch. 6 Timer Register"));
  c.actions.back().sets = "TR";
  c.actions.push_back(make_action(
      "joystick", "Joystick",
      "On: the axis follows the voltage of its analog input, and its StepNLoop is switched off.", "Joystick",
      {arcus::axis_field(model), arcus::switch_field()}, "PMX manual ch. 6 Joystick Control"));
  c.actions.back().moves = true;
  c.actions.back().follows_analog = true;
}

}  // namespace

Result<Catalog> make_catalog(const DeviceOptions& options) {
  const auto id = arcus::id_option(options, model);
  if (!id) return fail(id.error());
  Catalog c = arcus::common_catalog(model, wording());
  c.address = *id;
  c.can.usb = true;
  c.can.arcs = true;
  c.name = "Arcus PMX-4EX-SA";
  c.short_name = "PMX";
  c.summary = "four stepping axes, X to U";
  c.options = {{"id", {{"00", "4EX00"}, {"01", "4EX01"}, {"02", "4EX02"}, {"03", "4EX03"}}}};
  c.program.example =
      "; A house in one stroke: eight lines without lifting the pen\n"
      "HSPD=4000\n"
      "LSPD=400\n"
      "ACC=100\n"
      "EO=3       ; the motors of X and Y\n"
      "PX=0\n"
      "PY=0\n"
      "ABS\n"
      "DO1=1      ; the pen is down\n"
      "X3000Y0\n"
      "WAITX\n"
      "X0Y3000\n"
      "WAITX\n"
      "X3000Y3000\n"
      "WAITX\n"
      "X0Y0\n"
      "WAITX\n"
      "X0Y3000\n"
      "WAITY\n"
      "X1500Y4500\n"
      "WAITX\n"
      "X3000Y3000\n"
      "WAITX\n"
      "X3000Y0\n"
      "WAITY\n"
      "DO1=0\n"
      "END\n";
  add_readouts(c);
  add_actions(c);
  arcus::add_axis_tables(c, model);
  c.move_list.columns = {position_field("x", "X", "pulses"), position_field("y", "Y", "pulses"),
                         position_field("z", "Z", "pulses"),
                         number_field("speed", "Speed", "pulses/s", 1, arcus::max_speed, 1000)};
  for (int axis = 0; axis < buffer_axes; ++axis)
    c.move_list.columns[static_cast<std::size_t>(axis)].of_axis = axis;
  c.move_list.depth = buffer_places;
  c.move_list.readout_group = arcus::buffer;
  c.analog_readout_group = arcus::analog_inputs;
  c.move_list.file_suffix = ".moves";
  c.commands = command_help();
  c.bench.panel_title = "PMX-4EX-SA";
  return c;
}

}  // namespace hw::pmx_4ex_sa
