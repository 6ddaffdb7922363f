// Nothing that is said moves what moves metal: every panel in every kind of window, with all numbers of axes,
// over all states, digits, units and refusals. What can start motion, what stops it, the steps and the speed
// of jogging have the same rectangles in all of them.
#include <cmath>
#include <functional>
#include <map>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "gui/model/jog_choice.h"
#include "panels/widget_path.h"
#include "tests/gui/model/toy_language.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/full_catalog.h"
#include "tests/panels/window_catalog.h"

namespace hw::panels {
namespace {

using namespace gui;

struct FixedWindow {
  const char* name;
  int width, height;
  float scale;
};
constexpr FixedWindow fixed_windows[] = {{"wide", 1440, 900, 1},
                                         {"low", 1280, 780, 1},
                                         {"medium", 1024, 700, 1},
                                         {"strip", 720, 450, 2},
                                         {"least", 640, 400, 1}};

Catalog with_many_axes() {
  Catalog c = example_catalog(8);
  for (AxisInfo& a : c.axes) a.encoder = a.home_input = true;
  c.can.interpolates = true;
  c.queue_depth = 200;
  return c;
}

Catalog one_on_a_line(int id) {
  Catalog c = test::full_catalog();
  c.axes.resize(1);
  c.address = id;
  c.axes[0].name = c.id();
  c.move_list = {};
  c.actions.clear();
  return c;
}

class FixedStage {
 public:
  FixedStage(const FixedWindow& window, int devices, const std::function<Catalog()>& catalog, bool dark)
      : s(window.width, window.height, window.scale, dark) {
    for (int i = 0; i < devices; ++i) {
      Catalog c = catalog();
      if (devices > 1) c = one_on_a_line(i + 1);
      c.units = example_catalog().units;
      if (c.params.empty()) c.params.emplace_back();
      at_first.push_back(s.add(std::move(c), &language).now);
    }
    if (devices > 1) {
      std::vector<Tab*> tabs;
      for (Example& e : s.examples) tabs.push_back(e.tab);
      s.console.join(std::move(tabs), "Line");
    }
    for (std::size_t i = 0; i < s.examples.size(); ++i) {
      Snapshot& now = s.examples[i].now;
      for (AxisState& a : now.axes) a.has_encoder = true;
      now.readouts_known.set();
      at_first[i] = now;
    }
    s.console.activate(*s.examples.front().tab);
    s.run(0.2);
  }
  Example& front() { return s.examples.front(); }
  std::vector<std::string> panels() {
    std::vector<std::string> ids;
    for (const Widget& w : s.stage.surface.screen().registry().widgets())
      if (w.id.starts_with("tab/")) ids.emplace_back(w.id.substr(4));
    return ids;
  }
  std::map<std::string, Rect> places() {
    std::map<std::string, Rect> all;
    int step = 0;
    for (const Widget& w : s.stage.surface.screen().registry().widgets()) {
      const bool is_step = w.id.starts_with("jog/step/");
      if (w.id.ends_with("/nearest")) continue;  // lies on a card of its own
      const std::string of_thread = first_of_thread(w.id);
      if (!of_thread.empty())
        all[of_thread] = w.rect;
      else if (w.moving || w.stops || is_step || w.id == "jog/speed")
        all[is_step ? fmt::format("jog/step {}", step++) : std::string(w.id)] = w.rect;
    }
    return all;
  }
  /// Run, Pause and Resume of a thread take turns in one place, which is as fixed as all others.
  static std::string first_of_thread(std::string_view id) {
    if (!id.starts_with("thread/")) return {};
    const std::string_view what = id.substr(id.rfind('/') + 1);
    const bool first = what == "run" || what == "pause" || what == "continue";
    return first ? std::string(id.substr(0, id.rfind('/'))) + ", first" : std::string();
  }
  std::map<std::string, Rect> places_in(const std::string& panel) {
    front().tab->panels.in_front = panel;
    s.stage.frames(3);
    return places();
  }
  /// The frames that draw it are those of what is said next.
  void as_at_first() {
    for (std::size_t i = 0; i < s.examples.size(); ++i) {
      Example& e = s.examples[i];
      e.now = at_first[i];
      e.bench.present = true;
      e.tab->settings.profile = Profile();
      e.tab->settings.edited();
      write(e, "");
    }
    s.stale = false;
  }
  static void write(Example& e, const char* text) {
    Desk& desk = e.tab->desk();
    const auto send = [&e](IntentBody body) { return e.tab->send(std::move(body)); };
    if (desk.programs.job.stage() == ProgramJob::Stage::asking)
      desk.programs.job.answer(ProgramJob::Answer::leave, desk.programs.texts, send);
    desk.programs.texts.set_text(desk.programs.texts.chosen(), text);
  }
  /// Run, where the controller holds another program.
  static void ask_before_a_run(Example& e) {
    Desk& desk = e.tab->desk();
    const int slot = desk.programs.texts.chosen();
    write(e, "I1M400");
    e.now.slot_bytes_used[static_cast<std::size_t>(slot)] = 12;
    desk.programs.job.begin(ProgramJob::Goal::run, slot, desk.programs.texts, e.now, e.tab->catalog(),
                            [&e](IntentBody body) { return e.tab->send(std::move(body)); });
    desk.programs.texts.listed(slot, "L9\n", e.tab->clock());
    e.outcome(IntentState::done);
  }
  /// Into Go of the first axis, where that is on the screen.
  void go_to(const char* text) {
    const Path field("goto/{}", front().tab->catalog().axes[0].name);
    if (!s.stage.find(field)) return;
    EXPECT_TRUE(s.hand.type(field, text).has_value());
  }

  test::ToyLanguage language;
  ConsoleStage s;
  std::vector<Snapshot> at_first;
};

struct Change {
  const char* name;
  std::function<void(FixedStage&)> make;
  bool in_go = false;  ///< by typing there, for which a hand scrolls: what it has scrolled to is compared
};

void each_axis(FixedStage& f, const std::function<void(AxisState&)>& change) {
  for (Example& e : f.s.examples)
    for (AxisState& a : e.now.axes) change(a);
}
void in_unit(FixedStage& f, const char* choice, Steps position) {
  for (Example& e : f.s.examples) {
    e.tab->settings.profile.unit = "real";
    for (std::size_t i = 0; i < e.tab->catalog().axes.size(); ++i)
      e.tab->settings.profile.axes[i].unit_choice = choice;
    e.tab->settings.edited();
  }
  each_axis(f, [&](AxisState& a) { a.position = a.encoder = position; });
}
void all_move(FixedStage& f, Activity activity, int direction) {
  each_axis(f, [&](AxisState& a) {
    a.activity = activity, a.direction = static_cast<std::int8_t>(direction);
    a.speed = Pps(123456), a.phase = Phase::constant;
    a.has_target = true, a.target = Steps(-7654321);
  });
}
void link_is(FixedStage& f, LinkState state, bool all) {
  for (Example& e : f.s.examples) {
    if (!all && &e == &f.front()) continue;
    e.now.link.state = state;
    e.now.link.sentence = "The cable of /dev/ttyUSB0 was pulled. No command was repeated. " +
                          std::string("What was under way may have gone on. Check the cable.");
  }
}
void run_programs(FixedStage& f, RunState state) {
  for (Example& e : f.s.examples) {
    e.now.program = {.run = state, .owned = true, .slot = 0, .command = 3};
    for (ThreadState& t : e.now.threads) t = {state, true, 1234};
  }
}

const std::vector<Change>& all_changes() {
  static const std::vector<Change> change = {
      {"long digits",
       [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.position = Steps(-100'000); }); }},
      {"longest digits",
       [](FixedStage& f) {
         each_axis(f, [](AxisState& a) { a.position = a.encoder = Steps(-134'217'728); });
       }},
      {"one long, one short", [](FixedStage& f) { f.front().now.axes[0].position = Steps(-8'388'608); }},
      {"mm", [](FixedStage& f) { in_unit(f, "screw of 1 mm", Steps(1)); }},
      {"long mm", [](FixedStage& f) { in_unit(f, "screw of 1 mm", Steps(-134'217'728)); }},
      {"degrees", [](FixedStage& f) { in_unit(f, "table", Steps(-28'800)); }},
      {"moving", [](FixedStage& f) { all_move(f, Activity::moving, 1); }},
      {"jogging", [](FixedStage& f) { all_move(f, Activity::jogging, -1); }},
      {"homing", [](FixedStage& f) { all_move(f, Activity::homing, -1); }},
      {"stopping", [](FixedStage& f) { all_move(f, Activity::stopping, 1); }},
      {"unknown", [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.activity = Activity::unknown; }); }},
      {"on a limit",
       [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.limit_plus = a.limit_minus = true; }); }},
      {"in error",
       [](FixedStage& f) {
         each_axis(f, [](AxisState& a) {
           a.activity = Activity::error, a.error = AxisError::not_corrected, a.alarm = true;
         });
       }},
      {"off", [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.enabled = false; }); }},
      {"not known", [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.position_known = false; }); }},
      {"doubtful",
       [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.trust.doubt(Doubt::power_cut, {}); }); }},
      {"slipped", [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.slipped = true; }); }},
      {"no encoder", [](FixedStage& f) { each_axis(f, [](AxisState& a) { a.has_encoder = false; }); }},
      {"speeds differ",
       [](FixedStage& f) {
         f.front().now.axes[0].own_speed = Pps(123'456'789);
         f.front().now.axes[1].own_speed = Pps(3);
       }},
      {"a long speed",
       [](FixedStage& f) {
         gui::choose_jog(*f.front().tab, Steps(1), Pps(f.front().tab->catalog().jog_speed_max));
       }},
      {"lost", [](FixedStage& f) { link_is(f, LinkState::lost, true); }},
      {"another lost", [](FixedStage& f) { link_is(f, LinkState::lost, false); }},
      {"late", [](FixedStage& f) { link_is(f, LinkState::late, true); }},
      {"connecting", [](FixedStage& f) { link_is(f, LinkState::connecting, true); }},
      {"closed", [](FixedStage& f) { link_is(f, LinkState::closed, true); }},
      {"stale",
       [](FixedStage& f) {
         f.s.stale = true;
         f.s.run(2);
       }},
      {"a program runs", [](FixedStage& f) { run_programs(f, RunState::running); }},
      {"a program is held", [](FixedStage& f) { run_programs(f, RunState::held); }},
      {"a program waits", [](FixedStage& f) { run_programs(f, RunState::waiting); }},
      {"a program failed", [](FixedStage& f) { run_programs(f, RunState::error); }},
      {"a text with an error",
       [](FixedStage& f) {
         for (Example& e : f.s.examples) FixedStage::write(e, "BAD");
       }},
      {"a text that asks before it runs",
       [](FixedStage& f) {
         for (Example& e : f.s.examples) FixedStage::ask_before_a_run(e);
       }},
      {"a list is fed",
       [](FixedStage& f) { f.front().now.feed = {.running = true, .sent = 123, .total = 100'000}; }},
      {"nothing told",
       [](FixedStage& f) {
         f.front().now.readouts_known.reset();
         f.front().now.outputs_known = f.front().now.inputs_known = f.front().now.analog_known = 0;
       }},
      {"long values",
       [](FixedStage& f) {
         for (auto& r : f.front().now.readouts) r = -1'234'567'890'123;
         f.front().now.queue_known = 0xFF;
       }},
      {"not set up",
       [](FixedStage& f) {
         for (auto& p : f.front().now.params) p = {0, true, false};
         f.front().now.unsaved_setup = true;
       }},
      {"a notice",
       [](FixedStage& f) {
         f.front().now.notice =
             "The driver says something long that is true as long as it is, and it is long.";
       }},
      {"no emulator", [](FixedStage& f) { f.front().bench.present = false; }},
      {"a long name",
       [](FixedStage& f) {
         for (auto& a : f.front().tab->settings.profile.axes)
           a.name = "the long slide behind the second table";
         f.front().tab->settings.profile.name = "The stage beside the window";
         f.front().tab->settings.edited();
       }},
      {"a target out of range", [](FixedStage& f) { f.go_to("99999999999\n"); }, true},
      {"no number", [](FixedStage& f) { f.go_to("here\n"); }, true},
      {"a refusal",
       [](FixedStage& f) {
         f.go_to("100\n");
         f.front().outcome(IntentState::refused,
                           "The axis stands on its limit switch, and the move leads further onto it. "
                           "Nothing was sent. Move it off the switch first, in the other direction.");
       },
       true},
      {"typed", [](FixedStage& f) { f.go_to("-123456.789"); }, true},
  };
  return change;
}

void expect_same(const std::map<std::string, Rect>& was, const std::map<std::string, Rect>& is,
                 const std::string& where) {
  for (const auto& [id, rect] : was) {
    const auto found = is.find(id);
    if (found == is.end()) {
      ADD_FAILURE() << where << ": " << id << " is gone";
      continue;
    }
    const Rect& r = found->second;
    const bool same =
        r.min.x == rect.min.x && r.min.y == rect.min.y && r.max.x == rect.max.x && r.max.y == rect.max.y;
    if (same) continue;
    ADD_FAILURE() << where << ": " << id << " was at " << rect.min.x << ", " << rect.min.y << " to "
                  << rect.max.x << ", " << rect.max.y << ", is at " << r.min.x << ", " << r.min.y << " to "
                  << r.max.x << ", " << r.max.y;
    return;  // what else has moved with it says no more
  }
}

class FixedLayout : public testing::TestWithParam<FixedWindow> {
 protected:
  void expect_fixed(const char* what, int devices, const std::function<Catalog()>& catalog,
                    bool dark = true) {
    FixedStage f(GetParam(), devices, catalog, dark);
    for (const std::string& panel : f.panels()) {
      f.as_at_first();
      const auto was = f.places_in(panel);
      ASSERT_FALSE(was.empty());
      for (const Change& change : all_changes()) {
        if (change.in_go) {
          f.s.stage.frames(3);
          f.go_to("");
        }
        const auto before = change.in_go ? f.places() : was;
        change.make(f);
        f.s.stage.frames(3);
        expect_same(before, f.places(), fmt::format("{}, {}, {}", what, panel, change.name));
        if (change.in_go) f.go_to("");
        f.as_at_first();
      }
    }
  }
};

INSTANTIATE_TEST_SUITE_P(All, FixedLayout, testing::ValuesIn(fixed_windows),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(FixedLayout, OneAxis) {
  expect_fixed("1", 1, [] { return example_catalog(1); });
}
TEST_P(FixedLayout, TwoAxes) {
  expect_fixed("2", 1, [] { return example_catalog(2); });
}
TEST_P(FixedLayout, TwoAxesInTheLightTheme) {
  expect_fixed(
      "2", 1, [] { return example_catalog(2); }, false);
}
TEST_P(FixedLayout, ThreeAxes) {
  expect_fixed("3", 1, [] { return example_catalog(3); });
}
TEST_P(FixedLayout, FourAxes) {
  expect_fixed("4", 1, [] { return example_catalog(4); });
}
TEST_P(FixedLayout, FourAxesWithEverything) { expect_fixed("4, full", 1, test::full_catalog); }
TEST_P(FixedLayout, ServoAxes) { expect_fixed("board", 1, test::window_catalog); }
TEST_P(FixedLayout, EightAxes) { expect_fixed("8", 1, with_many_axes); }
TEST(LowestWindow, ShowsJogGoAndHomeOfEightAxesWithoutScrolling) {
  ConsoleStage s(1024, 700);
  s.add(with_many_axes());
  s.run(0.2);
  for (const char* id : {"jog/stop", "jog/speed", "goto/1", "goto/1/go", "home/1/-", "home/1/+"}) {
    const Widget* w = s.stage.find(id);
    ASSERT_TRUE(w) << id;
    EXPECT_TRUE(w->wholly_in_view()) << id;
    EXPECT_GE(w->rect.height(), 28) << id;
  }
}

TEST_P(FixedLayout, ALineOfOne) {
  expect_fixed("line of 1", 1, [] { return one_on_a_line(1); });
}
TEST_P(FixedLayout, ALineOfFour) { expect_fixed("line of 4", 4, test::full_catalog); }

}  // namespace
}  // namespace hw::panels
