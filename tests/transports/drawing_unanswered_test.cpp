// A drawing in many programs, on a VXM that does not take or does not answer what begins the next of them:
// nothing follows, nothing is sent again, the tool is off, and it is known what is left. Seen on the
// emulator, not by what the console says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "tests/core/device/emulator_around.h"
#include "transports/serve.h"

namespace hw {
namespace {

namespace seq = sequence;
using namespace std::chrono_literals;

constexpr int tool_output = 1, chains = 40, chain_points = 8;

/// What becomes of a command, once.
struct Mishap {
  const char* name;
  std::string_view command;  ///< begins with this
  bool is_taken;             ///< by the controller
  Duration silence;          ///< nothing that the controller says arrives for so long
};
void PrintTo(const Mishap& mishap, std::ostream* out) { *out << mishap.name; }

class Unreliable final : public test::EmulatorAround {
 public:
  using EmulatorAround::EmulatorAround;

  void arm(const Mishap& mishap) { armed_ = mishap; }
  [[nodiscard]] bool has_happened() const { return happened_; }

  void receive(std::string_view bytes) override {
    if (armed_ && bytes.starts_with(armed_->command)) {
      happened_ = true;
      silent_until_ = now_ + armed_->silence;
      const bool is_taken = armed_->is_taken;
      armed_.reset();
      if (!is_taken) return;
    }
    inner_->receive(bytes);
  }
  void take_output(std::string& sink) override {
    std::string answer;
    inner_->take_output(answer);
    if (now_ >= silent_until_) sink += answer;
  }
  void advance_to(Instant now) override { inner_->advance_to(now_ = now); }
  void report_truth(MachineTruth& truth) const override { inner_->report_truth(truth); }

 private:
  std::optional<Mishap> armed_;
  bool happened_ = false;
  Instant now_{}, silent_until_{};
};

class DrawingUnanswered : public testing::TestWithParam<Mishap> {
 protected:
  void SetUp() override {
    const DeviceType* type = find_device_type("vxm");
    auto made_emulator = std::make_unique<Unreliable>(std::move(*type->make_emulator({})));
    emulator = made_emulator.get();
    const auto host = EmulatorHost::make(time, std::move(made_emulator), HostOptions());
    ASSERT_TRUE(host);
    const auto opener = [host = *host](Scheduler&, Address,
                                       std::shared_ptr<BenchAccess>) -> Task<Result<Wire>> {
      Wire wire;
      wire.stream = std::move(*host->plug_in());
      wire.benches.push_back(host->bench());
      co_return wire;
    };
    session = Session::open(time, *Address::parse("vxm@emulator"), opener, [] {}).value();
    ASSERT_TRUE(time.run_until(time.now() + 10s, [this] { return known().link.state == LinkState::good; }));
    time.run_for(2s);
  }
  ~DrawingUnanswered() override {
    asio::co_spawn(time.executor(), session->close(), asio::detached);
    time.run_for(2s);
  }
  [[nodiscard]] const Snapshot& known() const { return session->known(); }
  [[nodiscard]] bool tool_is_on() const {
    BenchView view;
    emulator->look(view);
    return (view.outputs >> (tool_output - 1) & 1u) != 0;
  }
  [[nodiscard]] MachineTruth truth() const {
    MachineTruth truth;
    emulator->report_truth(truth);
    return truth;
  }
  std::shared_ptr<const Pieces> drawing() const {
    seq::Sequence s;
    s.axes = {{"1", 1}};
    s.pen_down = {{seq::Output{tool_output, true}}}, s.pen_up = {{seq::Output{tool_output, false}}};
    s.steps = {{seq::Pen{false}}, {seq::Speed{{4000, 0, 50}}}};
    int at = 0;
    const auto go_on = [&](int by) {
      seq::Move m;
      m.to[0] = at += by;
      s.steps.push_back({m});
      s.steps.push_back({seq::WaitMotion{}});
    };
    for (int c = 0; c < chains; ++c) {
      go_on(100);
      s.steps.push_back({seq::Pen{true}});
      for (int p = 0; p < chain_points; ++p) go_on(200);
      s.steps.push_back({seq::Pen{false}});
    }
    auto pieces = session->type().language().in_pieces(s, session->catalog(), 0);
    EXPECT_TRUE(pieces) << pieces.error().sentence();
    pieces->drawing = 7;
    return std::make_shared<const Pieces>(std::move(*pieces));
  }
  std::string reported() {
    std::string all;
    session->notices().drain([&](const Notice& n) { all += n.text + "\n"; });
    return all;
  }

  IoContext io{1};
  VirtualScheduler time{io};
  Unreliable* emulator = nullptr;  ///< of the session's wire
  std::shared_ptr<Session> session;
};

INSTANTIATE_TEST_SUITE_P(Of, DrawingUnanswered,
                         testing::Values(Mishap{"ALoadThatIsLost", "C", false, 0s},
                                         Mishap{"ALoadBeforeASilence", "C", false, 3s},
                                         Mishap{"ARunThatIsLost", "R", false, 0s},
                                         Mishap{"ARunBeforeASilence", "R", false, 8s},
                                         Mishap{"ARunThatIsTakenBeforeASilence", "R", true, 8s}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(DrawingUnanswered, EndsItThere) {
  const auto pieces = drawing();
  ASSERT_GT(pieces->all.size(), 3u);
  session->send(intent::RunInPieces(pieces));
  ASSERT_TRUE(time.run_until(time.now() + 200s, [&] { return known().pieces.done == 1; }));
  const Steps first_end = truth().axes[0].position, second_end = pieces->all[1].ends_at.front().value;
  ASSERT_LT(first_end, second_end);
  emulator->arm(GetParam());
  ASSERT_TRUE(time.run_until(time.now() + 60s, [&] { return emulator->has_happened(); }));
  EXPECT_TRUE(time.run_until(time.now() + 1000s, [&] {
    return !known().pieces.running && !tool_is_on() && truth().moving() == 0;
  })) << tool_is_on();
  time.run_for(60s);
  EXPECT_FALSE(tool_is_on());
  EXPECT_FALSE(known().pieces.running);
  const Steps there = truth().axes[0].position;
  const std::string reports = reported();
  SCOPED_TRACE(reports);
  const PiecesState& now = known().pieces;
  if (GetParam().command == "C") {  // it is written once more: nothing has moved by it
    EXPECT_EQ(there, pieces->all[static_cast<std::size_t>(now.done - 1)].ends_at.front().value);
    EXPECT_TRUE(now.done == now.total || now.rest_of == 7) << now.done;
    return;
  }
  if (GetParam().is_taken)
    EXPECT_LE(there, second_end) << "nothing follows it";
  else
    EXPECT_EQ(there, first_end) << "nothing is run again";
  EXPECT_EQ(now.done, 1);
  EXPECT_EQ(now.rest_of, 7u) << "it can be gone on with";
  EXPECT_GE(now.rest_step, pieces->all[1].first_step);
  EXPECT_LT(now.rest_step, pieces->all[2].first_step);
  const bool noticed_at_once = GetParam().silence == 0s;
  EXPECT_THAT(reports, testing::HasSubstr(noticed_at_once ? "No further piece is sent."
                                                          : "The connection was lost for"));
}

}  // namespace
}  // namespace hw
