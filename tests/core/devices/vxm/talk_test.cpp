// The transcripts in tests/talk/vxm, held against the emulator in virtual time.
#include "tests/talk/talk.h"

#include <algorithm>
#include <filesystem>

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {
namespace {

class RigPartner final : public talk::Partner {
 public:
  explicit RigPartner(const DeviceOptions& options) : rig_(options) {}

  void send(std::string_view bytes) override { rig_.send(bytes); }
  std::string receive(std::size_t count) override {
    const Duration limit = rig_.elapsed() + 24h;
    for (came_ += rig_.output(); came_.size() < count; came_ += rig_.output()) {
      const auto next = rig_.emulator().next_event();
      if (!next || next->time_since_epoch() > limit) break;
      rig_.run_for(std::max(next->time_since_epoch() - rig_.elapsed(), Duration(1)));
    }
    std::string taken = came_.substr(0, count);
    came_.erase(0, count);
    return taken;
  }
  std::string leftover() override {
    std::string all = std::move(came_) + rig_.output();
    came_.clear();
    return all;
  }
  void pass(Duration time) override { rig_.run_for(time); }
  Result<> operate(const BenchCommand& command) override { return rig_.emulator().operate(command); }

 private:
  Rig rig_;
  std::string came_;
};

std::vector<std::string> transcripts() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(HW_TEST_DIR "/talk/vxm"))
    if (entry.path().extension() == ".talk") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class VxmTalk : public ::testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(VxmTalk, GoesAsWritten) {
  const std::string path = HW_TEST_DIR "/talk/vxm/" + GetParam() + ".talk";
  const auto transcript = talk::read(path);
  ASSERT_TRUE(transcript.has_value()) << transcript.error().sentence();
  RigPartner partner(DeviceOptions(transcript->options.begin(), transcript->options.end()));
  for (const std::string& failure : talk::run(*transcript, partner)) ADD_FAILURE() << path << ", " << failure;
}

INSTANTIATE_TEST_SUITE_P(Transcripts, VxmTalk, ::testing::ValuesIn(transcripts()),
                         [](const auto& info) { return info.param; });

TEST(VxmTalkFormat, SaysWhichLineIsWrong) {
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
    RigPartner partner({});
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
