// The transcripts in tests/talk/pmx-4ex-sa and tests/talk/dmx-k-sa, held against the emulators in virtual
// time.
#include "tests/talk/talk.h"

#include <algorithm>
#include <filesystem>

#include "tests/core/devices/arcus/rig.h"

namespace hw::arcus::proof {
namespace {

class RigPartner final : public talk::Partner {
 public:
  RigPartner(Which which, const Options& options) : rig_(which, options) {}

  void send(std::string_view bytes) override { rig_.emulator().receive(bytes); }
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
  Result<> operate(const BenchCommand& command) override { return rig_.operate(command); }

 private:
  Rig rig_;
  std::string came_;
};

std::vector<std::string> transcripts() {
  std::vector<std::string> names;
  for (const char* model : {"pmx-4ex-sa", "dmx-k-sa"})
    for (const auto& entry : std::filesystem::directory_iterator(std::string(HW_TEST_DIR "/talk/") + model))
      if (entry.path().extension() == ".talk") names.push_back(model + ("/" + entry.path().stem().string()));
  std::sort(names.begin(), names.end());
  return names;
}

class ArcusTalk : public ::testing::TestWithParam<std::string> {};

TEST_P(ArcusTalk, GoesAsWritten) {
  const std::string path = HW_TEST_DIR "/talk/" + GetParam() + ".talk";
  const auto transcript = talk::read(path);
  ASSERT_TRUE(transcript.has_value()) << transcript.error().sentence();
  const Which which = GetParam()[0] == 'p' ? Which::pmx : Which::dmx;
  RigPartner partner(which, Options(transcript->options.begin(), transcript->options.end()));
  for (const std::string& failure : talk::run(*transcript, partner)) ADD_FAILURE() << path << ", " << failure;
}

INSTANTIATE_TEST_SUITE_P(Transcripts, ArcusTalk, ::testing::ValuesIn(transcripts()), [](const auto& info) {
  std::string name = info.param;
  for (char& c : name)
    if (c == '/' || c == '-') c = '_';
  return name;
});

}  // namespace
}  // namespace hw::arcus::proof
