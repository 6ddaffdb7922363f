#include <exception>

#include "gui/app/cli.h"

int main(int argc, char** argv) {
  try {
    return hw::app::run_command_line(argc, argv);
  } catch (const std::exception& defect) {
    return hw::app::complain(defect.what());
  }
}
