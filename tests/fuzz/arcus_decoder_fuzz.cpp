// Whatever comes over the wire, or is typed, is read to its end by the console's side.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/devices/arcus/codec.h"
#include "core/devices/arcus/explain.h"
#include "core/devices/dmx_k_sa/catalog.h"
#include "core/devices/dmx_k_sa/facts.h"
#include "core/devices/dmx_k_sa/forms.h"
#include "core/devices/pmx_4ex_sa/catalog.h"
#include "core/devices/pmx_4ex_sa/facts.h"
#include "core/devices/pmx_4ex_sa/forms.h"

using namespace hw;
using namespace hw::arcus;

static void require(bool held) {
  if (!held) std::abort();
}

static void read_as(const Forms& forms, const std::vector<CommandInfo>& known, std::string_view bytes) {
  (void)may_move(forms, bytes);
  require(!explain_refusal(*forms.model, bytes).empty());
  const std::size_t strange = unsolicited_or_name_at_front(*forms.model, bytes);
  require(strange == std::string_view::npos || strange <= bytes.size());
  for (const char* asked : {"@00MST\r", "@01PX\r", ""}) {
    (void)explain(*forms.model, known, bytes, Way::sent, TrafficKind::intent, asked);
    (void)explain(*forms.model, known, bytes, Way::received, TrafficKind::poll, asked);
  }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Catalog pmx = *pmx_4ex_sa::make_catalog({}), dmx = *dmx_k_sa::make_catalog({});
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);

  const std::size_t unsolicited = unsolicited_at_front(bytes);
  require(unsolicited == 0 || unsolicited == 5 || unsolicited == std::string_view::npos);
  if (unsolicited == 5) require(in_position(bytes.substr(0, 5)).has_value());
  const Reply reply = decode_reply(bytes);
  require(reply.text.find('\r') == std::string::npos && reply.text.find('\0') == std::string::npos);
  if (reply.id) require(*reply.id >= 0 && *reply.id <= 99);
  if (const auto numbers = decode_numbers(bytes, 4)) require(numbers->size() >= 4);

  // What can be read as a value is written so that it reads the same.
  for (const Catalog* catalog : {&pmx, &dmx})
    for (const char* name : {"DN", "SLR", "SLRX", "HS"}) {
      const int index = catalog->find_param(name);
      if (index < 0) continue;
      const ParamInfo& info = catalog->params[static_cast<std::size_t>(index)];
      const auto value = decode_value(info, bytes);
      if (value && info.accepts(*value)) require(decode_value(info, encode_value(info, *value)) == value);
    }
  read_as(pmx_4ex_sa::forms(), pmx.commands, bytes);
  read_as(dmx_k_sa::forms(), dmx.commands, bytes);
  return 0;
}
