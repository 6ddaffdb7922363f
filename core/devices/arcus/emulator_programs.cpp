// Stored programs: their lines and who runs them.
#include "core/devices/arcus/emulator_controller.h"

namespace hw::arcus {

Refusal Controller::set_program_line(int line, std::string_view text) {
  flash_.program[ix(line)] = text;
  ++flash_.stores;
  return Refusal::none;
}

void Controller::control_program(int, int) {}
Refusal Controller::call_subroutine(int) { return Refusal::no_subroutine; }
int Controller::program_state(int) const { return 0; }
int Controller::program_place(int) const { return 0; }
void Controller::programs_power_up() {}

}  // namespace hw::arcus
