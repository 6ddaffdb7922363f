// What an operator does. Numbers of a step: axes from 0, -1 for all; signs -1 and 1; times in milliseconds.
#include "tests/simulation/models.h"
#include "tests/simulation/stage.h"
#include "tests/simulation/steps.h"

namespace hw::simulation {
namespace {

AxisId axis(const Step& s, std::size_t place) { return AxisId{static_cast<std::uint8_t>(s.number(place))}; }
int whole(const Step& s, std::size_t place) { return static_cast<int>(s.number(place)); }
Sign sign(const Step& s, std::size_t place) { return s.number(place) < 0 ? Sign::minus : Sign::plus; }
std::uint32_t axes_of(int axis) { return axis < 0 ? Judge::all_axes : 1u << axis; }

// ---- stops: the judge hears of them first, at the instant of the press

void stop(Stage& stage, const Step& s) {
  stage.stop(s.device, axes_of(whole(s, 0)), StopKind::ramp, intent::Stop(whole(s, 0)));
}
void abort(Stage& stage, const Step& s) {
  stage.stop(s.device, axes_of(whole(s, 0)), StopKind::at_once, intent::Abort(whole(s, 0)));
}
void stop_wire(Stage& stage, const Step& s) { stage.stop_all_devices(s.number(0) != 0); }
void type_stop(Stage& stage, const Step& s) {
  for (const StopText& text : stage.facts().stops)
    if (text.text == s.text)
      stage.stop(s.device, axes_of(text.axis), StopKind::typed, intent::SendText(s.text));
}
void query_stop(Stage& stage, const Step& s) {
  for (const StopText& text : stage.facts().stops)
    if (text.text == s.text) stage.query_stop(s.device, axes_of(text.axis), s.text, Millis(s.number(0)));
}
void type_stop_closing(Stage& stage, const Step& s) { stage.stop_closing(s.device, s.text); }
void halt(Stage& stage, const Step& s) {
  stage.judge().halt_asked(s.device);
  stage.send(s.device, intent::HaltProgram(whole(s, 0)));
}

// ---- motion

void move_by(Stage& stage, const Step& s) {
  const Pps speed(static_cast<double>(s.number(2)));
  stage.move(s.device, axes_of(whole(s, 0)), Steps(s.number(1)),
             intent::MoveBy({{axis(s, 0), Steps(s.number(1))}}, speed));
}
void move_to(Stage& stage, const Step& s) {
  const Pps speed(static_cast<double>(s.number(2)));
  stage.move(s.device, axes_of(whole(s, 0)), Steps(),
             intent::MoveTo({{axis(s, 0), Steps(s.number(1))}}, speed));
}
void line(Stage& stage, const Step& s) {
  stage.move(s.device, 3u, Steps(),
             intent::MoveBy({{AxisId{0}, Steps(s.number(0))}, {AxisId{1}, Steps(s.number(1))}}));
}
void jog(Stage& stage, const Step& s) {
  stage.jog(s.device, axis(s, 0), sign(s, 1), Millis(s.number(2)), Stage::LetGo::by_hand);
}
/// A script holds it: nobody's hand lets go, and it lasts until a stop.
void script_jog(Stage& stage, const Step& s) {
  stage.move(s.device, axes_of(whole(s, 0)), Steps(), intent::JogStart(axis(s, 0), sign(s, 1), {}, false));
}
void jog_frozen(Stage& stage, const Step& s) {
  stage.jog(s.device, axis(s, 0), sign(s, 1), Millis(s.number(2)), Stage::LetGo::never);
}
void home(Stage& stage, const Step& s) {
  stage.move(s.device, axes_of(whole(s, 0)), Steps(), intent::Home(axis(s, 0), sign(s, 1), whole(s, 2)));
}

// ---- programs

void load(Stage& stage, const Step& s) {
  stage.send(s.device, intent::LoadProgram(whole(s, 0), s.text));
  stage.judge().program_loaded(s.device, stage.sent(), s.text.find("Tool off:") != s.text.npos);
}
void run(Stage& stage, const Step& s) {
  stage.judge().run_asked(s.device);
  stage.move(s.device, Judge::all_axes, Steps(), intent::RunProgram(whole(s, 0)));
}
void pieces(Stage& stage, const Step& s) { stage.run_in_pieces(s.device, whole(s, 0), whole(s, 1)); }
void together(Stage& stage, const Step& s) { stage.run_together(whole(s, 0), whole(s, 1)); }
void override_speed(Stage& stage, const Step& s) { stage.send(s.device, intent::OverrideSpeed(whole(s, 0))); }
void pause(Stage& stage, const Step& s) { stage.send(s.device, intent::Pause()); }
void resume(Stage& stage, const Step& s) {
  stage.judge().run_asked(s.device);
  stage.move(s.device, Judge::all_axes, Steps(), intent::Resume());
}
void step(Stage& stage, const Step& s) {
  stage.judge().run_asked(s.device);
  stage.move(s.device, Judge::all_axes, Steps(), intent::SingleStep());
}
void clear(Stage& stage, const Step& s) {
  stage.send(s.device, intent::ClearProgram(whole(s, 0)));
  stage.judge().program_loaded(s.device, stage.sent(), false);
}
void upload(Stage& stage, const Step& s) { stage.send(s.device, intent::UploadProgram(whole(s, 0))); }

// ---- the rest

void type(Stage& stage, const Step& s) { stage.type(s.device, s.text); }
/// A text that may move what it likes.
void type_motion(Stage& stage, const Step& s) {
  stage.judge().run_asked(s.device);
  stage.move(s.device, Judge::all_axes, Steps(), intent::SendText(s.text));
}
void query(Stage& stage, const Step& s) { stage.query(s.device, s.text, Millis(s.number(0))); }
void wait_idle(Stage& stage, const Step& s) { stage.wait_until_idle(s.device, Millis(s.number(0))); }
void wait_in_vain(Stage& stage, const Step& s) { stage.wait_in_vain(s.device, Millis(s.number(0))); }
void must_connect(Stage& stage, const Step& s) { stage.must_connect(s.device); }
/// It has to be refused: nobody expects a motion.
void run_in_vain(Stage& stage, const Step& s) { stage.send(s.device, intent::RunProgram(whole(s, 0))); }
void script(Stage& stage, const Step& s) { stage.script(s.device, s.text); }
void set_position(Stage& stage, const Step& s) {
  stage.send(s.device, intent::SetPosition(whole(s, 0), Steps(s.number(1))));
  stage.judge().position_set(s.device, axes_of(whole(s, 0)), stage.sent());
}
void trust(Stage& stage, const Step& s) {
  stage.send(s.device, intent::TrustPosition(axis(s, 0)));
  stage.judge().position_set(s.device, axes_of(whole(s, 0)), stage.sent());
}
void set_param(Stage& stage, const Step& s) {
  stage.send(s.device, intent::SetParam(s.text, s.number(0), true));
}
void read_params(Stage& stage, const Step& s) { stage.send(s.device, intent::ReadParams()); }
void store(Stage& stage, const Step& s) { stage.send(s.device, intent::Store()); }
void motor_power(Stage& stage, const Step& s) {
  stage.send(s.device, intent::SetPower(whole(s, 0), s.number(1) != 0));
}
void output(Stage& stage, const Step& s) {
  stage.judge().output_set(s.device);
  stage.send(s.device, intent::SetOutput(whole(s, 0), s.number(1) != 0));
}
void reconnect(Stage& stage, const Step& s) { stage.send(s.device, intent::Reconnect()); }
void read_again(Stage& stage, const Step& s) { stage.send(s.device, intent::ReadAgain()); }
void reset(Stage& stage, const Step& s) {
  stage.judge().restarted(s.device);
  stage.send(s.device, intent::Reset());
}
void close(Stage& stage, const Step&) { stage.close(); }
void open(Stage& stage, const Step&) { stage.open(); }

constexpr auto action = Verb::Kind::action, stops = Verb::Kind::stop;
// clang-format off
constexpr Verb operator_table[] = {
    {"stop", 1, stops, stop},                 // AXIS
    {"abort", 1, stops, abort},               // AXIS
    {"stop_wire", 1, stops, stop_wire},       // AT_ONCE
    {"type_stop", 0, stops, type_stop},       // "TEXT"
    {"query_stop", 1, stops, query_stop},     // PATIENCE "TEXT"
    {"type_stop_closing", 0, stops, type_stop_closing},  // "TEXT", behind close
    {"halt", 1, stops, halt},                 // THREAD
    {"move_by", 3, action, move_by, true},          // AXIS DISTANCE SPEED
    {"move_to", 3, action, move_to, true},          // AXIS TARGET SPEED
    {"line", 2, action, line, true},                // DISTANCES of the first two axes
    {"jog", 3, action, jog, true},                  // AXIS SIGN HELD
    {"jog_frozen", 3, action, jog_frozen, true},    // AXIS SIGN SHOWN: then no frame comes any more
    {"script_jog", 2, action, script_jog, true},  // AXIS SIGN
    {"home", 3, action, home, true},                // AXIS SIGN MODE
    {"load", 1, action, load},                // SLOT "TEXT"
    {"run", 1, action, run},                  // SLOT
    {"pieces", 2, action, pieces},            // WAYS LINES
    {"together", 2, action, together},        // WAYS LINES
    {"override_speed", 1, action, override_speed},  // PERCENT
    {"pause", 0, action, pause},
    {"resume", 0, action, resume},
    {"step", 0, action, step},
    {"clear", 1, action, clear},              // SLOT
    {"upload", 1, action, upload},            // SLOT
    {"type", 0, action, type},                // "TEXT"
    {"type_motion", 0, action, type_motion},  // "TEXT"
    {"query", 1, action, query},              // PATIENCE "TEXT"
    {"wait_idle", 1, action, wait_idle},      // PATIENCE
    {"script", 0, action, script, true},        // "CALLS": steps without their times, one a line
    {"wait_in_vain", 1, action, wait_in_vain},  // PATIENCE: it must tell why not
    {"must_connect", 0, action, must_connect},  // at the first attempt
    {"run_in_vain", 1, action, run_in_vain},    // SLOT: it must be refused
    {"set_position", 2, action, set_position},// AXIS VALUE
    {"trust", 1, action, trust},              // AXIS
    {"set_param", 1, action, set_param},      // VALUE "MNEMONIC"
    {"read_params", 0, action, read_params},
    {"store", 0, action, store},
    {"motor_power", 2, action, motor_power},  // AXIS ON
    {"output", 2, action, output},            // NUMBER ON
    {"reconnect", 0, action, reconnect},
    {"read_again", 0, action, read_again},
    {"reset", 0, action, reset},
    {"close", 0, action, close},              // all on the wire
    {"open", 0, action, open},
};
// clang-format on

}  // namespace

std::span<const Verb> operator_verbs() { return operator_table; }

const Verb* find_verb(std::string_view name) {
  for (const auto table : {operator_verbs(), world_verbs()})
    for (const Verb& verb : table)
      if (verb.name == name) return &verb;
  return nullptr;
}

}  // namespace hw::simulation
