// Whatever comes over the wire, or is typed, is read to its end by the console's side.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/explain.h"

using namespace hw;
using namespace hw::vxm;

static void require(bool held) {
  if (!held) std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);

  if (const auto p = decode_position(bytes)) require(p->value >= -8'388'608 && p->value <= 8'388'607);
  (void)decode_number(bytes), (void)decode_state(bytes), (void)decode_text_line(bytes);
  if (const auto l = decode_listing(bytes)) require(l->slot >= 0 && l->slot <= 4 && l->free_bytes <= 256);
  if (const auto d = decode_digitized(bytes, 4))
    require(d->positions.size() >= 2 && d->positions.size() <= 4);

  for (std::string_view rest = bytes; !rest.empty();) {
    const Message m = next_message(rest);
    require((m.length == 0) == (m.kind == Message::Kind::unfinished) && m.length <= rest.size());
    for (const auto before : {before_number, before_state, before_prompt}) {
      const std::size_t n = before(rest);
      require(n == std::string_view::npos || n <= rest.size());
    }
    if (m.length == 0) break;
    rest.remove_prefix(m.length);
  }

  std::size_t at = 0;
  std::string canonical_text;
  for (const TextCommand& c : read_text(bytes)) {
    require(c.begin >= at && c.end > c.begin && c.end <= size);
    at = c.end;
    require(program_cost(c) >= 0);
    (void)allowed_values(c);
    if (c.flaw == Flaw::none && c.stored()) canonical_text += canonical(c) + ",";
  }
  // What lst would show says the same when it is read again.
  std::string again;
  for (const TextCommand& c : read_text(canonical_text)) again += canonical(c) + ",";
  require(again == canonical_text || canonical_text.find_first_of("()") != std::string::npos);
  (void)ends_open(bytes);

  (void)explain(bytes, Way::sent, TrafficKind::intent, "");
  (void)explain(bytes, Way::received, TrafficKind::unsolicited, "");
  for (const char* asked : {"V", "X", "?", "~", "$", "M", "#", "lst", "getM1M", "PM\r", "D", ""})
    (void)explain(bytes, Way::received, TrafficKind::poll, asked);
  return 0;
}
