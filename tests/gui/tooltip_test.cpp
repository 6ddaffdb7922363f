// Where tooltips stand: never over a refusal, a card or a Stop.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "gui/widgets/button.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/text.h"
#include "gui/widgets/touch.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

/// Of the frame that was drawn last; null: none is shown.
const ImGuiWindow* shown_tooltip() {
  for (const ImGuiWindow* w : GImGui->Windows)
    if ((w->Flags & ImGuiWindowFlags_Tooltip) && w->Active && !w->Hidden) return w;
  return nullptr;
}

bool is_covered(const Rect& r) {
  const ImGuiWindow* tip = shown_tooltip();
  return tip && tip->Rect().Overlaps(ImRect(r.min, r.max));
}

void point_at(Stage& stage, std::string_view id) {
  const ImVec2 at = stage.find(id)->rect.centre();
  stage.push(InputEvent::mouse_move(at.x, at.y, 0));
  stage.frames(4);
}

TEST(Tooltip, OfAFieldLeavesTheRefusalUnderItLegible) {
  constexpr std::string_view tip = "Speed of Go, in millimetres per second. Empty: as set in the controller.";
  Rect sentence{};
  for (const float y : {60.0f, 840.0f}) {  // and where tooltips stand above
    NumberField state;
    Stage stage(in_window([&](Ui& ui) {
      NumberOptions o{.tip = tip};
      o.width = 240;
      o.refused = "That is faster than the controller can go. It takes 1 to 6 000 000 in this unit.";
      ImGui::SetCursorScreenPos(ImVec2(100, y));
      (void)number_field(ui, "speed", "Speed", std::nullopt, state, o);
      sentence = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
      sentence.min.y += 32;  // below the field
    }));
    stage.frames(3);
    point_at(stage, "speed");
    ASSERT_TRUE(shown_tooltip()) << y;
    EXPECT_FALSE(is_covered(sentence)) << y;
  }
}

TEST(Tooltip, StandsOverNeitherCardNorStop) {
  const Rect card{ImVec2(100, 132), ImVec2(400, 232)}, stop{ImVec2(600, 132), ImVec2(800, 188)};
  Stage stage(in_window([&](Ui& ui) {
    show(ui, {.id = "card", .kind = Kind::text, .label = "A card", .card = true}, card);
    ImGui::SetCursorScreenPos(stop.min);
    (void)touch(ui, {.id = "stop", .kind = Kind::button, .label = "Stop", .stops = true}, ImVec2(200, 56));
    for (const float x : {100.0f, 600.0f}) {
      ImGui::SetCursorScreenPos(ImVec2(x, 100));
      (void)button(ui, x < 200 ? "a" : "b", "Go", {.tip = "What this does, in a whole sentence."});
    }
  }));
  stage.frames(3);
  point_at(stage, "a");
  ASSERT_TRUE(shown_tooltip());
  EXPECT_FALSE(is_covered(card));
  point_at(stage, "b");
  ASSERT_TRUE(shown_tooltip());
  EXPECT_FALSE(is_covered(stop));
}

TEST(Tooltip, MindsRefusalsAndNotTheColourOfAWord) {
  bool refused = false;
  Stage stage(in_window([&](Ui& ui) {
    draw_text_line(ui, 100, 300, 100, Face::body, ui[Tone::fault], "Stop");
    ImGui::SetCursorScreenPos(ImVec2(100, 200));
    if (refused) wrapped(ui, Face::body, Tone::fault, "That is past the + limit.", 200);
  }));
  stage.frames(2);
  EXPECT_TRUE(stage.surface.screen().registry().kept_clear().empty());
  refused = true;
  stage.frames(2);
  EXPECT_EQ(stage.surface.screen().registry().kept_clear().size(), 1u);
}

}  // namespace
}  // namespace hw::gui
