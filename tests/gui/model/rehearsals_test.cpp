#include "gui/model/rehearsals.h"

#include <gtest/gtest.h>

#include "core/base/index.h"
#include "core/device/registry.h"
#include "tests/gui/model/toy_language.h"

namespace hw::gui {
namespace {

TEST(Rehearsals, ResultComesInALaterFrameWithTheTextItIsOf) {
  test::ToyLanguage language;
  Worker worker;
  Rehearsals rehearsals;
  RehearseOptions options;
  options.slot = 1;
  const Catalog catalog;
  rehearsals.start(language, "I1\nI2\nI3", options, {}, {}, catalog, worker);
  rehearsals.start(language, "I1", options, {}, {}, catalog, worker);
  EXPECT_TRUE(rehearsals.under_way(1));
  EXPECT_EQ(rehearsals.of(1), nullptr);
  worker.deliver();
  EXPECT_EQ(language.rehearsed, 1);
  ASSERT_NE(rehearsals.of(1), nullptr);
  EXPECT_FALSE(rehearsals.under_way(1));
  EXPECT_EQ(rehearsals.of(1)->result->moves, 40);
  EXPECT_EQ(rehearsals.older_than_line(1, "I1\nI2\nI3"), -1);
  EXPECT_EQ(rehearsals.older_than_line(1, "I1\nI2\nI4"), 2);
}

TEST(Rehearsals, ReportThatTheyDoNotBeginWhereTheAxesStand) {
  test::ToyLanguage language;  // whose rehearsals begin at 0
  Worker worker;
  Rehearsals rehearsals;
  Catalog catalog;
  catalog.axes = {{"1", "motor 1"}, {"2", "motor 2"}};
  Snapshot now;
  now.axis_count = 2;
  now.axes[0].position_known = now.axes[1].position_known = true;
  BenchView bench;
  bench.present = true;
  rehearsals.start(language, "I1", {}, {now, {}}, bench, catalog, worker);
  worker.deliver();
  const auto start = [&] {
    rehearsals.follow(now, bench, catalog);
    return rehearsals.of(0)->start;
  };
  EXPECT_EQ(start().match, StartMatch::here);
  now.axes[1].position = Steps(400);
  EXPECT_EQ(start(), (StartDifference{StartMatch::elsewhere, 1, Steps(0), Steps(400)}));
  now.axes[0].activity = Activity::moving;
  EXPECT_EQ(start().match, StartMatch::moving);
  now.axes[0].activity = Activity::idle, now.axes[1].position = Steps(0);
  bench.switches[0].plus = Steps(100);
  EXPECT_EQ(start().match, StartMatch::other_bench);
  bench.switches[0].plus.reset();
  now.axes[0].position_known = false;
  EXPECT_EQ(start().match, StartMatch::unknown);
  now.axes[0].position_known = true;
  EXPECT_EQ(start().match, StartMatch::here);
  now.program.owned = true, now.program.run = RunState::running, now.axes[0].position = Steps(7);
  EXPECT_EQ(start().match, StartMatch::here) << "it is on its way, and began there";
  now.program.run = RunState::idle;
  EXPECT_EQ(start().match, StartMatch::elsewhere);
}

// What has changed is told by its kind and its place, whatever it is of all that the rehearsal began from.
TEST(Rehearsals, ReportWhatHasChangedOfTheWholeController) {
  test::ToyLanguage language;
  Worker worker;
  Rehearsals rehearsals;
  Catalog catalog;
  catalog.axes = {{"1", "motor 1"}};
  catalog.params.resize(3);
  catalog.params[2].fallback = 40;
  catalog.analog = {{"AI1", "mV", 0, 5000}, {"AI2", "mV", 0, 5000}};
  catalog.readouts.resize(4);
  catalog.readouts[2].id = "MM";
  catalog.readouts[3].id = "LTS", catalog.readouts[3].axis = 0;
  Snapshot now;
  now.analog[1] = 900, now.analog_known = 3;
  now.readouts_known.set(0).set(2);
  now.axes[0].has_encoder = true, now.axes[0].limits_known = true;
  now.axis_count = 1;
  now.axes[0].position_known = true;
  now.params[1].known = true, now.params[1].value = 7;
  now.outputs_known = now.inputs_known = 0xF;
  now.variables_known.set(5);
  std::string other_program = "I1M5";
  rehearsals.start(language, "I1", {}, {now, {{0, "old"}, {2, "I1M5"}}}, {}, catalog, worker);
  worker.deliver();
  const auto start = [&] {
    rehearsals.follow(now, {}, catalog, [&](int slot) { return slot == 1 ? nullptr : &other_program; });
    return rehearsals.of(0)->start;
  };
  EXPECT_EQ(start(), StartDifference());
  const auto reported = [&](auto change) {
    const Snapshot before = now;
    change();
    const StartDifference stood = start();
    now = before;
    other_program = "I1M5";
    EXPECT_EQ(start(), StartDifference()) << "as before";
    return stood;
  };
  EXPECT_EQ(reported([&] { now.params[1].value = 8; }),
            (StartDifference{StartMatch::other_setup, 1, Steps(7), Steps(8)}));
  EXPECT_EQ(reported([&] { now.params[2].known = true, now.params[2].value = 41; }),
            (StartDifference{StartMatch::other_setup, 2, Steps(40), Steps(41)}))
      << "it was taken to be 40";
  EXPECT_EQ(reported([&] { now.params[2].known = true, now.params[2].value = 40; }), StartDifference());
  EXPECT_EQ(reported([&] { now.outputs = 4; }),
            (StartDifference{StartMatch::other_output, 2, Steps(0), Steps(1)}));
  EXPECT_EQ(reported([&] { now.inputs = 8; }),
            (StartDifference{StartMatch::other_input, 3, Steps(0), Steps(1)}));
  EXPECT_EQ(reported([&] { now.variables[5] = -9; }),
            (StartDifference{StartMatch::other_variable, 5, Steps(0), Steps(-9)}));
  EXPECT_EQ(reported([&] { now.axes[0].enabled = false; }).match, StartMatch::other_power);
  EXPECT_EQ(reported([&] { now.axes[0].error = AxisError::limit_plus; }).match, StartMatch::other_power);
  EXPECT_EQ(reported([&] { now.axes[0].alarm = true; }).match, StartMatch::other_power);
  EXPECT_EQ(reported([&] { now.axes[0].encoder = Steps(9); }).match, StartMatch::other_encoder);
  EXPECT_EQ(reported([&] { now.axes[0].encoder = Steps(1); }), StartDifference()) << "it only trembles";
  EXPECT_EQ(reported([&] { now.axes[0].limit_plus = true; }).match, StartMatch::other_switch);
  EXPECT_EQ(reported([&] { now.axes[0].limits_known = false; }),
            (StartDifference{StartMatch::other_switch, 0, {}, {}, true}));
  EXPECT_EQ(reported([&] { now.analog[1] = 100; }),
            (StartDifference{StartMatch::other_analog, 1, Steps(900), Steps(100)}));
  EXPECT_EQ(reported([&] { now.analog[1] = 930; }), StartDifference()) << "it only trembles";
  EXPECT_EQ(reported([&] { now.readouts[2] = 1; }),
            (StartDifference{StartMatch::other_readout, 2, Steps(0), Steps(1)}));
  EXPECT_EQ(reported([&] { now.readouts_known.set(3), now.readouts[3] = 2; }),
            (StartDifference{StartMatch::other_readout, 3, Steps(0), Steps(2)}))
      << "it was taken to be off";
  EXPECT_EQ(reported([&] { now.readouts[0] = 1; }), StartDifference()) << "no rehearsal begins from it";
  EXPECT_EQ(reported([&] { other_program = "I1M6"; }),
            (StartDifference{StartMatch::other_program, 2, {}, {}}));
  EXPECT_EQ(reported([&] { now.inputs_known = 0, now.inputs = 1; }),
            (StartDifference{StartMatch::other_input, 0, Steps(0), {}, true}));
}

// What is not compared afterwards does not come into a rehearsal at all.
TEST(Rehearsals, AreReportedWhatIsComparedAndNothingElse) {
  test::ToyLanguage language;
  Worker worker;
  Rehearsals rehearsals;
  const Catalog catalog = test::toy_catalog();
  ControllerState from;
  from.now.axis_count = 2;
  from.now.axes[1].position = Steps(12), from.now.axes[1].position_known = true;
  from.now.axes[1].speed = Pps(5), from.now.readouts_known.set();
  from.programs[2] = "I1";
  rehearsals.start(language, "I1", {}, from, {}, catalog, worker);
  worker.deliver();
  const ControllerState& reported = *rehearsals.of(0)->scene.state;
  EXPECT_EQ(reported.now.axes[1].position, Steps(12));
  EXPECT_EQ(reported.programs, from.programs);
  EXPECT_EQ(reported.now.axes[1].speed, Pps());
  EXPECT_TRUE(reported.now.readouts_known.none());
}

// ---- every fact that the clone of a controller begins with, on each controller

/// A controller of which everything is known, and a rehearsal from there.
struct Cloned : ::testing::TestWithParam<std::string> {
  Cloned() {
    now.axis_count = static_cast<int>(catalog.axes.size());
    for (int i = 0; i < now.axis_count; ++i) {
      AxisState& axis = now.axes[ix(i)];
      axis.position_known = axis.limits_known = axis.has_encoder = true;
      axis.activity = Activity::idle;
      if (catalog.axes[ix(i)].servo) axis.loop = Loop::in_place;
    }
    for (std::size_t i = 0; i < catalog.params.size(); ++i)
      now.params[i] = {catalog.params[i].fallback, true, true};
    now.inputs_known = bits(catalog.inputs.size()), now.outputs_known = bits(catalog.outputs.size());
    now.analog_known = bits(catalog.analog.size());
    for (std::size_t i = 0; i < catalog.readouts.size(); ++i) now.readouts_known.set(i);
    for (int n = 0; n < catalog.variables.count; ++n) now.variables_known.set(ix(n));
    now.slot_bytes_used.fill(0);
    for (int i = 0; i < now.axis_count; ++i) {
      now.queue_free[ix(i)] = static_cast<std::int16_t>(catalog.queue_depth);
      if (catalog.queue_depth > 0) now.queue_known |= 1u << i;
    }
    ControllerState from{now, {}};
    for (int slot = 1; slot < catalog.program.slots; ++slot) from.programs[slot] = other_program;
    const std::string text = GetParam() == "vxm" ? "C,R" : GetParam() == "vme58" ? "AX" : "END";
    rehearsals.start(type.language(), text, {}, from, {}, catalog, worker);
    worker.deliver();
  }
  static std::uint32_t bits(std::size_t n) { return static_cast<std::uint32_t>((1ull << n) - 1); }

  StartDifference start() {
    rehearsals.follow(now, {}, catalog, [this](int slot) {
      if (catalog.program.threads > 0 || slot == 0) return &no_program;
      return knows_programs ? &other_program : nullptr;
    });
    return rehearsals.of(0)->start;
  }
  /// How the rehearsal compares while `change` holds; afterwards, everything is as before.
  template <class Change>
  StartDifference after(Change change) {
    const Snapshot before = now;
    const std::string program_before = other_program;
    change();
    const StartDifference stood = start();
    now = before, other_program = program_before, knows_programs = true;
    EXPECT_EQ(start(), StartDifference()) << "as before";
    return stood;
  }
  static void expect(const StartDifference& start, StartMatch match, std::size_t which, bool unread = false) {
    EXPECT_EQ(start.match, match) << which;
    EXPECT_EQ(start.which, static_cast<int>(which));
    EXPECT_EQ(start.unread, unread) << which;
  }

  const DeviceType& type = *find_device_type(GetParam());
  const Catalog catalog = *type.make_catalog({});
  std::string other_program = "I1M5", no_program;
  bool knows_programs = true;
  Snapshot now;
  Worker worker;
  Rehearsals rehearsals;
};

TEST_P(Cloned, HoldsWhileNothingChanges) {
  const auto& result = rehearsals.of(0)->result;
  ASSERT_TRUE(result) << result.error().sentence();
  EXPECT_EQ(start(), StartDifference());
}

TEST_P(Cloned, EachAxisAges) {
  for (std::size_t i = 0; i < catalog.axes.size(); ++i) {
    AxisState& axis = now.axes[i];
    expect(after([&] { axis.position = axis.command = Steps(5); }), StartMatch::elsewhere, i);
    expect(after([&] { axis.position_known = false; }), StartMatch::unknown, i);
    expect(after([&] { axis.in_counts = true; }), StartMatch::other_count, i);
    expect(after([&] { axis.activity = Activity::moving; }), StartMatch::moving, i);
    expect(after([&] { axis.enabled = !axis.enabled; }), StartMatch::other_power, i);
    expect(after([&] { axis.error = AxisError::limit; }), StartMatch::other_power, i);
    expect(after([&] { axis.alarm = true; }), StartMatch::other_power, i);
    expect(after([&] { axis.limit_plus = true; }), StartMatch::other_switch, i);
    expect(after([&] { axis.home = true; }), StartMatch::other_switch, i);
    expect(after([&] { axis.limits_known = false; }), StartMatch::other_switch, i, true);
    if (axis.loop == Loop::none) {
      expect(after([&] { axis.encoder = Steps(9); }), StartMatch::other_encoder, i);
    } else {
      expect(after([&] { axis.loop = Loop::open; }), StartMatch::other_power, i);
      expect(after([&] { axis.loop = Loop::unknown; }), StartMatch::other_power, i, true);
    }
  }
}

TEST_P(Cloned, EachParameterAges) {
  for (std::size_t i = 0; i < catalog.params.size(); ++i) {
    expect(after([&] { ++now.params[i].value; }), StartMatch::other_setup, i);
    expect(after([&] { now.params[i].known = false; }), StartMatch::other_setup, i, true);
  }
}

TEST_P(Cloned, EachInputAndOutputAges) {
  for (std::size_t i = 0; i < catalog.inputs.size(); ++i) {
    expect(after([&] { now.inputs ^= 1u << i; }), StartMatch::other_input, i);
    expect(after([&] { now.inputs_known &= ~(1u << i); }), StartMatch::other_input, i, true);
  }
  for (std::size_t i = 0; i < catalog.outputs.size(); ++i) {
    expect(after([&] { now.outputs ^= 1u << i; }), StartMatch::other_output, i);
    expect(after([&] { now.outputs_known &= ~(1u << i); }), StartMatch::other_output, i, true);
  }
  for (std::size_t i = 0; i < catalog.analog.size(); ++i) {
    expect(after([&] { now.analog[i] = catalog.analog[i].maximum; }), StartMatch::other_analog, i);
    expect(after([&] { now.analog_known &= ~(1u << i); }), StartMatch::other_analog, i, true);
  }
}

TEST_P(Cloned, EachModeAndVariableAges) {
  for (std::size_t i = 0; i < catalog.readouts.size(); ++i) {
    if (!acts_on_programs(catalog.readouts[i])) continue;
    expect(after([&] { now.readouts[i] = 1; }), StartMatch::other_readout, i);
    expect(after([&] { now.readouts_known.reset(i); }), StartMatch::other_readout, i, true);
  }
  for (std::size_t n = 0; n < static_cast<std::size_t>(catalog.variables.count); ++n) {
    expect(after([&] { now.variables[n] = -7; }), StartMatch::other_variable, n);
    expect(after([&] { now.variables_known.reset(n); }), StartMatch::other_variable, n, true);
  }
}

TEST_P(Cloned, EachProgramAndQueueAges) {
  if (catalog.program.slots > 1) {
    expect(after([&] { other_program = "I1M6"; }), StartMatch::other_program, 1);
    expect(after([&] { knows_programs = false; }), StartMatch::other_program, 1, true);
    expect(after([&] { now.slot_bytes_used[1] = 4; }), StartMatch::other_program, 1);
  }
  EXPECT_EQ(after([&] { now.feed.running = true; }).match, StartMatch::other_queue);
  for (std::size_t i = 0; catalog.queue_depth > 0 && i < catalog.axes.size(); ++i)
    EXPECT_EQ(after([&] { --now.queue_free[i]; }).match, StartMatch::other_queue);
  if (catalog.queue_depth > 0) {
    EXPECT_EQ(after([&] { now.working = true; }).match, StartMatch::other_queue);
  }
}

TEST_P(Cloned, NoneBeginsWhileCommandsWait) {
  EXPECT_EQ(why_not_rehearse_now(now, catalog), "");
  now.feed.running = true;
  EXPECT_NE(why_not_rehearse_now(now, catalog), "");
  now.feed.running = false;
  if (catalog.queue_depth > 0) {
    --now.queue_free[0];
    EXPECT_NE(why_not_rehearse_now(now, catalog), "");
  }
}

INSTANTIATE_TEST_SUITE_P(All, Cloned, ::testing::Values("vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"),
                         [](const auto& info) { return info.param.substr(0, info.param.find('-')); });

// What the run cannot meet, or what its own text fills, does not matter to it.
TEST(Rehearsals, AreNotAgedByTheProgramsOfTheirOwnText) {
  test::ToyLanguage language;
  Worker worker;
  Rehearsals rehearsals;
  const Catalog catalog = test::toy_catalog();
  const ControllerState from{{}, {{1, "I1M5"}, {2, "I1M5"}}};
  rehearsals.start(language, "I1\nPM-1\nI2", {}, from, {}, catalog, worker);
  worker.deliver();
  const std::string then = "I1M5", now = "I2";
  const auto start = [&](const std::string* first, const std::string* second) {
    rehearsals.follow({}, {}, catalog, [&](int slot) { return slot == 1 ? first : second; });
    return rehearsals.of(0)->start;
  };
  EXPECT_EQ(start(&then, &then), StartDifference());
  EXPECT_EQ(start(&now, &then), StartDifference()) << "the text was loaded";
  EXPECT_EQ(start(&now, &now), (StartDifference{StartMatch::other_program, 2, {}, {}}));
}

}  // namespace
}  // namespace hw::gui
