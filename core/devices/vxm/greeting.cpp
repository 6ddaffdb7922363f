#include "core/devices/vxm/greeting.h"

#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

Greeting read_greeting(std::string_view bytes) {
  Greeting g;
  // V and the state at the end suffice, whatever the controller echoed before.
  if (bytes.size() > 2 && bytes[bytes.size() - 2] == 'V') bytes.remove_prefix(bytes.size() - 2);
  while (!bytes.empty()) {
    const char first = bytes.front();
    if (first == 'V' && !g.echo) {
      g.echo = true;
      bytes.remove_prefix(1);
    } else if (decode_state(bytes.substr(0, 1))) {
      g.state = first;
      bytes.remove_prefix(1);
    } else {
      const Message m = next_message(bytes);
      if (m.kind == Message::Kind::unknown) g.sense = false;
      bytes.remove_prefix(m.length > 0 ? m.length : bytes.size());
    }
  }
  return g;
}

tl::unexpected<Fault> no_greeting(int rate) {
  std::string what = "Nothing answers V, the VXM's status query";
  what += rate > 0 ? fmt::format(", at {} baud.", rate) : ".";
  return fail(
      FaultKind::no_answer, std::move(what), "Only V and a carriage return were sent.",
      fmt::format("Check that the controller is switched on (green lamp), the cable, and the baud rate: {}. "
                  "If both lamps flash fast, the controller is in an error state and takes only K: send K. "
                  "If On-Line flashes alone, switch it off and on.",
                  rates_in_words));
}

tl::unexpected<Fault> no_vxm_greets(std::string_view bytes, int rate) {
  std::string hex;
  for (const char c : bytes.substr(0, 8))
    hex += fmt::format("{}{:02X}", hex.empty() ? "" : " ", static_cast<unsigned char>(c));
  const bool plain = std::all_of(bytes.begin(), bytes.end(),
                                 [](char c) { return (c >= ' ' && c < 127) || c == '\r' || c == '\n'; });
  std::string what =
      fmt::format("The device that answers V is not a VXM: {} came back instead of R, B, J or b.", hex);
  if (plain)
    return fail(FaultKind::garbled, std::move(what), "Nothing more was sent.",
                "Another device is on this port. Choose its model, or another port.");
  std::string advice = "This looks like a wrong baud rate. Try";
  for (const Baud& b : bauds)
    if (b.rate != rate) advice += fmt::format(" {}{}", b.rate, &b == &bauds.back() ? "" : ",");
  return fail(FaultKind::garbled, std::move(what), "Nothing more was sent.", advice + ".");
}

}  // namespace hw::vxm
