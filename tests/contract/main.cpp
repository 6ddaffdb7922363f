// gmock's main, the lies, and the example beside the listed controllers.
#include <algorithm>
#include <iostream>

#include <gmock/gmock.h>

#include "tests/contract/lies.h"
#include "tests/example/twin.h"

namespace {

/// Before the tests are listed, which names the types. False: it is no option of ours.
bool take(std::string_view argument) {
  constexpr std::string_view lie = "--lie=";
  return argument.starts_with(lie) && hw::choose_lie(argument.substr(lie.size()));
}

}  // namespace

int main(int argc, char** argv) {
  hw::add_device_type(hw::twin::device_type());
  argc = static_cast<int>(std::remove_if(argv + 1, argv + argc, take) - argv);
  testing::InitGoogleMock(&argc, argv);
  if (argc == 1) return RUN_ALL_TESTS();
  if (std::string_view(argv[1]) == "--lies") return hw::print_lies(), 0;
  std::cerr << "There is no option \"" << argv[1] << "\". --lies lists what can be told by --lie=NAME.\n";
  return 2;
}
