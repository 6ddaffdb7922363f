// The console on the emulated USB device: another process, as a user starts it, with the script of the
// checklist.
#include <cstdlib>

#include <gtest/gtest.h>

#include "core/device/registry.h"
#include "tests/usb/emulated_usb.h"

namespace hw {
namespace {

TEST(ConsoleOnUsb, OpensTheOnlyDeviceWithOneAction) {
  auto emulator = find_device_type("pmx-4ex-sa")->make_emulator({{"framing", "usb"}});
  ASSERT_TRUE(emulator) << emulator.error().sentence();
  UMockdevTestbed* bus = umockdev_testbed_new();
  ASSERT_TRUE(umockdev_in_mock_environment()) << "run this with umockdev-wrapper";
  {
    test::EmulatedUsb device(bus, std::move(*emulator), "4ex00", 3);
    const int status =
        std::system(HW_PROGRAM " run --gui --realtime " HW_SOURCE_DIR "/tests/scripts/gui/checklist_usb.lua");
    EXPECT_EQ(status, 0);
    const auto commands = device.commands();
    for (const char* sent : {"ID", "EO1=1"})
      EXPECT_NE(std::find(commands.begin(), commands.end(), sent), commands.end()) << sent;
  }
  g_object_unref(bus);
}

}  // namespace
}  // namespace hw
