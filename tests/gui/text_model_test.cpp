#include "gui/widgets/text_model.h"

#include <random>

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

using Step = TextModel::Step;

TextModel model(std::string_view text) {
  TextModel m;
  m.set_text(text);
  return m;
}

TEST(TextModel, HoldsWhatItWasGiven) {
  for (const char* text : {"", "a", "a\n", "\n", "a\nb\n\nc", "\n\n"}) EXPECT_EQ(model(text).text(), text);
  EXPECT_EQ(model("a\r\nb\rc").text(), "a\nb\nc") << "lines of other systems";
}

TEST(TextModel, TypingAndUndoByTheWordTyped) {
  TextModel m;
  for (char c : std::string("I1M400")) m.insert({&c, 1});
  m.insert("\n");
  for (char c : std::string("R")) m.insert({&c, 1});
  EXPECT_EQ(m.text(), "I1M400\nR");
  EXPECT_TRUE(m.undo());
  EXPECT_EQ(m.text(), "I1M400\n");
  EXPECT_TRUE(m.undo());
  EXPECT_TRUE(m.undo());
  EXPECT_EQ(m.text(), "");
  EXPECT_FALSE(m.undo());
  EXPECT_TRUE(m.redo());
  EXPECT_EQ(m.text(), "I1M400");
  m.insert("x");
  EXPECT_FALSE(m.redo()) << "a change ends the way forward";
}

TEST(TextModel, ACaretMoveEndsATypedWord) {
  TextModel m;
  m.insert("a");
  m.left(Step::character, false);
  m.right(Step::character, false);
  m.insert("b");
  m.undo();
  EXPECT_EQ(m.text(), "a");
}

TEST(TextModel, SelectionIsReplaced) {
  TextModel m = model("one\ntwo\nthree");
  m.move_to({0, 1}, false);
  m.move_to({2, 2}, true);
  EXPECT_EQ(m.selected(), "ne\ntwo\nth");
  m.insert("-");
  EXPECT_EQ(m.text(), "o-ree");
  EXPECT_EQ(m.caret(), (TextPlace{0, 2}));
  m.undo();
  EXPECT_EQ(m.text(), "one\ntwo\nthree");
  EXPECT_EQ(m.selected(), "ne\ntwo\nth");
}

TEST(TextModel, PlacesStandBetweenCharacters) {
  TextModel m = model("10 \xC2\xB5s");
  EXPECT_EQ(m.clamp({0, 4}), (TextPlace{0, 3}));
  m.move_to({0, 3}, false);
  m.right(Step::character, false);
  EXPECT_EQ(m.caret(), (TextPlace{0, 5}));
  EXPECT_EQ(m.column(m.caret()), 4);
  EXPECT_EQ(m.at_column(0, 4), (TextPlace{0, 5}));
  m.backspace(false);
  EXPECT_EQ(m.text(), "10 s");
}

TEST(TextModel, UpAndDownKeepTheColumn) {
  TextModel m = model("long line\nx\nlong again");
  m.move_to({0, 7}, false);
  m.down(1, false);
  EXPECT_EQ(m.caret(), (TextPlace{1, 1}));
  m.down(1, false);
  EXPECT_EQ(m.caret(), (TextPlace{2, 7}));
  m.down(1, false);
  EXPECT_EQ(m.caret(), m.end());
  m.down(-9, true);
  EXPECT_EQ(m.selection().begin, (TextPlace{0, 0}));
}

TEST(TextModel, Words) {
  TextModel m = model("S1M2000, A1M2");
  m.right(Step::word, false);
  EXPECT_EQ(m.caret().byte, 9);
  m.left(Step::word, false);
  EXPECT_EQ(m.caret().byte, 0);
  m.move_to({0, 10}, false);
  m.select_word();
  EXPECT_EQ(m.selected(), "A1M2");
  m.backspace(true);
  EXPECT_EQ(m.text(), "S1M2000, ");
  m.move_to({0, 0}, false);
  m.erase(true);
  EXPECT_EQ(m.text(), "");
}

TEST(TextModel, HomeGoesToTheFirstLetterThenToTheMargin) {
  TextModel m = model("  code");
  m.right(Step::line_end, false);
  m.left(Step::line_end, false);
  EXPECT_EQ(m.caret().byte, 2);
  m.left(Step::line_end, false);
  EXPECT_EQ(m.caret().byte, 0);
}

TEST(TextModel, CommentsComeAndGo) {
  TextModel m = model("I1M400\n\nR\nlast");
  m.move_to({0, 3}, false);
  m.move_to({3, 0}, true);
  m.toggle_comment("; ");
  EXPECT_EQ(m.text(), "; I1M400\n\n; R\nlast");
  m.toggle_comment("; ");
  EXPECT_EQ(m.text(), "I1M400\n\nR\nlast");
  m.undo();
  EXPECT_EQ(m.text(), "; I1M400\n\n; R\nlast") << "one step";
  TextModel tight = model(";x");
  tight.toggle_comment("; ");
  EXPECT_EQ(tight.text(), "x") << "without the space too";
}

TEST(TextModel, LinesMoveRightAndBack) {
  TextModel m = model("FOR\n\n I1M400\nlast");
  m.move_to({0, 1}, false);
  m.move_to({3, 0}, true);
  m.indent(1);
  EXPECT_EQ(m.text(), "  FOR\n\n   I1M400\nlast");
  EXPECT_EQ(m.selected(), "OR\n\n   I1M400\n") << "chosen is what was, and can be moved on";
  m.indent(-1);
  m.indent(-1);
  EXPECT_EQ(m.text(), "FOR\n\nI1M400\nlast") << "as far as there is room";
  m.undo();
  m.undo();
  EXPECT_EQ(m.text(), "  FOR\n\n   I1M400\nlast") << "each is one step";
  TextModel one = model("\tR");
  one.move_to({0, 2}, false);
  one.indent(-1);
  EXPECT_EQ(one.text(), "R");
  EXPECT_EQ(one.caret(), (TextPlace{0, 1}));
  TextModel empty = model("");
  empty.indent(1);
  empty.insert("R");
  EXPECT_EQ(empty.text(), "  R");
}

TEST(TextModel, FindGoesRound) {
  const TextModel m = model("abc\nxABCx\nabc");
  auto hit = m.find("abc", {0, 1}, true);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->begin, (TextPlace{1, 1})) << "either case";
  hit = m.find("abc", {2, 1}, true);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->begin, (TextPlace{0, 0}));
  hit = m.find("abc", {0, 0}, false);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->begin, (TextPlace{2, 0}));
  EXPECT_FALSE(m.find("zzz", {0, 0}, true));
  EXPECT_FALSE(m.find("", {0, 0}, true));
}

TEST(TextModel, ReplaceIsOneStep) {
  TextModel m = model("S2M8000");
  m.replace({{0, 3}, {0, 7}}, "6000");
  EXPECT_EQ(m.text(), "S2M6000");
  m.undo();
  EXPECT_EQ(m.text(), "S2M8000");
}

// Whatever is done, undoing all of it brings the text back, and redoing all of it the result.
TEST(TextModel, UndoOfAnythingBringsTheTextBack) {
  std::mt19937 random(7);
  const char* pieces[] = {"x", "\n", "two\nlines", "\xC2\xB5", "    ", "I1M400"};
  for (int round = 0; round < 200; ++round) {
    TextModel m = model("one\ntwo; three\n\nfour");
    const std::string before = m.text();
    const auto any = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int i = 0; i < 20; ++i) {
      m.move_to({any(6), any(12)}, any(3) == 0);
      switch (any(5)) {
        case 0: m.backspace(any(2)); break;
        case 1: m.erase(any(2)); break;
        case 2: m.toggle_comment("; "); break;
        default: m.insert(pieces[any(6)]); break;
      }
    }
    const std::string after = m.text();
    while (m.undo()) {
    }
    EXPECT_EQ(m.text(), before);
    while (m.redo()) {
    }
    EXPECT_EQ(m.text(), after);
  }
}

}  // namespace
}  // namespace hw::gui
