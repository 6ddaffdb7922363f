// Whole drawings of tests/core/drawing/files, drawn by two emulated controllers of one axis each on their
// bus, through the console's own conversation on a wire whose bytes take their time: the tool goes through
// every vertex.
#include <gtest/gtest.h>

#include "core/device/pieces_together.h"
#include "core/session/rehearse_together.h"
#include "core/session/session_group.h"
#include "core/session/way_together.h"
#include "core/time/virtual_scheduler.h"
#include "tests/core/drawing/drawable_files.h"
#include "tests/core/session/drawn_track.h"
#include "transports/open.h"

namespace hw {
namespace {

constexpr std::string_view bus = "dmx-k-sa@emulator,id=01-02,wire=real";

/// With power, and with their outputs for the tool.
std::vector<ControllerState> ready_to_draw() {
  IoContext io{1};
  VirtualScheduler time{io};
  const auto group = *SessionGroup::open(time, *Address::parse(bus), make_wire_opener(), [] {});
  time.run_for(std::chrono::seconds(5));
  for (const auto& member : group->members())
    for (const char* text : {"SL=0", "EO=1"}) member->send_text(text, false);
  time.run_for(std::chrono::seconds(5));
  std::vector<ControllerState> states;
  for (const auto& member : group->members()) states.push_back({member->known(), {}});
  asio::co_spawn(time.executor(), group->close(), asio::detached);
  time.run_for(std::chrono::seconds(5));
  return states;
}

struct DrawnByTwo : testing::TestWithParam<const char*>, DrawnTrack {
  DrawnByTwo() {
    std::vector<Catalog> catalogs;
    for (const Address& device : Address::parse(bus)->devices())
      catalogs.push_back(*find_device_type(device.model)->make_catalog(device.options));
    const std::vector<const Catalog*> members{&catalogs[0], &catalogs[1]};
    both = *catalog_together(members);
    o.axes = {{both.axes[0].name, per_unit}, {both.axes[1].name, per_unit}};
    o.tolerance = 0.02;
    o.cutting = {20, 0.5, 50}, o.travel = {50, 0.5, 50};
    o.placing.origin = drawing::Placing::Origin::lower_left;
    o.pen_down = {{sequence::Output{1, true}}};
    o.pen_up = {{sequence::Output{1, false}}};
  }
  void draw(const drawing::Drawing& drawing) {
    static const std::vector<ControllerState> states = ready_to_draw();
    const auto converted = convert(drawing, both, o);
    ASSERT_TRUE(converted) << converted.error().sentence();
    made = *converted;
    auto done = rehearse_together(made.sequence, *Address::parse(bus), states, make_wire_opener(),
                                  std::chrono::hours(10));
    ASSERT_TRUE(done) << done.error().sentence();
    ASSERT_TRUE(done->finished);
    rehearsal = std::move(*done);
  }
  Catalog both;
  ConversionOptions o;
};

TEST_P(DrawnByTwo, IsDrawnThroughEveryVertex) {
  ASSERT_NO_FATAL_FAILURE(draw(read_drawable(GetParam(), *o.tolerance)));
  expect_every_vertex();
}

TEST_P(DrawnByTwo, TheWayThatIsShownIsTheOneOfEachChain) {
  ASSERT_NO_FATAL_FAILURE(draw(read_drawable(GetParam(), *o.tolerance)));
  const WayTogether way = way_together(made, rehearsal, both);
  ASSERT_FALSE(way.path.points.empty());
  constexpr double step = 1 / per_unit;
  for (const drawing::ToolPath::Run& run : way.path.runs) {
    if (!run.tool_on) continue;  // the way to the first one is of none
    ASSERT_GE(run.source, 0);
    const drawing::Box box = drawing::box_of({made.chains[static_cast<std::size_t>(run.source)]});
    for (std::size_t i = run.first; i < run.first + run.size; ++i) {
      const drawing::Point3 p = way.path.points[i];
      ASSERT_TRUE(p.x > box.low.x - step && p.x < box.high.x + step && p.y > box.low.y - step &&
                  p.y < box.high.y + step)
          << "chain " << run.source << ": " << p.x << ", " << p.y << ", point " << i - run.first << " of "
          << run.size << "; " << box.low.x << " to " << box.high.x << ", " << box.low.y << " to "
          << box.high.y;
    }
  }
  EXPECT_GE(way.beside, 0);
  // Their starts are one command apart, with its answer: about 20 ms on a line at 9,600 baud.
  constexpr double apart_s = 0.03;
  EXPECT_LT(way.beside, o.cutting.high * apart_s);
}

INSTANTIATE_TEST_SUITE_P(Each, DrawnByTwo, testing::ValuesIn(drawable_files), [](const auto& info) {
  std::string name = info.param;
  name.resize(name.find('.'));
  for (char& c : name)
    if (c == '-' || c == '/') c = '_';
  return name;
});

}  // namespace
}  // namespace hw
