// Arcs go through the buffer of a PMX as chords, on a wire whose bytes take their time: what lasts longer
// than it takes to be sent goes as fast as was asked, the rest slower, which is told; and it never stands in
// between.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "transports/open.h"

namespace hw {
namespace {

namespace seq = sequence;
using namespace std::chrono_literals;

constexpr double steps_per_mm = 200, radius = 2, beside = 0.02;

/// One chain of half circles in rows up and down, drawn at that speed in mm/s.
seq::Sequence waves(int arcs, double speed) {
  seq::Sequence drawing;
  drawing.axes = {{"X", steps_per_mm}, {"Y", steps_per_mm}};
  drawing.tolerance = beside;
  drawing.pen_down = {{seq::Output{1, true}}};
  drawing.pen_up = {{seq::Output{1, false}}};
  drawing.steps = {{seq::Pen{false}}, {seq::Speed{{speed, 1, 50}}}, {seq::Move{}}, {seq::Pen{true}}};
  std::get<seq::Move>(drawing.steps[2].body).to = {0.0, 0.0};
  double x = 0;
  for (int n = 0; n < arcs; ++n) {
    const bool forth = n / 50 % 2 == 0;  // rows of fifty, so that it stays on the table
    const double centre = x + (forth ? radius : -radius);
    drawing.steps.push_back({seq::Arc{centre, 0, (n % 2 == 0) == forth ? 180.0 : -180.0}});
    x = 2 * centre - x;
  }
  drawing.steps.push_back({seq::Pen{false}});
  return drawing;
}

struct PmxBuffer : testing::Test {
  PmxBuffer() {
    const Address address = *Address::parse("pmx-4ex-sa@emulator,wire=real");
    session = Session::open(time, address, make_wire_opener(), [] {}).value();
    time.run_until(time.now() + 10s, [this] { return session->known().link.state == LinkState::good; });
    time.run_for(3s);
    session->send(intent::SetPower(-1, true));
    time.run_for(3s);
  }
  ~PmxBuffer() override {
    asio::co_spawn(time.executor(), session->close(), asio::detached);
    time.run_for(2s);
  }
  struct Drawn {
    int rows = 0;       ///< that were sent
    int stood = 0;      ///< so often it stood although there was more to be sent
    double took_s = 0;  ///< from the first row to the last
    std::string messages;
  };
  Drawn draw(int arcs, double speed) {
    auto pieces = session->type().language().in_pieces(waves(arcs, speed), session->catalog());
    EXPECT_TRUE(pieces) << pieces.error().sentence();
    EXPECT_EQ(pieces->all.size(), 1u) << "the tool is not lifted";
    session->send(intent::RunInPieces(std::make_shared<const Pieces>(std::move(*pieces))));
    Drawn drawn;
    std::optional<Instant> began;
    bool was_at_it = false, stands = false;
    EXPECT_TRUE(time.run_until(time.now() + std::chrono::hours(2), [&] {
      const Snapshot& now = session->known();
      was_at_it = was_at_it || now.pieces.running;
      if (now.feed.running && now.feed.total > arcs) {
        drawn.rows = now.feed.sent;
        if (!began && now.feed.sent > 0) began = time.now();
        MachineTruth truth;
        session->bench()->emulator().report_truth(truth);
        const bool stood = std::exchange(stands, began && truth.moving() == 0);
        drawn.stood += stands && !stood;
        if (began) drawn.took_s = seconds(time.now() - *began);
      }
      return was_at_it && !now.pieces.running;
    }));
    session->notices().drain([&](const Notice& n) { drawn.messages += n.text + "\n"; });
    EXPECT_EQ(session->known().pieces.done, session->known().pieces.total) << drawn.messages;
    return drawn;
  }

  IoContext io;
  VirtualScheduler time{io};
  std::shared_ptr<Session> session;
};

TEST_F(PmxBuffer, IsNeverEmptyWhileLinesLastLongerThanTheyTakeToBeSent) {
  const int arcs = 5000;
  const double speed = 8;
  const Drawn drawn = draw(arcs, speed);
  const double of_a_chord = 2 * std::acos(1 - beside / radius);
  EXPECT_NEAR(drawn.rows, arcs * std::ceil(3.1416 / of_a_chord), 10) << "no finer than was asked for";
  EXPECT_EQ(drawn.stood, 0);
  EXPECT_EQ(drawn.messages.find("slower"), std::string::npos) << drawn.messages;
  const double way = arcs * radius * 3.1416;
  EXPECT_NEAR(drawn.took_s, way / speed, 0.02 * way / speed);
}

TEST_F(PmxBuffer, IsNeverEmptySinceLinesThatAreTooShortGoSlowerAndThatIsReported) {
  const int arcs = 1000;
  const double speed = 60;
  const Drawn drawn = draw(arcs, speed);
  EXPECT_EQ(drawn.stood, 0);
  EXPECT_NE(drawn.messages.find("Short lines are drawn more slowly than set"), std::string::npos)
      << drawn.messages;
  EXPECT_GT(drawn.took_s, 1.5 * arcs * radius * 3.1416 / speed);
}

}  // namespace
}  // namespace hw
