#pragma once
// One panel in a window of its own, with a snapshot that the test writes and intents that it reads.
#include <memory>
#include <vector>

#include <gmock/gmock.h>

#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/shell/frame.h"
#include "tests/gui/model/toy_language.h"
#include "tests/gui/stage.h"

namespace hw::test {

/// A console without controllers, with a scheduler of its own.
class EmptyConsole {
 public:
  EmptyConsole();
  ~EmptyConsole();
  gui::Console& operator*();

 private:
  struct World;
  std::unique_ptr<World> world_;
};

struct PanelStage {
  explicit PanelStage(gui::Panel& p, int width = 864, int height = 700, float scale = 1,
                      gui::Tier t = gui::Tier::wide, bool dark = true, Catalog of = toy_catalog(),
                      const Language* understood = nullptr, gui::TrafficLog::Explain explain = nullptr)
      : panel(p),
        tier(t),
        catalog(std::move(of)),
        tab(toy_address(), catalog,
            gui::Tab::Backend{[this](IntentBody body, std::optional<double>) {
                                sent.push_back(std::move(body));
                                return static_cast<IntentId>(sent.size());
                              },
                              [](BenchCommand) {}},
            understood ? understood : &language, explain),
        stage([this](gui::Ui& ui) { draw(ui); }, width, height, scale, dark) {
    now.link.state = LinkState::good;
    now.axis_count = 2;
    for (std::size_t i = 0; i < catalog.params.size(); ++i) {
      now.params[i].known = catalog.params[i].readable;
      now.params[i].value = catalog.params[i].fallback;
    }
  }

  void draw(gui::Ui& ui) {
    tab.show(now, bench, Instant(from_seconds(stage.now_s)));
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ui.size_px);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    const gui::Box area{0, 0, ui.size_px.x / ui.scale, ui.size_px.y / ui.scale};
    gui::Frame frame{
        {ui, console, area, tier, false, tab.clock()}, tab, tab.catalog(), tab.now(), tab.bench()};
    panel.draw(frame);
    ImGui::End();
  }
  /// What became of the newest intent.
  void settle(IntentState outcome, const char* sentence = "", std::optional<PastTravel> past = {}) {
    IntentOutcome f;
    f.id = sent.size(), f.state = outcome, f.sentence = sentence, f.past = past;
    for (std::size_t i = now.outcomes.size() - 1; i > 0; --i) now.outcomes[i] = now.outcomes[i - 1];
    now.outcomes[0] = f;
    stage.frames(2);
  }
  template <class T>
  const T* last() const {
    return sent.empty() ? nullptr : std::get_if<T>(&sent.back());
  }
  void click(const char* id) {
    const auto done = stage.hand.click(id);
    EXPECT_TRUE(done) << id << ": " << done.error().sentence();
    stage.frames(2);
  }
  /// With the mouse, wherever that is.
  void click_at(ImVec2 p) {
    stage.push(gui::InputEvent::mouse_move(p.x, p.y, stage.now_s));
    stage.frames(1);
    stage.push(gui::InputEvent::mouse_button(0, true, p, stage.now_s));
    stage.frames(1);
    stage.push(gui::InputEvent::mouse_button(0, false, p, stage.now_s));
    stage.frames(2);
  }
  void type(const char* id, const char* text) {
    const auto done = stage.hand.type(id, text);
    EXPECT_TRUE(done) << id << ": " << done.error().sentence();
    stage.frames(2);
  }
  std::string value(const char* id) {
    auto v = stage.hand.value(id);
    return v ? *v : "(" + v.error().sentence() + ")";
  }
  std::string reason(const char* id) {
    const gui::Widget* w = stage.find(id);
    return w ? std::string(w->reason) : "(absent)";
  }
  /// The newest toast.
  std::string toast() {
    const auto& list = console.toasts().list();
    return list.empty() ? "" : list.back().text;
  }

  gui::Panel& panel;
  gui::Tier tier;
  EmptyConsole world;
  gui::Console& console = *world;
  ToyLanguage language;
  Catalog catalog;
  std::vector<IntentBody> sent;
  Snapshot now;
  BenchView bench;
  gui::Tab tab;
  gui::Stage stage;
};

}  // namespace hw::test
