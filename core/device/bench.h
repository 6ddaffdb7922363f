#pragma once
// The bench around an emulated controller: its switches, loads, front panel and lamps. Used by scripts, bench
// files and the bench panel.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/fixed_text.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/motion/axis_place.h"
#include "core/time/clock.h"

namespace hw {

namespace bench {
struct Input {
  int number;   ///< its number, as in the catalog
  bool active;  ///< true: operated (an active-low input is at 0 V)
  Input(int n, bool a) : number(n), active(a) {}
};
struct Limit {
  AxisId axis;
  Sign sign;
  bool operated;  ///< operated by hand, besides by travel
  Limit(AxisId a, Sign s, bool o) : axis(a), sign(s), operated(o) {}
};
struct HomeSwitch {
  AxisId axis;
  bool operated;
  HomeSwitch(AxisId a, bool o) : axis(a), operated(o) {}
};
struct Analog {
  int number;
  std::int32_t value;
  Analog(int n, std::int32_t v) : number(n), value(v) {}
};
struct Button {
  std::string name;
  bool pressed;
  Button(std::string n, bool p) : name(std::move(n)), pressed(p) {}
};
struct Jam {
  AxisId axis;
  bool on;
  Jam(AxisId a, bool o) : axis(a), on(o) {}
};
struct Alarm {  ///< the alarm input of an axis, if it has one
  AxisId axis;
  bool on;
  Alarm(AxisId a, bool o) : axis(a), on(o) {}
};
struct Slip {  ///< the load jumps unseen by the controller, by steps or by encoder counts
  AxisId axis;
  Steps by;
  Slip(AxisId a, Steps b) : axis(a), by(b) {}
};
struct Place {
  AxisId axis;
  AxisPlace place;
  Place(AxisId a, AxisPlace p) : axis(a), place(p) {}
};
struct Power {
  bool on;
  int supply;  ///< index in BenchFacts::supplies; -1: the switches of all
  explicit Power(bool o, int s = -1) : on(o), supply(s) {}
};
struct PowerCycle {};
/// The circuit breaker of a supply: trips by too much current, is reset by hand.
struct Breaker {
  int supply;
  bool out;
  Breaker(int s, bool o) : supply(s), out(o) {}
};
// Faults of the wire, made by the transport in front of the emulator.
struct Unplug {
  bool on;
  explicit Unplug(bool o) : on(o) {}
};
struct Garble {  ///< flips bits in the next `bytes` from the controller
  int bytes;
  explicit Garble(int n) : bytes(n) {}
};
struct Drop {
  int bytes;
  explicit Drop(int n) : bytes(n) {}
};
}  // namespace bench

using BenchCommand =
    std::variant<bench::Input, bench::Limit, bench::HomeSwitch, bench::Analog, bench::Button, bench::Jam,
                 bench::Slip, bench::Alarm, bench::Place, bench::Power, bench::PowerCycle, bench::Breaker,
                 bench::Unplug, bench::Garble, bench::Drop>;

/// The visible state of the bench at one instant. Fixed size, copied without allocation.
struct BenchView {
  bool present = false;  ///< false: a real controller, nothing to see
  bool powered = true, unplugged = false;
  std::uint32_t switches_on = ~0u;  ///< bit n = the power switch of BenchFacts::supplies[n]
  std::uint32_t breakers_out = 0;   ///< bit n = its circuit breaker has tripped
  std::uint32_t lamps = 0;          ///< bit n = BenchFacts::lamps[n] lit
  std::uint32_t buttons = 0;        ///< bit n = BenchFacts::buttons[n] pressed
  std::uint32_t inputs_operated = 0;
  std::uint32_t outputs = 0;
  std::array<std::int32_t, 8> analog{};
  std::array<Steps, max_axes> load_position{};
  std::array<SwitchPlaces, max_axes> switches{};    ///< by axis
  std::uint32_t limits_minus = 0, limits_plus = 0;  ///< bit per axis: switch operated, by travel or by hand
  std::uint32_t limits_minus_by_hand = 0, limits_plus_by_hand = 0;
  std::uint32_t homes_by_hand = 0;
  std::uint32_t homes = 0, alarms = 0;  ///< bit per axis: operated, if it is an input of its own
  std::uint32_t jammed = 0;
  std::int64_t stores = -1;       ///< writes to the non-volatile memory so far; -1: it has none
  std::uint32_t lamps_blink = 0;  ///< bit n: the lamp is blinking
  bool operator==(const BenchView&) const = default;
};

/// A position-triggered output pulse, and when it began.
struct TriggerPulse {
  Instant at{};
  int output = 0;
  Duration width{};
  std::array<Steps, max_axes> position{};  ///< the controller's counters at that moment
};

}  // namespace hw
