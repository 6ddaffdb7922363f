#include "core/devices/dmx_k_sa/catalog.h"

#include "core/devices/arcus/address.h"
#include "core/devices/arcus/catalog.h"
#include "core/devices/dmx_k_sa/facts.h"
#include "core/devices/dmx_k_sa/forms.h"

namespace hw::dmx_k_sa {
namespace {

const arcus::Wording& wording() {
  static const arcus::Wording words{"DMX manual ch. 7",
                                    {{1, "Direction inverted"},
                                     {4, "Limit switches inverted"},
                                     {5, "Home switch inverted"},
                                     {6, "Latch input inverted"},
                                     {7, "In-position output inverted"},
                                     {8, "Alarm output inverted"},
                                     {9, "Digital outputs inverted"},
                                     {10, "Digital inputs inverted"},
                                     {11, "The error routine returns to line 0 (else to the failing line)"},
                                     {12, "Motor enable inverted"}}};
  return words;
}

void add_readouts(Catalog& c) {
  arcus::add_common_readouts(c, model);
  ReadoutInfo current;
  current.label = "Motor current";
  current.unit = "mA";
  current.help = "The current now: the run current, the idle current, or none.";
  arcus::add_readout(c, arcus::motion, "CUR", current);
  ReadoutInfo latch_input;
  latch_input.label = "Latch input";
  latch_input.words = {{0, "off"}, {1, "on"}};
  arcus::add_readout(c, arcus::motion, "LATCHIN", latch_input);
  ReadoutInfo index;
  index.label = "Encoder index";
  index.words = {{0, "off"}, {1, "on"}};
  index.help = "On while the encoder is on its index mark.";
  arcus::add_readout(c, arcus::motion, "INDEX", index);
}

void name_the_outputs(Catalog& c) {
  OutputInfo& in_position = c.outputs[in_position_output - 1];
  in_position.help =
      "Shows that the axis is in position while StepNLoop and EDO are on; otherwise you can switch it.";
  in_position.duty = {"In position", {"SL", "EDO"}};
  OutputInfo& alarm = c.outputs[alarm_output - 1];
  alarm.help = "Shows an error while StepNLoop and EDO are on; otherwise you can switch it.";
  alarm.duty = {"Alarm", {"SL", "EDO"}};
}

}  // namespace

Result<Catalog> make_catalog(const DeviceOptions& options) {
  const auto id = arcus::id_option(options, model);
  if (!id) return fail(id.error());
  Catalog c = arcus::common_catalog(model, wording());
  c.address = *id;
  c.name = "Arcus DMX-K-SA";
  c.short_name = "DMX";
  c.summary = "1 motor each, up to 99 on a bus";
  c.program.example =
      "; Back and forth five times, with a rest of half a second; V1 counts\n"
      "HSPD=20000\n"
      "LSPD=500\n"
      "ACC=200\n"
      "EO=1\n"
      "PX=0\n"
      "ABS\n"
      "V1=0\n"
      "WHILE V1<5\n"
      "  X5000\n"
      "  WAITX\n"
      "  DELAY=500\n"
      "  X0\n"
      "  WAITX\n"
      "  DELAY=500\n"
      "  V1=V1+1\n"
      "ENDWHILE\n"
      "END\n";
  c.options = {{"id", {{"00", "1 motor"}, {"01-04", "01 to 04"}, {"01-30", "01 to 30"}}}};
  for (std::size_t i = 0; i < c.homing_modes.size(); ++i)
    c.homing_modes[i].maker = forms().homes[i].substr(0, forms().homes[i].size() - 1);  // without its sign
  add_readouts(c);
  name_the_outputs(c);
  arcus::add_common_actions(c, model, "DMX manual ch. 7");
  arcus::add_axis_tables(c, model);
  c.commands = command_help();
  c.bench.panel_title = "DMX-K-SA";
  return c;
}

}  // namespace hw::dmx_k_sa
