// Messages: how long they stay, how they are counted, and the strip and the list that show them.
#include "gui/model/toasts.h"

#include <gmock/gmock.h>

#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

TEST(ToastList, MessagesGoWhenTheirSubjectChanges) {
  Toasts toasts;
  const int text = 0, other = 0;
  toasts.add(Severity::fault, "Line 2: A number is missing here.", &text);
  toasts.add(Severity::fault, "The disk is full.", &other);
  toasts.add(Severity::fault, "It moves.");
  toasts.withdraw(&text);
  ASSERT_EQ(toasts.list().size(), 2u);
  EXPECT_EQ(toasts.list()[0].text, "The disk is full.");
  EXPECT_EQ(toasts.list()[1].text, "It moves.");
}

TEST(ToastList, NameTheirControllerWhileAnotherIsInFront) {
  Toasts toasts;
  toasts.add(Severity::fault, "Line 2: no.", nullptr, "PMX");
  toasts.add(Severity::fault, "The disk is full.");
  const auto shown_text = [&](std::optional<std::string_view> front) {
    toasts.look_at(front);
    return toasts.list()[0].shown_text + " " + toasts.list()[1].shown_text;
  };
  EXPECT_EQ(shown_text("PMX"), "Line 2: no. The disk is full.");
  EXPECT_EQ(shown_text("DMX"), "PMX: Line 2: no. The disk is full.");
  EXPECT_EQ(shown_text(""), "PMX: Line 2: no. The disk is full.") << "a page of no controller";
  EXPECT_EQ(shown_text("PMX"), "Line 2: no. The disk is full.");
  EXPECT_EQ(shown_text(std::nullopt), "Line 2: no. The disk is full.") << "the only one";
}

TEST(ToastList, ARepeatedMessageIsCountedAndBecomesTheNewest) {
  Toasts toasts;
  toasts.add(Severity::warn, "It is hot.");
  toasts.add(Severity::ok, "It was copied.");
  toasts.tick(0);
  toasts.add(Severity::warn, "It is hot.");
  ASSERT_EQ(toasts.list().size(), 2u);
  EXPECT_EQ(toasts.list().back().text, "It is hot.");
  EXPECT_EQ(toasts.list().back().times, 2);
  EXPECT_EQ(toasts.list().back().number, 1) << "the same message";
  toasts.tick(5);
  toasts.tick(7);
  ASSERT_EQ(toasts.list().size(), 1u);
  EXPECT_EQ(toasts.list().back().text, "It is hot.") << "its time started anew";
}

TEST(ToastList, ATransientMessageMakesRoomForALastingOne) {
  Toasts toasts;
  toasts.add(Severity::fault, "The disk is full.");
  toasts.add(Severity::ok, "It was copied.");
  for (std::size_t i = 0; i + 1 < Toasts::at_most; ++i)
    toasts.add(Severity::fault, "No " + std::to_string(i));
  ASSERT_EQ(toasts.list().size(), Toasts::at_most);
  EXPECT_EQ(toasts.list().front().text, "The disk is full.");
}

TEST(ToastList, TextFromAFileIsCutAndMadeReadable) {
  Toasts toasts;
  toasts.add(Severity::fault, "a\x1b[31m\nb");
  EXPECT_EQ(toasts.list().back().text, "a [31m b");
  std::string degrees;
  while (degrees.size() < 10'000'000) degrees += "\xC2\xB0";
  toasts.add(Severity::fault, "x" + degrees);
  const std::string& text = toasts.list().back().text;
  EXPECT_LE(text.size(), Toasts::longest + 3);
  EXPECT_EQ(text.substr(text.size() - 5), "\xC2\xB0\xE2\x80\xA6") << "no half of a character";
}

TEST(ToastList, AReasonThatIsGoneTakesItsMessageWithIt) {
  Toasts toasts;
  const int stage = 0, table = 0;
  toasts.add(Severity::fault, "There is no link.", &stage);
  toasts.add(Severity::fault, "The disk is full.");
  const auto count = [&] { return toasts.list().size(); };
  toasts.look_at_controller(&stage, {.linked = false});
  toasts.look_at_controller(&table, {.linked = true, .moving = true});
  EXPECT_EQ(count(), 2u);
  toasts.look_at_controller(&stage, {.linked = true});
  EXPECT_EQ(count(), 1u) << "there is one again";
  toasts.add(Severity::fault, "The home switch is not there.", &stage);
  toasts.look_at_controller(&stage, {.linked = true});
  toasts.look_at_controller(&stage, {.linked = true});
  EXPECT_EQ(count(), 2u);
  toasts.look_at_controller(&stage, {.linked = true, .moving = true});
  EXPECT_EQ(count(), 1u) << "it moves: what was refused before is past";
  toasts.add(Severity::fault, "That while it moves.", &stage);
  toasts.look_at_controller(&stage, {.linked = true, .moving = true});
  toasts.look_at_controller(&stage, {.linked = true});
  EXPECT_EQ(count(), 2u) << "said while it moved";
}

/// A window with a strip for messages, `width` wide, in its title row or in its status line.
struct ToastStage {
  static constexpr float status_height = 36;
  explicit ToastStage(float wide, float top = 300)
      : stage(in_window([=, this](Ui& ui) { draw(ui, wide, top); }), 800, 600) {}

  void draw(Ui& ui, float wide, float top) {
    const float bottom = ui.size_px.y - status_height;
    draw_messages(ui, toasts, {ImVec2(780 - wide, top), ImVec2(780, top + 32)});
    ImGui::SetCursorScreenPos(ImVec2(0, 0));
    button(ui, "elsewhere", "Elsewhere");
    draw_toasts(ui, toasts, {ImVec2(0, 56), ImVec2(700, bottom)}, {ImVec2(0, bottom), ui.size_px});
  }
  std::string value(const char* id) {
    const Widget* w = stage.find(id);
    return w ? std::string(w->value) : "(absent)";
  }
  Toasts toasts;
  Stage stage;
};

TEST(MessageStrip, ShowsTheNewestAndHowManyWait) {
  ToastStage s(432);
  s.stage.frames(2);
  EXPECT_FALSE(s.stage.find("message/strip"));
  s.toasts.add(Severity::fault, "The home switch is not there.");
  s.stage.frames(3);
  EXPECT_EQ(s.value("toast/1"), "The home switch is not there.");
  EXPECT_FALSE(s.stage.find("message/more"));
  s.toasts.add(Severity::fault, "And that one neither.");
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("message/more"));
  EXPECT_EQ(s.stage.find("message/more")->label, "1 more");
  EXPECT_TRUE(s.stage.find("toast/2")->usable());
  EXPECT_EQ(s.value("toast/1"), "The home switch is not there.") << "it waits, and is there";
  ASSERT_TRUE(s.stage.hand.click("message/close/2"));
  s.stage.frames(3);
  EXPECT_FALSE(s.stage.find("toast/2"));
  EXPECT_TRUE(s.stage.find("toast/1")->usable());
  ASSERT_TRUE(s.stage.hand.click("message/close/1"));
  s.stage.frames(3);
  EXPECT_FALSE(s.stage.find("message/strip"));
}

TEST(MessageStrip, APressOpensTheListOfAllWithACrossEach) {
  ToastStage s(432);
  for (const char* words : {"One.", "Two.", "Three."}) s.toasts.add(Severity::fault, words);
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.hand.click("toast/3"));
  s.stage.frames(3);
  EXPECT_EQ(s.value("message/list/1"), "One.");
  EXPECT_EQ(s.value("message/list/3"), "Three.");
  const Rect first = s.stage.find("message/list/3")->rect, strip = s.stage.find("message/strip")->rect;
  EXPECT_GE(first.min.y, strip.max.y) << "under the strip";
  EXPECT_LE(first.max.x, 700.0f) << "in the part that it was given";
  ASSERT_TRUE(s.stage.hand.click("message/list/2/close"));
  s.stage.frames(3);
  EXPECT_FALSE(s.stage.find("message/list/2"));
  EXPECT_TRUE(s.stage.find("message/list/1")) << "the list stays open";
  ASSERT_TRUE(s.stage.hand.click("message/close_all"));
  s.stage.frames(3);
  EXPECT_TRUE(s.toasts.list().empty());
  EXPECT_TRUE(s.stage.hand.click("elsewhere")) << "nothing lies over the rest";
}

TEST(MessageStrip, LowInTheWindowTheListOpensUpwards) {
  ToastStage s(240, 566);
  s.toasts.add(Severity::fault, "One.");
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.hand.click("toast/1"));
  s.stage.frames(3);
  ASSERT_TRUE(s.stage.find("message/list/1"));
  EXPECT_LE(s.stage.find("message/list/1")->rect.max.y, 600.0f - ToastStage::status_height);
  ASSERT_TRUE(s.stage.hand.click("message/list/1/close"));
  s.stage.frames(3);
  EXPECT_FALSE(s.stage.find("message/list/1"));
}

TEST(MessageStrip, WithoutRoomItIsAMarkThatOpensTheList) {
  ToastStage s(52);
  s.toasts.add(Severity::fault, "One.");
  s.toasts.add(Severity::fault, "Two.");
  s.stage.frames(3);
  EXPECT_EQ(s.value("toast/2"), "Two.");
  EXPECT_EQ(s.value("toast/1"), "One.");
  ASSERT_TRUE(s.stage.hand.click("toast/2"));
  s.stage.frames(3);
  EXPECT_TRUE(s.stage.find("message/list/1"));
}

TEST(MessageStrip, AtRestItDrawsOneFrameAMinute) {
  ToastStage s(432);
  s.toasts.add(Severity::fault, "One.");
  s.stage.frames(5);
  EXPECT_GT(s.stage.surface.screen().wake_in_s(), 50);
}

}  // namespace
}  // namespace hw::gui
