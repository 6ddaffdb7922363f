// What is kept of a long rehearsal, and that it is told how much.
#include "core/emulation/track_keeper.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hw {
namespace {

/// Goes to and fro for as long as is asked, and rests in between.
class ToAndFro final : public Emulator {
 public:
  void receive(std::string_view) override {}
  void take_output(std::string&) override {}
  [[nodiscard]] std::optional<Instant> next_event() const override { return std::nullopt; }
  void advance_to(Instant now) override { now_ = now; }
  Result<> operate(const BenchCommand&) override { return {}; }
  void look(BenchView&) const override {}
  void report_truth(MachineTruth& truth) const override {
    truth.axis_count = 1;
    truth.axes[0].position = Steps(position());
    truth.axes[0].moving = true;
  }
  [[nodiscard]] const std::vector<TriggerPulse>& pulses() const override { return pulses_; }
  [[nodiscard]] int rate() const override { return 0; }
  [[nodiscard]] std::string save_memory() const override { return {}; }
  Result<> load_memory(std::string_view) override { return {}; }
  [[nodiscard]] std::uint64_t memory_version() const override { return 0; }
  [[nodiscard]] std::unique_ptr<Emulator> clone() const override { return nullptr; }

 private:
  [[nodiscard]] std::int64_t position() const {  // 100 s there, 20 s of rest, 100 s back
    const double t = std::fmod(seconds(now_.time_since_epoch()), 240);
    return static_cast<std::int64_t>(1000 * (t < 100 ? t : t < 120 ? 100 : t < 220 ? 220 - t : 0));
  }
  Instant now_{};
  std::vector<TriggerPulse> pulses_;
};

std::vector<RehearsedPlace> kept_of(double seconds_long) {
  ToAndFro machine;
  RehearseOptions options;
  options.track_every_s = track_seen_every_s;
  TrackKeeper keeper(machine, options);
  keeper.look(Instant{});
  while (const auto next = keeper.next()) {
    if (seconds(next->time_since_epoch()) > seconds_long) break;
    machine.advance_to(*next);
    keeper.look(*next);
  }
  return keeper.take();
}

TEST(TrackKeeper, KeepsAllOfAnHour) {
  const auto track = kept_of(3600);
  EXPECT_EQ(thinned_to(track, track_seen_every_s), 1);
  EXPECT_GT(track.size(), 140'000u);
}

TEST(TrackKeeper, ReportsThatALongOneWasThinned) {
  const auto track = kept_of(4 * 3600);
  EXPECT_LE(track.size(), Track::most_places);
  EXPECT_EQ(thinned_to(track, track_seen_every_s), 4);
  // A rest is still a rest from its begin to its end.
  double rests = 0;
  for (std::size_t i = 1; i < track.size(); ++i)
    if (track[i].position == track[i - 1].position) rests += track[i].t - track[i - 1].t;
  EXPECT_NEAR(rests, 60 * 40, 60 * 2 * 4 * track_seen_every_s);
}

}  // namespace
}  // namespace hw
