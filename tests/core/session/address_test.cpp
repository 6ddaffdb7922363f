#include "core/session/address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hw {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Address address(const std::string& text) {
  auto read = Address::parse(text);
  EXPECT_TRUE(read) << read.error().sentence();
  return read ? *read : Address();
}

TEST(AddressIds, OneSeveralOrNone) {
  EXPECT_THAT(address("vxm@serial:/dev/ttyUSB0").ids(), IsEmpty());
  EXPECT_THAT(address("vxm@serial:/dev/ttyUSB0,id=07").ids(), ElementsAre("07"));
  EXPECT_THAT(address("vxm@serial:/dev/ttyUSB0,id=08-11").ids(), ElementsAre("08", "09", "10", "11"));
  EXPECT_EQ(address("vxm@emulator,id=00-99").ids().size(), 100u);
}

TEST(AddressIds, EachDeviceHasAnAddressOfItsOwn) {
  const auto devices = address("vxm@tcp:h:1,id=01-02,motors=2").devices();
  ASSERT_EQ(devices.size(), 2u);
  EXPECT_EQ(devices[0].text(), "vxm@tcp:h:1,id=01,motors=2");
  EXPECT_EQ(devices[1].text(), "vxm@tcp:h:1,id=02,motors=2");
  EXPECT_EQ(address("vxm@emulator").devices().size(), 1u);
}

TEST(AddressIds, AnInvalidIdIsReported) {
  for (const char* wrong : {"7", "007", "1-4", "01-", "-04", "04-01", "01-01", "01,03-", "a1", "01-0x"}) {
    const auto read = Address::parse(std::string("vxm@emulator,id=") + wrong);
    ASSERT_FALSE(read) << wrong;
    EXPECT_THAT(read.error().sentence(),
                testing::AnyOf(HasSubstr("two digits"), HasSubstr("not a key=value")))
        << wrong;
  }
}

}  // namespace
}  // namespace hw
