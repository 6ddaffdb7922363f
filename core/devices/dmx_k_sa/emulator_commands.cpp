#include "core/devices/dmx_k_sa/emulator_commands.h"

#include "core/devices/arcus/emulator_speeds.h"
#include "core/devices/dmx_k_sa/facts.h"

namespace hw::dmx_k_sa {
namespace {

using arcus::Answer;
using arcus::Arguments;
using arcus::Command;
using arcus::Controller;
using arcus::HomeMode;
using arcus::number_in;
using arcus::position_in;
using arcus::Refusal;

using Args = Arguments;

template <std::int64_t (Controller::*read)(int) const>
Answer value_of(Controller& c, const Args&) {
  return Answer::number((c.*read)(0));
}

// --- moves -------------------------------------------------------------------------------------------------

Answer move(Controller& c, const Args& a) {
  const auto target = arcus::parse_integer(a.value);
  return target ? c.move({*target}) : Refusal::unknown;
}

template <HomeMode mode>
Answer home(Controller& c, const Args& a) {
  return c.home(0, mode, a.sign);
}

Answer jog(Controller& c, const Args& a) { return c.jog(0, a.sign); }

Answer target(Controller& c, const Args& a) {
  const auto value = position_in(a.value);
  return value ? c.change_target(0, *value) : Refusal::unknown;
}

/// Start and target speed must lie in the window (decision AMB-058).
bool in_window(const Controller& c, std::int64_t pulses_per_second) {
  const std::int64_t wanted = std::max<std::int64_t>(c.settings().get(Setting::speed_window), 1);
  return arcus::speed_row(c.model(), static_cast<double>(pulses_per_second)).window == wanted;
}

Answer change_speed(Controller& c, const Args& a) {
  if (c.settings().on(Setting::s_curve)) return Refusal::speed_s_curve;
  const auto value = arcus::parse_integer(a.value);
  if (!value || *value < 1 || !c.moving(0)) return Refusal::speed;
  if (*value > arcus::max_speed) return Refusal::speed_window;
  const double ratio =
      c.settings().on(Setting::loop) ? static_cast<double>(c.settings().get(Setting::loop_ratio)) / 1000 : 1;
  const auto in_pulses = [&](std::int64_t v) {
    return static_cast<std::int64_t>(static_cast<double>(v) * ratio);
  };
  if (!in_window(c, in_pulses(c.speed(0))) || !in_window(c, in_pulses(*value))) return Refusal::speed_window;
  return c.change_speed(0, *value);
}

Answer unknown(Controller&, const Args&) { return Refusal::unknown; }

/// Beyond its effect on both models, it clears a StepNLoop error (chapter 9).
Answer abort(Controller& c, const Args&) {
  c.abort_all();
  c.clear_loop_error(0);
  return {};
}

// --- positions and status ----------------------------------------------------------------------------------

Answer set_position(Controller& c, const Args& a) {
  const auto value = position_in(a.value);
  return value ? c.set_position(0, *value) : Refusal::unknown;
}

Answer set_encoder(Controller& c, const Args& a) {
  const auto value = position_in(a.value);
  return value ? c.set_encoder(0, *value) : Refusal::unknown;
}

Answer move_mode(Controller& c, const Args&) { return Answer::number(c.incremental() ? 1 : 0); }
Answer current(Controller& c, const Args&) { return Answer::number(c.current_ma()); }
Answer loop_state(Controller& c, const Args&) {
  return Answer::number(static_cast<std::int64_t>(c.loop_state(0)));
}

// --- latch and sync ----------------------------------------------------------------------------------------

Answer arm_latch(Controller& c, const Args& a) {
  const auto on = number_in(a.value, 0, 1);
  if (!on) return Refusal::unknown;
  c.arm_latch(0, *on != 0);
  return {};
}

Answer latched_encoder(Controller& c, const Args&) { return Answer::number(c.latch(0).encoder); }
Answer latched_pulses(Controller& c, const Args&) { return Answer::number(c.latch(0).pulses); }
Answer latch_state(Controller& c, const Args&) { return Answer::number(c.latch(0).state); }
Answer sync_state(Controller& c, const Args&) { return Answer::number(c.sync_state(0)); }

Answer sync_on(Controller& c, const Args&) {
  c.sync_on(0);
  return {};
}

Answer sync_off(Controller& c, const Args&) {
  c.sync_off(0);
  return {};
}

constexpr Command table[] = {
    {"ABORT", abort},
    {"Js", jog},
    {"Hs", home<HomeMode::home>},
    {"HLs", home<HomeMode::home_high_low>},
    {"Ls", home<HomeMode::limit>},
    {"Zs", home<HomeMode::index>},
    {"ZHs", home<HomeMode::home_index>},
    {"SSPDMv", unknown},  // a broken SSPDM, no SSPD
    {"SSPDv", change_speed},
    {"MM", move_mode},
    {"CUR", current},
    {"DX", value_of<&Controller::loop_delta>},
    {"PX", value_of<&Controller::position>},
    {"PX=v", set_position},
    {"EX", value_of<&Controller::encoder>},
    {"EX=v", set_encoder},
    {"PS", value_of<&Controller::speed>},
    {"MST", value_of<&Controller::status>},
    {"SLS", loop_state},
    {"LT=v", arm_latch},
    {"LTE", latched_encoder},
    {"LTP", latched_pulses},
    {"LTS", latch_state},
    {"SYNO", sync_on},
    {"SYNF", sync_off},
    {"SYNS", sync_state},
    {"Tv", target},
    {"Xv", move},
};

}  // namespace

std::span<const Command> commands() { return table; }

}  // namespace hw::dmx_k_sa
