// Bytes on the wire, time and hands on the bench, as the fuzzer likes. The emulator may answer what it wants,
// but it has to stay alive, keep its time going forward, and come back after a power cycle.
#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "core/devices/vxm/emulator.h"
#include "tests/fuzz/bytes.h"

namespace {

using namespace hw;
using fuzz::Bytes;
using fuzz::require;

BenchCommand hand(Bytes& in) {
  static constexpr const char* buttons[] = {"Run", "Stop", "1-", "1+", "2-", "2+", "3+", "Slave Run"};
  const auto what = in.next(), with = in.next();
  const bool on = with & 1;
  const AxisId axis{static_cast<std::uint8_t>((with >> 1) & 7)};
  const Steps steps(static_cast<std::int16_t>(in.next() << 8 | in.next()));
  switch (what % 12) {
    case 0: return bench::Input(with >> 1, on);
    case 1: return bench::Limit(axis, with & 16 ? Sign::plus : Sign::minus, on);
    case 2: return bench::HomeSwitch(axis, on);
    case 3: return bench::Analog(1 + (with & 1), static_cast<std::int32_t>(steps.value));
    case 4: return bench::Button(buttons[(with >> 1) & 7], on);
    case 5: return bench::Jam(axis, on);
    case 6: return bench::Slip(axis, steps);
    case 7: return bench::Power(on);
    case 8: return bench::PowerCycle{};
    case 10: return bench::Power(on, (with >> 1) % 3);
    case 11: return bench::Breaker((with >> 1) % 3, on);
    default: {
      AxisPlace place;
      place.plus = steps;
      place.minus = -steps;
      if (on) place.home_from = Steps(-10), place.home_to = Steps(10);
      return bench::Place(axis, place);
    }
  }
}

// A program may loop without a pause, a thousand commands a second: one input gets no more time than this in
// all.
constexpr Duration longest = std::chrono::minutes(10);

// Microseconds to minutes; every step of an interesting event when `in` asks for it.
void pass_time(Emulator& emulator, Instant& now, Bytes& in) {
  const auto kind = in.next();
  const Instant before = now;
  if (kind & 1) {
    for (int i = 0; i < kind / 8; ++i) {
      const auto next = emulator.next_event();
      if (!next || next->time_since_epoch() > longest) return;
      require(*next >= now);
      now = *next;
      emulator.advance_to(now);
    }
    return;
  }
  now += std::chrono::microseconds(1LL << (kind / 8 % 27)) * (1 + in.next());
  now = std::min(now, std::max(Instant(longest), before));
  emulator.advance_to(now);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes in(data, size);
  std::map<std::string, std::string> options;
  if (in.next() & 1) options["motors"] = "4";
  auto made = vxm::make_emulator(options);
  require(made.has_value());
  Emulator& emulator = **made;
  Instant now{};
  std::string out;
  emulator.receive("F");
  while (!in.empty()) {
    const auto op = in.next();
    if (op < 160) {
      emulator.receive(in.text(1 + op % 32));
    } else if (op < 220) {
      pass_time(emulator, now, in);
    } else if (op < 250) {
      (void)emulator.operate(hand(in));
    } else if (op < 252) {
      const std::string memory = emulator.save_memory();
      require(emulator.load_memory(memory).has_value());
      require(emulator.save_memory() == memory);
    } else if (op < 254) {
      (void)emulator.load_memory(in.text(64));
    } else {
      *made = emulator.clone();
      return 0;
    }
    emulator.take_output(out);
    out.clear();
    BenchView view;
    emulator.look(view);
  }
  for (const int supply : {0, 1, 2}) (void)emulator.operate(bench::Breaker(supply, false));
  (void)emulator.operate(bench::Power(true));
  (void)emulator.operate(bench::PowerCycle{});
  emulator.take_output(out);
  out.clear();
  emulator.receive("FV");
  emulator.take_output(out);
  require(out == "R");
  return 0;
}
