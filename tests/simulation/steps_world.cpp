// What happens to the machine and to the wire. Directions: 0 to the controller, 1 to the console.
#include "tests/simulation/stage.h"
#include "tests/simulation/steps.h"

namespace hw::simulation {
namespace {

AxisId axis(const Step& s) { return AxisId{static_cast<std::uint8_t>(s.number(0))}; }

// ---- the machine

void limit(Stage& stage, const Step& s) {
  stage.operate(s.device,
                bench::Limit(axis(s), s.number(1) < 0 ? Sign::minus : Sign::plus, s.number(2) != 0));
}
void jam(Stage& stage, const Step& s) { stage.operate(s.device, bench::Jam(axis(s), s.number(1) != 0)); }
void input(Stage& stage, const Step& s) {
  stage.operate(s.device, bench::Input(static_cast<int>(s.number(0)), s.number(1) != 0));
}
void power_cycle(Stage& stage, const Step& s) {
  stage.judge().restarted(s.device);
  stage.cut_power(s.device);
}
/// Another program on the same line says this to the controller.
void other_host(Stage& stage, const Step& s) {
  for (int device = 0; device < stage.devices(); ++device) stage.judge().others_talk(device);
  stage.faults().out.talked_into(stage.now());
  stage.faults().in.talked_into(stage.now());
  stage.other_host_sends(s.text);
}

// ---- the wire

WayFaults& way(Stage& stage, const Step& s) {
  return s.number(0) == 0 ? stage.faults().out : stage.faults().in;
}
Instant in_future(Stage& stage, const Step& s, std::size_t place) {
  return stage.now() + Millis(s.number(place));
}
void garble(Stage& stage, const Step& s) { way(stage, s).garble = {s.number(1), s.number(2)}; }
void drop(Stage& stage, const Step& s) { way(stage, s).drop = {s.number(1), s.number(2)}; }
void twice(Stage& stage, const Step& s) { way(stage, s).twice = {s.number(1), s.number(2)}; }
void cut(Stage& stage, const Step& s) { way(stage, s).cut_until = in_future(stage, s, 1); }
void delay(Stage& stage, const Step& s) {
  way(stage, s).delay = Millis(s.number(1));
  way(stage, s).slow_until = in_future(stage, s, 2);
}
void habit(Stage& stage, const Step& s) {
  way(stage, s).habit = {static_cast<char>(s.number(1)), s.number(2), s.number(3) != 0};
}
void unknown(Stage& stage, const Step& s) { stage.faults().unknown.name = s.text; }
void gaps(Stage& stage, const Step& s) {
  way(stage, s).gap = Millis(s.number(1));
  way(stage, s).gaps_until = in_future(stage, s, 2);
}
void merge(Stage& stage, const Step& s) { way(stage, s).merge_until = in_future(stage, s, 1); }
void babble(Stage& stage, const Step& s) {
  stage.faults().babbles_until = in_future(stage, s, 0);
  if (stage.faults().begin_babble) stage.faults().begin_babble();
}
void unplug(Stage& stage, const Step& s) { stage.unplug(Millis(s.number(0))); }
void silent(Stage& stage, const Step& s) { stage.faults().silent_until = in_future(stage, s, 0); }
void slow_cycles(Stage& stage, const Step& s) {
  stage.faults().slow_by = Millis(s.number(0));
  stage.faults().slow_until = in_future(stage, s, 1);
}
void bus_error(Stage& stage, const Step& s) { stage.faults().cycle_faults = static_cast<int>(s.number(0)); }

constexpr auto on_bench = Verb::Kind::bench, fault = Verb::Kind::fault;
// clang-format off
constexpr Verb world_table[] = {
    {"limit", 3, on_bench, limit},          // AXIS SIDE ON
    {"jam", 2, on_bench, jam},              // AXIS ON
    {"input", 2, on_bench, input},          // NUMBER ON
    {"power_cycle", 0, fault, power_cycle},
    {"other_host", 0, fault, other_host},   // "BYTES"
    {"garble", 3, fault, garble},           // WAY SKIP COUNT
    {"drop", 3, fault, drop},               // WAY SKIP COUNT
    {"twice", 3, fault, twice},             // WAY SKIP COUNT
    {"cut", 2, fault, cut},                 // WAY TIME
    {"delay", 3, fault, delay},             // WAY LATE TIME
    {"habit", 4, fault, habit},             // WAY BYTE EVERY DOUBLES: of some bytes, all the time
    {"unknown", 0, fault, unknown},         // "COMMAND"
    {"gaps", 3, fault, gaps},               // WAY GAP TIME: between bytes
    {"merge", 2, fault, merge},             // WAY TIME: then all at once
    {"babble", 1, fault, babble},           // TIME
    {"unplug", 1, fault, unplug},           // TIME
    {"silent", 1, fault, silent},           // TIME
    {"slow_cycles", 2, fault, slow_cycles}, // BY TIME
    {"bus_error", 1, fault, bus_error},     // VISITS
};
// clang-format on

}  // namespace

std::span<const Verb> world_verbs() { return world_table; }

}  // namespace hw::simulation
