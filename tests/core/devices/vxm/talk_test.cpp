// The transcripts in tests/talk/vxm, held against the emulator in virtual time.
#include "tests/talk/talk_test.h"

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

class VxmTalk : public ::testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(VxmTalk, GoesAsWritten) {
  talk::goes_as_written(GetParam(),
                        [](const DeviceOptions& options) { return talk::RigPartner<Rig>(Rig(options)); });
}

INSTANTIATE_TEST_SUITE_P(Transcripts, VxmTalk, ::testing::ValuesIn(talk::transcripts("vxm")),
                         talk::test_name);

TEST(VxmTalkFormat, ReportsWhichLineIsWrong) {
  for (const char* text :
       {"# fine\n? X", ">X", "< \\q", "~ 3 hours", "! input", "> X\n@ motors=4", "! place 1 a"}) {
    const auto transcript = talk::parse(text);
    ASSERT_FALSE(transcript.has_value()) << text;
    EXPECT_NE(transcript.error().sentence().find("Line "), std::string::npos)
        << transcript.error().sentence();
  }
}

TEST(VxmTalkFormat, NoticesWhatIsOtherwise) {
  for (const char* text :
       {"> FV\n< B", "> FV\n< RR", "> FV", "> FV\n> X\n< +0000000\\r", "> FI1M400,R\n~ 2s\n<"}) {
    const auto transcript = talk::parse(text);
    ASSERT_TRUE(transcript.has_value()) << transcript.error().sentence();
    talk::RigPartner<Rig> partner{Rig()};
    EXPECT_FALSE(talk::run(*transcript, partner).empty()) << text;
  }
}

TEST(VxmTalkFormat, WritesBytesAsItReadsThem) {
  const std::string bytes("a\r\n\\\0\x7F\xC5 z", 9);
  const auto transcript = talk::parse("< " + talk::escape(bytes));
  ASSERT_TRUE(transcript.has_value());
  EXPECT_EQ(transcript->steps.at(0).bytes, bytes);
}

}  // namespace hw::vxm::proof
