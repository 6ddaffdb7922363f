// The tables of Control: a row per axis.
#include <fmt/core.h>

#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {
namespace {

using Shows = AxisColumn::Shows;

AxisColumn verb(std::string id, std::string title, std::string on_the_button) {
  AxisColumn c{Shows::action, std::move(id), std::move(title)};
  c.verb_on = std::move(on_the_button);
  return c;
}

}  // namespace

void add_axis_tables(Catalog& catalog) {
  AxisColumn stop_near = verb("force_position", "position", "Stop");
  stop_near.while_moving = true;
  AxisColumn hold{Shows::toggle, "hold", ""};
  hold.state = "HN*";
  AxisColumn clear = verb("clear_flags", "", "Clear all");
  clear.state = "SLIP*";
  catalog.axis_tables = {
      {"Motion", "", {{Shows::motion, "", "state"}}},
      {"Stop near", "", {stop_near}},
      {"Jog slowly", "", {verb("fraction_jog", "speed", "Jog")}},
      {"Queue",
       fmt::format("of {} places", queue_entries),
       {{Shows::readout, "RQ*", "free"}, verb("flush", "", "Empty"), verb("clear_while", "", "End WH")}},
      {"Hold", "", {hold}},
      {"Slip", "", {{Shows::readout, "SLIP*", "state"}, clear, verb("slip_interrupt", "", "Interrupt")}},
      {"Encoder", "", {verb("encoder_ratio", "encoder : motor counts", "Set"), verb("track", "", "Track")}},
      {"Remainder", "", {verb("remainder", "divided by", "Keep")}},
  };
}

}  // namespace hw::vme58
