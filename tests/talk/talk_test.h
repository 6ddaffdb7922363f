#pragma once
// The transcripts of tests/talk as tests: which there are, and how one is run.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "tests/talk/talk.h"

namespace hw::talk {

/// Of one model, "vxm/status": a folder of tests/talk has the name of its model.
inline std::vector<std::string> transcripts(std::string_view model) {
  const std::filesystem::path folder = std::filesystem::path(HW_TEST_DIR "/talk") / model;
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".talk")
      names.push_back(std::string(model) + "/" + entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// What a test of this transcript is called.
inline std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

/// `make_partner` gets the transcript's options and gives the other end of the wire.
template <class MakePartner>
void goes_as_written(const std::string& name, MakePartner make_partner) {
  const std::string path = HW_TEST_DIR "/talk/" + name + ".talk";
  const auto transcript = read(path);
  ASSERT_TRUE(transcript.has_value()) << transcript.error().sentence();
  auto partner = make_partner(
      std::map<std::string, std::string>(transcript->options.begin(), transcript->options.end()));
  for (const std::string& failure : run(*transcript, partner)) ADD_FAILURE() << path << ", " << failure;
}

/// A device's test rig at the other end, in virtual time.
template <class Rig>
class RigPartner final : public Partner {
 public:
  explicit RigPartner(Rig rig) : rig_(std::move(rig)) {}

  void send(std::string_view bytes) override { rig_.send(bytes); }
  std::string receive(std::size_t count) override {
    const Duration limit = rig_.elapsed() + std::chrono::hours(24);
    for (came_ += rig_.output(); came_.size() < count; came_ += rig_.output()) {
      const auto next = rig_.emulator().next_event();
      if (!next || next->time_since_epoch() > limit) break;
      rig_.run_for(std::max(next->time_since_epoch() - rig_.elapsed(), Duration(1)));
    }
    std::string taken = came_.substr(0, count);
    came_.erase(0, count);
    return taken;
  }
  std::string leftover() override { return std::exchange(came_, {}) + rig_.output(); }
  void pass(Duration time) override { rig_.run_for(time); }
  Result<> operate(const BenchCommand& command) override { return rig_.emulator().operate(command); }

 private:
  Rig rig_;
  std::string came_;
};

}  // namespace hw::talk
