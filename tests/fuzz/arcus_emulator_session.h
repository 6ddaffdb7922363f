#pragma once
// Bytes on the line, time and hands on the bench, as the fuzzer likes. The emulator may answer what it wants,
// but it has to stay alive, keep its time going forward, and come back after a power cycle.
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/emulation/emulator.h"
#include "tests/fuzz/bytes.h"

namespace hw::fuzz {

inline BenchCommand hand(Bytes& in) {
  const auto what = in.next(), with = in.next();
  const bool on = with & 1;
  const AxisId axis{static_cast<std::uint8_t>((with >> 1) & 7)};
  const Steps steps(static_cast<std::int16_t>(in.next() << 8 | in.next()));
  switch (what % 10) {
    case 0: return bench::Input(with >> 1, on);
    case 1: return bench::Limit(axis, with & 16 ? Sign::plus : Sign::minus, on);
    case 2: return bench::HomeSwitch(axis, on);
    case 3: return bench::Analog(1 + (with & 7), static_cast<std::int32_t>(steps.value));
    case 4: return bench::Alarm(axis, on);
    case 5: return bench::Jam(axis, on);
    case 6: return bench::Slip(axis, steps);
    case 7: return bench::Power(on);
    case 8: return bench::PowerCycle{};
    default: {
      AxisPlace place;
      place.plus = steps, place.minus = -steps;
      if (on) place.home_from = Steps(-10), place.home_to = Steps(10), place.backlash = Steps(with & 7);
      if (with & 64) place.counts_per_step = static_cast<double>(static_cast<std::int8_t>(in.next())) / 8;
      if (with & 128) place.index_every = Steps(in.next());
      return bench::Place(axis, place);
    }
  }
}

/// A motion lasts 95 years at most (core/motion/profile.cpp): one that begins before this ends within the
/// clock.
constexpr Instant latest_start{std::chrono::hours(24 * 365 * 95)};

/// Microseconds to minutes; event by event when the input asks for it.
inline void pass_time(Emulator& emulator, Instant& now, Bytes& in) {
  const auto kind = in.next();
  if (kind & 1) {
    for (int i = 0; i < kind / 8; ++i) {
      const auto next = emulator.next_event();
      if (!next || *next > latest_start) return;
      require(*next >= now);
      now = *next;
      emulator.advance_to(now);
    }
    return;
  }
  constexpr int longest = 22;  // 4 s, times 256
  now += std::chrono::microseconds(1LL << (kind / 8 % longest)) * (1 + in.next());
  emulator.advance_to(now);
}

/// The fuzzer seldom finds an address by itself: one in two texts gets it, and its end.
inline void session(Emulator& fresh, const std::string& address, Bytes& in) {
  std::unique_ptr<Emulator> emulator = fresh.clone();
  Instant now{};
  std::string out;
  while (!in.empty()) {
    const auto op = in.next();
    if (op < 120) {
      emulator->receive("@" + address + std::string(in.text(1 + op % 24)) + "\r");
    } else if (op < 160) {
      emulator->receive(in.text(1 + op % 32));
    } else if (op < 220) {
      pass_time(*emulator, now, in);
    } else if (op < 250) {
      (void)emulator->operate(hand(in));
    } else if (op < 252) {
      const std::string memory = emulator->save_memory();
      require(emulator->load_memory(memory).has_value());
      require(emulator->save_memory() == memory);
    } else if (op < 254) {
      (void)emulator->load_memory(in.text(64));
    } else {
      emulator = emulator->clone();
    }
    emulator->take_output(out);
    out.clear();
    BenchView view;
    emulator->look(view);
  }
  // A fresh memory: whatever has been set, the address is the first one again.
  require(emulator->load_memory(fresh.save_memory()).has_value());
  (void)emulator->operate(bench::Power(true));
  (void)emulator->operate(bench::PowerCycle{});
  emulator->take_output(out);
  out.clear();
  emulator->receive("\r@" + address + "VER\r");
  emulator->take_output(out);
  require(out.size() == 7 && out[0] == 'V');
}

}  // namespace hw::fuzz
