// A sequence under a hand: each change does what it says and can be taken back.
#include "core/sequence/editor.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "core/sequence/sequence_file.h"
#include "core/sequence/steps_in.h"

namespace hw::sequence {
namespace {

Step delay(double ms) { return {Delay{ms}}; }
Step loop(StepList steps) {
  Repeat r;
  r.times = 3;
  r.steps = std::move(steps);
  return {std::move(r)};
}
std::string words(const StepList& steps) {
  std::string all;
  for (const Step& step : steps) {
    if (!all.empty()) all += " ";
    if (step.skipped) all += "-";
    if (const auto* d = std::get_if<Delay>(&step.body)) all += std::to_string(static_cast<int>(d->ms));
    if (const auto* r = std::get_if<Repeat>(&step.body)) all += "(" + words(r->steps) + ")";
  }
  return all;
}

void add_paths(const StepList& steps, StepPath& path, std::vector<StepPath>& all) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    path.push_back(i);
    all.push_back(path);
    if (const StepList* inner = steps_in(steps[i])) add_paths(*inner, path, all);
    path.pop_back();
  }
}

struct EditorTest : testing::Test {
  EditorTest() {
    Sequence s;
    s.axes = {{"X"}};
    s.steps = {delay(1), loop({delay(2), delay(3)}), delay(4)};
    editor.load(std::move(s));
  }
  std::string now() const { return words(editor.sequence().steps); }
  std::string after_undo() {
    editor.undo();
    return now();
  }
  Editor editor;
};

TEST_F(EditorTest, StepsComeAndGo) {
  EXPECT_EQ(editor.insert({0}, delay(9)), StepPath{0});
  EXPECT_EQ(now(), "9 1 (2 3) 4");
  EXPECT_EQ(editor.insert({2, 2}, delay(8)), (StepPath{2, 2}));
  EXPECT_EQ(now(), "9 1 (2 3 8) 4");
  EXPECT_EQ(editor.remove({2, 2}), (StepPath{2, 1})) << "the one before, where it was the last";
  EXPECT_EQ(editor.remove({0}), StepPath{0});
  EXPECT_EQ(now(), "1 (2 3) 4");
  EXPECT_FALSE(editor.insert({7}, delay(9)));
  EXPECT_FALSE(editor.insert({0, 0}, delay(9))) << "nothing stands within a delay";
  EXPECT_FALSE(editor.remove({3}));
  EXPECT_FALSE(editor.at({1, 2}));
  EXPECT_TRUE(editor.at({1, 1}));
}

TEST_F(EditorTest, AStepMovesInAndOutOfLoops) {
  EXPECT_EQ(editor.move({0}, {1, 1}), (StepPath{0, 1})) << "the loop has come nearer";
  EXPECT_EQ(now(), "(2 1 3) 4");
  EXPECT_EQ(editor.move({0, 1}, {2}), StepPath{2});
  EXPECT_EQ(now(), "(2 3) 4 1");
  EXPECT_EQ(editor.move({2}, {0}), StepPath{0});
  EXPECT_EQ(now(), "1 (2 3) 4");
  EXPECT_EQ(editor.move({0}, {3}), StepPath{2});
  EXPECT_EQ(now(), "(2 3) 4 1");
  EXPECT_FALSE(editor.move({0}, {0, 1})) << "not into itself";
  EXPECT_FALSE(editor.move({1}, {2})) << "it stands there";
  EXPECT_FALSE(editor.move({1}, {9}));
}

TEST_F(EditorTest, AllButTheStepsIsReplacedAsOneChange) {
  Sequence frame = frame_of(editor.sequence());
  frame.pen_down = {{Output{1, true}}};
  editor.replace_frame(frame);
  EXPECT_EQ(now(), "1 (2 3) 4");
  EXPECT_EQ(editor.sequence().pen_down.size(), 1u);
  const auto version = editor.version();
  editor.replace_frame(frame);
  EXPECT_EQ(editor.version(), version) << "no change";
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_TRUE(editor.sequence().pen_down.empty());
  editor.redo();
  EXPECT_EQ(editor.sequence().pen_down.size(), 1u);
}

TEST(SequenceEditor, OneThatPassesItsLikeStandsBehindIt) {
  Editor editor;
  Sequence s;
  s.steps = {{Delay{5}}, {Delay{5}}, {Delay{7}}};
  editor.load(s);
  EXPECT_EQ(editor.move({1}, {0}), StepPath{0});
  EXPECT_FALSE(editor.can_undo()) << "nothing has changed by it";
  EXPECT_FALSE(editor.move({1}, {1}));
}

TEST_F(EditorTest, LoopsAreMadeAndUnmade) {
  EXPECT_EQ(editor.put_into_loop({1, 0}), (StepPath{1, 0}));
  EXPECT_EQ(now(), "1 ((2) 3) 4");
  EXPECT_EQ(editor.take_out_of_loop({1}), StepPath{1});
  EXPECT_EQ(now(), "1 (2) 3 4");
  EXPECT_FALSE(editor.take_out_of_loop({0}));
  EXPECT_EQ(editor.duplicate({1}), StepPath{2});
  EXPECT_EQ(now(), "1 (2) (2) 3 4");
  EXPECT_EQ(editor.skip({2}, true), StepPath{2});
  EXPECT_EQ(now(), "1 (2) -(2) 3 4");
  EXPECT_FALSE(editor.skip({2}, true));
}

TEST_F(EditorTest, SeveralThatFollowEachOtherAreOneChange) {
  const StepSpan both(StepPath{0}, 2);
  EXPECT_EQ(editor.put_into_loop(both), StepPath{0});
  EXPECT_EQ(now(), "(1 (2 3)) 4");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_EQ(editor.duplicate(both), StepPath{2});
  EXPECT_EQ(now(), "1 (2 3) 1 (2 3) 4");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_EQ(editor.skip(both, true), StepPath{0});
  EXPECT_EQ(now(), "-1 -(2 3) 4");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_EQ(editor.move(both, {3}), StepPath{1});
  EXPECT_EQ(now(), "4 1 (2 3)");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_EQ(editor.move(StepSpan(StepPath{1, 0}, 2), {0}), StepPath{0});
  EXPECT_EQ(now(), "2 3 1 () 4");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_EQ(editor.remove(both), StepPath{0});
  EXPECT_EQ(now(), "4");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_FALSE(editor.move(both, {1, 1})) << "not into themselves";
  EXPECT_FALSE(editor.move(both, {1}));
  EXPECT_FALSE(editor.move(both, {2})) << "they stand there";
  EXPECT_FALSE(editor.remove(StepSpan(StepPath{2}, 2))) << "there is no second one";
}

TEST(StepSpanTest, ReachesFromOnePlaceToAnotherInTheListOfBoth) {
  const auto span = [](StepPath a, StepPath b) {
    const StepSpan s = span_between(a, b);
    return std::pair(s.first, s.count);
  };
  EXPECT_EQ(span({3}, {1}), std::pair(StepPath{1}, std::size_t{3}));
  EXPECT_EQ(span({2, 1}, {2, 1}), std::pair(StepPath({2, 1}), std::size_t{1}));
  EXPECT_EQ(span({2, 1}, {4}), std::pair(StepPath{2}, std::size_t{3}));
  EXPECT_EQ(span({2, 1}, {2, 3, 0}), std::pair(StepPath({2, 1}), std::size_t{3}));
  EXPECT_EQ(span({2}, {2, 3}), std::pair(StepPath{2}, std::size_t{1})) << "the one stands in the other";
}

TEST_F(EditorTest, EachChangeIsTakenBackAndMadeAgain) {
  editor.remove({0});
  editor.duplicate({0});
  EXPECT_EQ(now(), "(2 3) (2 3) 4");
  EXPECT_EQ(after_undo(), "(2 3) 4");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_FALSE(editor.can_undo());
  editor.redo(), editor.redo();
  EXPECT_EQ(now(), "(2 3) (2 3) 4");
  EXPECT_FALSE(editor.can_redo());
  editor.undo();
  editor.skip({0}, true);
  EXPECT_FALSE(editor.can_redo()) << "it goes on from there";
}

TEST_F(EditorTest, AWordThatIsTypedIsOneChange) {
  for (const double ms : {10.0, 100.0, 1000.0}) editor.replace({0}, Delay{ms});
  editor.replace({2}, Delay{7});
  EXPECT_EQ(now(), "1000 (2 3) 7");
  EXPECT_EQ(after_undo(), "1000 (2 3) 4");
  EXPECT_EQ(after_undo(), "1 (2 3) 4");
  EXPECT_FALSE(editor.can_undo());
  EXPECT_FALSE(editor.replace({0}, Delay{1})) << "nothing has changed";
}

// Its file could not be opened again.
TEST_F(EditorTest, LoopsStandNoDeeperThanAFileMayHold) {
  int loops = 0;
  while (editor.put_into_loop({0})) ++loops;
  EXPECT_EQ(loops, 7);
  const std::string before = now();
  EXPECT_FALSE(editor.put_into_loop({0}));
  EXPECT_EQ(now(), before);
  const auto read = read_sequence(write_sequence(editor.sequence()), "a.toml");
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_TRUE(*read == editor.sequence());
}

TEST_F(EditorTest, AnotherSequenceIsAChangeThatCanBeTakenBack) {
  editor.insert({0}, delay(1));
  const Sequence before = editor.sequence();
  const std::uint64_t loads = editor.loads();
  Sequence other;
  other.unit = "mm", other.axes = {{"X", 400}};
  other.steps = {delay(2), delay(3), delay(4)};
  editor.exchange(other);
  EXPECT_EQ(editor.sequence(), other);
  EXPECT_GT(editor.loads(), loads) << "places in the list do not hold any more";
  editor.undo();
  EXPECT_EQ(editor.sequence(), before);
  editor.redo();
  EXPECT_EQ(editor.sequence(), other);
}

// Whatever is done in whatever order: all of it can be taken back.
TEST_F(EditorTest, AnyOrderOfChangesCanBeTakenBack) {
  std::mt19937 random(7);
  const auto any = [&random](std::size_t below) { return random() % std::max<std::size_t>(below, 1); };
  for (int round = 0; round < 200; ++round) {
    std::vector<std::string> states{now()};
    for (int n = 0; n < 20; ++n) {
      std::vector<StepPath> rows;
      StepPath begin;
      add_paths(editor.sequence().steps, begin, rows);
      const StepPath at = rows.empty() ? StepPath{0} : rows[any(rows.size())];
      StepPath to = rows.empty() ? StepPath{0} : rows[any(rows.size())];
      if (any(2) == 1) ++to.back();
      const std::uint64_t before = editor.version();
      switch (any(7)) {
        case 0: editor.insert(to, delay(static_cast<double>(any(100)))); break;
        case 1: editor.remove(at); break;
        case 2: editor.move(at, to); break;
        case 3: editor.duplicate(at); break;
        case 4:
          if (rows.size() < 40) editor.put_into_loop(at);
          break;
        case 5: editor.take_out_of_loop(at); break;
        default: editor.skip(at, any(2) == 1); break;
      }
      if (editor.version() != before) states.push_back(now());
    }
    for (std::size_t n = states.size() - 1; n > 0; --n) {
      ASSERT_EQ(now(), states[n]);
      editor.undo();
    }
    ASSERT_EQ(now(), states[0]);
    if (round % 3 == 0) editor.redo();
  }
}

}  // namespace
}  // namespace hw::sequence
