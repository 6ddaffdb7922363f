// Stored programs: their lines in flash, and the interpreter that runs them a turn each millisecond.
#include <algorithm>

#include "core/devices/arcus/emulator_controller.h"
#include "core/devices/arcus/emulator_program_host.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// Written through to flash (decision AMB-120). Running programs are unchanged until one is started.
Refusal Controller::set_program_line(int line, std::string_view text) {
  const bool printable = std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (!printable) return Refusal::unknown;
  flash_.program[ix(line)] = text;
  ++flash_.stores;
  program_is_new_ = true;
  return Refusal::none;
}

void Controller::load_programs() {
  if (!program_is_new_) return;
  program_is_new_ = false;
  const auto& pmx = language::pmx_4ex_sa();
  const auto& dialect = pmx.model == model_->name ? pmx : language::dmx_k_sa();
  vm_.load(std::make_shared<const language::Program>(language::decode(flash_.program, dialect)));
}

void Controller::control_program(int program, int what) {
  constexpr int run = 1;
  if (what == run) load_programs();
  vm_.control(program, what, now_);
}

Refusal Controller::call_subroutine(int number) {
  load_programs();
  switch (vm_.call(number, now_)) {
    case language::Vm::Call::started: return Refusal::none;
    case language::Vm::Call::undefined: return Refusal::no_subroutine;
    default: return Refusal::unknown;  // one is running (decision AMB-046)
  }
}

int Controller::program_state(int program) const { return static_cast<int>(vm_.state(program)); }
int Controller::program_place(int program) const { return vm_.line(program, now_); }

bool Controller::error_returns_to_start() const {
  if (settings_.has(Setting::error_return)) return settings_.on(Setting::error_return);
  const int bit = model_->polarity.jump.bit;
  return bit != no_bit && (settings_.get(Setting::polarity) >> bit & 1) != 0;
}

void Controller::programs_power_up() {
  vm_ = language::Vm();
  for (int n = first_stored_variable; n < variables; ++n) vm_.set_variable(n, flash_.values[ix(n)]);
  program_is_new_ = true;
  const std::int64_t which = settings_.get(Setting::boot_programs);
  for (int n = 0; n < model_->programs; ++n)
    if ((which >> n & 1) != 0) control_program(n, 1);
}

std::optional<Instant> Controller::program_turn() const { return vm_.next_turn(now_, ProgramHost(*this)); }

void Controller::run_programs() {
  ProgramHost host(*this);
  const auto turn = vm_.next_turn(now_, host);
  if (turn && *turn <= now_) vm_.run_turn(now_, host);
}

}  // namespace hw::arcus
