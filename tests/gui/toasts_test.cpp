// Toasts: how long they stay, and where they lie.
#include "gui/model/toasts.h"

#include <gtest/gtest.h>

#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

TEST(ToastList, WhatTheySpokeOfHasChanged) {
  Toasts toasts;
  const int text = 0, other = 0;
  toasts.add(Mood::fault, "Line 2: A number is missing here.", &text);
  toasts.add(Mood::fault, "The disk is full.", &other);
  toasts.add(Mood::fault, "It moves.");
  toasts.withdraw(&text);
  ASSERT_EQ(toasts.list().size(), 2u);
  EXPECT_EQ(toasts.list()[0].text, "The disk is full.");
  EXPECT_EQ(toasts.list()[1].text, "It moves.");
}

TEST(ToastList, NameTheirControllerWhileAnotherIsInFront) {
  Toasts toasts;
  toasts.add(Mood::fault, "Line 2: no.", nullptr, "PMX");
  toasts.add(Mood::fault, "The disk is full.");
  const auto said = [&](std::optional<std::string_view> front) {
    toasts.look_at(front);
    return toasts.list()[0].said + " " + toasts.list()[1].said;
  };
  EXPECT_EQ(said("PMX"), "Line 2: no. The disk is full.");
  EXPECT_EQ(said("DMX"), "PMX: Line 2: no. The disk is full.");
  EXPECT_EQ(said(""), "PMX: Line 2: no. The disk is full.") << "a page of no controller";
  EXPECT_EQ(said("PMX"), "Line 2: no. The disk is full.");
  EXPECT_EQ(said(std::nullopt), "Line 2: no. The disk is full.") << "the only one";
}

/// A window with a wall of buttons that leaves `hole` free, over a status line.
struct ToastStage {
  static constexpr float status_height = 36;
  explicit ToastStage(Rect free) : hole(free), stage(in_window([this](Ui& ui) { draw(ui); }), 800, 600) {}

  void draw(Ui& ui) {
    const float bottom = ui.size_px.y - status_height;
    int n = 0;
    for (float y = 0; y + 30 <= bottom; y += 40)
      for (float x = 0; x + 70 <= ui.size_px.x; x += 80) {
        const bool in_hole = x + 70 > hole.min.x && x < hole.max.x && y + 30 > hole.min.y && y < hole.max.y;
        if (in_hole) continue;
        char id[16];
        std::snprintf(id, sizeof id, "b/%d", n++);
        ImGui::SetCursorScreenPos(ImVec2(x, y));
        button(ui, id, "Go", {.width = 70, .height = 30});
      }
    draw_toasts(ui, toasts, {ImVec2(0, 0), ImVec2(ui.size_px.x, bottom)}, {ImVec2(0, bottom), ui.size_px});
  }
  /// Buttons that a toast lies over.
  int covered(std::string_view id) {
    const Widget* toast = stage.find(id);
    int n = 0;
    for (const Widget& w : stage.surface.screen().registry().widgets())
      n += w.id.starts_with("b/") && toast && w.rect.min.x < toast->rect.max.x &&
           toast->rect.min.x < w.rect.max.x && w.rect.min.y < toast->rect.max.y &&
           toast->rect.min.y < w.rect.max.y;
    return n;
  }
  Rect hole;
  Toasts toasts;
  Stage stage;
};

TEST(ToastPlace, IsWhereNoControlIs) {
  ToastStage s({ImVec2(80, 200), ImVec2(560, 320)});
  s.toasts.add(Mood::fault, "The home switch is not there.");
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("toast/1"));
  EXPECT_EQ(s.covered("toast/1"), 0);
  const Rect first = s.stage.find("toast/1")->rect;
  EXPECT_LE(first.max.y, 320.0f);
  s.toasts.add(Mood::fault, "And that one neither.");
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("toast/2"));
  EXPECT_EQ(s.covered("toast/2"), 0);
  ASSERT_TRUE(s.stage.find("toast/1"));
  EXPECT_EQ(s.stage.find("toast/1")->rect.min.y, first.min.y) << "what lies somewhere stays there";
  EXPECT_LT(s.stage.find("toast/2")->rect.max.y, first.min.y);
}

TEST(ToastPlace, WithoutRoomIsTheStatusLine) {
  ToastStage s({ImVec2(-1, -1), ImVec2(-1, -1)});
  s.toasts.add(Mood::fault, "The home switch is not there.");
  s.toasts.add(Mood::fault, "And that one neither.");
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("toast/2")) << "the newest";
  EXPECT_GE(s.stage.find("toast/2")->rect.min.y, 600.0f - ToastStage::status_height);
  EXPECT_FALSE(s.stage.find("toast/1")) << "one at a time";
  ASSERT_TRUE(s.stage.hand.click("toast/2"));
  s.stage.frames(2);
  EXPECT_TRUE(s.stage.find("toast/1"));
}

}  // namespace
}  // namespace hw::gui
