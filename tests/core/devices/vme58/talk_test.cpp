// The transcripts in tests/talk/vme58, said through the rings of the window in virtual time.
#include "tests/talk/talk.h"

#include <algorithm>
#include <filesystem>

#include "tests/core/devices/vme58/rig.h"

namespace hw::vme58::proof {
namespace {

class WindowPartner final : public talk::Partner {
 public:
  explicit WindowPartner(const DeviceOptions& options) : rig_(options) {}

  void send(std::string_view bytes) override { rig_.send(bytes); }
  std::string receive(std::size_t count) override {
    const Instant limit = rig_.now() + 24h;
    for (came_ += rig_.output(); came_.size() < count; came_ += rig_.output()) {
      const auto next = rig_.emulator().next_event();
      if (!next || *next > limit) break;
      rig_.run_for(std::max(*next - rig_.now(), Duration(1)));
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

std::vector<std::string> vme58_transcripts() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(HW_TEST_DIR "/talk/vme58"))
    if (entry.path().extension() == ".talk") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Vme58Talk : public ::testing::TestWithParam<std::string> {};

TEST_P(Vme58Talk, GoesAsWritten) {
  const std::string path = HW_TEST_DIR "/talk/vme58/" + GetParam() + ".talk";
  const auto transcript = talk::read(path);
  ASSERT_TRUE(transcript.has_value()) << transcript.error().sentence();
  WindowPartner partner(DeviceOptions(transcript->options.begin(), transcript->options.end()));
  for (const std::string& failure : talk::run(*transcript, partner)) ADD_FAILURE() << path << ", " << failure;
}

INSTANTIATE_TEST_SUITE_P(Transcripts, Vme58Talk, ::testing::ValuesIn(vme58_transcripts()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace hw::vme58::proof
