#pragma once
// The whole console without display, with controllers that are only a catalog and a snapshot: what goes in is
// what the test shows, what comes out is kept for it to look at.
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/time/virtual_scheduler.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"
#include "panels/panel_list.h"
#include "tests/gui/stage.h"

namespace hw::panels {

inline Catalog example_catalog(int axes = 2) {
  Catalog c;
  c.model = "example";
  c.name = "Example Controller";
  c.short_name = "Example";
  c.summary = "two axes";
  for (int i = 1; i <= axes; ++i) c.axes.push_back({std::to_string(i), "motor " + std::to_string(i)});
  c.units = {{"screw of 1 mm", "mm", 0.0025, 3}, {"table", "°", 0.0125, 2}};
  c.homing_modes = {{"limit", "to the limit switch"}, {"switch", "onto the home switch"}};
  for (int i = 1; i <= 4; ++i) c.inputs.push_back({"In " + std::to_string(i), "help", true});
  for (int i = 1; i <= 2; ++i) c.outputs.push_back({"Out " + std::to_string(i), "help", true});
  c.analog = {{"Analog", "counts", 0, 1024}};
  c.program.slots = 5;
  c.program.slot_word = "Program";
  c.program.capacity = 256;
  c.program.capacity_unit = "bytes";
  c.bench.panel_title = "Example front panel";
  c.bench.supplies = {{"", true}, {"Second", true}};
  c.bench.buttons = {{"1-", true, 0},
                     {"1+", true, 0},
                     {"Run", true, 1},
                     {"Stop", false, 1, 0, true},
                     {"Second Run", true, 0, 1}};
  c.bench.lamps = {
      {"Power", LampColour::green}, {"On-Line", LampColour::yellow}, {"Second Power", LampColour::green, 1}};
  c.can.store = true;
  c.can.reset = true;
  c.jog_speed = Pps(2000);
  c.position_min = Steps(-8'388'608);
  c.position_max = Steps(8'388'607);
  ParamInfo type;
  type.mnemonic = "type1";
  type.label = "Type of motor 1";
  type.explanation = "Which motor is connected.";
  type.group = "Motors";
  type.maximum = 6;
  type.axis = 0;
  type.before_moving = "No type is chosen for motor 1.";
  c.params.push_back(type);
  return c;
}

/// One controller of the stage.
struct Example {
  Snapshot now;
  BenchView bench;
  std::vector<IntentBody> sent;
  std::vector<BenchCommand> operated;
  gui::Tab* tab = nullptr;

  template <class T>
  [[nodiscard]] int count() const {
    int n = 0;
    for (const IntentBody& body : sent) n += std::holds_alternative<T>(body);
    return n;
  }
  template <class T>
  [[nodiscard]] const T* last() const {
    for (auto body = sent.rbegin(); body != sent.rend(); ++body)
      if (const T* found = std::get_if<T>(&*body)) return found;
    return nullptr;
  }
  template <class T>
  [[nodiscard]] const T* last_operated() const {
    return operated.empty() ? nullptr : std::get_if<T>(&operated.back());
  }
  /// What became of the newest intent.
  void outcome(IntentState what, const char* sentence = "", std::uint32_t doubtful = 0) {
    now.outcomes[0].id = sent.size();
    now.outcomes[0].state = what;
    now.outcomes[0].sentence = sentence;
    now.outcomes[0].doubtful = doubtful;
  }
};

class ConsoleStage {
 public:
  IoContext io;
  VirtualScheduler scheduler{io};
  gui::Console console;
  std::deque<Example> examples;
  gui::Stage stage;
  gui::Automation& hand;

  explicit ConsoleStage(int width = 1440, int height = 900, float scale = 1, bool dark = true,
                        const UserFolders& folders = UserFolders::none())
      : console(panel_list(), outside(scheduler, folders)),
        stage([this](gui::Ui& ui) { draw(ui); }, width, height, scale, dark),
        hand(stage.hand) {
    console.attach(stage.surface.screen().keyboard());
  }
  ~ConsoleStage() {
    while (!console.tabs().empty()) console.close(*console.tabs().back());
  }

  Example& add(Catalog catalog = example_catalog(), const Language* language = nullptr) {
    Example& e = examples.emplace_back();
    const std::size_t axes = catalog.axes.size();
    Address address;
    address.model = catalog.model;
    address.transport = "emulator";
    auto tab = std::make_unique<gui::Tab>(
        std::move(address), std::move(catalog),
        gui::Tab::Backend{[&e](IntentBody body, std::optional<double>) {
                            e.sent.push_back(std::move(body));
                            return static_cast<IntentId>(e.sent.size());
                          },
                          [&e](BenchCommand command) { e.operated.push_back(command); }},
        language);
    e.tab = &console.add(std::move(tab));
    e.now.link.state = LinkState::good;
    e.now.link.round_trip = Millis(23);
    e.now.link.polls_per_second = 43;
    e.now.poll_period = Millis(200);
    e.now.axis_count = static_cast<int>(axes);
    for (AxisState& a : e.now.axes) {
      a.activity = Activity::idle;
      a.position_known = a.limits_known = true;
      a.own_speed = Pps(2000);
    }
    e.now.inputs = e.now.inputs_known = 0xF;
    e.now.outputs_known = 3;
    e.now.analog_known = 1;
    e.now.analog[0] = 512;
    e.now.params[0] = {3, true, true};
    e.bench.present = true;
    e.bench.lamps = 3;
    return e;
  }
  /// Time goes on, frames are drawn; what is shown is fresh unless `stale`.
  void run(double seconds) {
    for (int n = static_cast<int>(seconds * 60 + 0.5); n > 0; --n) stage.frame();
  }
  bool stale = false;
  std::string value(std::string_view id) { return hand.value(id).value_or("(none)"); }

 private:
  static gui::Outside outside(Scheduler& scheduler, const UserFolders& folders) {
    gui::Outside o(scheduler, WireOpener(), [] {});
    o.folders = folders;
    return o;
  }
  void draw(gui::Ui& ui) {
    scheduler.run_until(Instant(from_seconds(stage.now_s)));
    for (Example& e : examples) {
      if (!e.tab) continue;
      const bool open = std::any_of(console.tabs().begin(), console.tabs().end(),
                                    [&](const auto& t) { return t.get() == e.tab; });
      if (!open) continue;
      e.now.at = scheduler.now();
      if (!stale) {
        e.now.io_seen_at = scheduler.now();
        for (AxisState& a : e.now.axes) a.seen_at = scheduler.now();
      }
      e.tab->show(e.now, e.bench, scheduler.now());
    }
    console.draw(ui);
  }
};

}  // namespace hw::panels
