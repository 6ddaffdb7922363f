#include <exception>

#include "gui/app/cli.h"
#include "gui/app/wiring.h"

int main(int argc, char** argv) {
  hw::app::prepare_process();
  try {
    return hw::app::run_command_line(argc, argv);
  } catch (const std::exception& defect) {
    return hw::app::complain(defect.what());
  }
}
