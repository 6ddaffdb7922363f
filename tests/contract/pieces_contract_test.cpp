// A sequence of any length, in pieces that fit into each listed controller: all of it is done, what ends one
// piece ends all, and it goes on from where it was stopped.
#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/language.h"
#include "core/device/pieces.h"
#include "tests/contract/truth.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too
using std::chrono::seconds;
using testing::HasSubstr;

class PiecesContractTest : public TruthTest {
 protected:
  void SetUp() override {
    TruthTest::SetUp();
    output_ = free_output(session->catalog());
    if (output_ < 0) GTEST_SKIP() << "it has no output for a tool";
    s_.axes = {{session->catalog().axes[0].name, 1}};
    s_.pen_up = {{seq::Output{output_, false}}};
    s_.pen_down = {{seq::Output{output_, true}}};
    s_.steps = {{seq::Pen{false}}, {seq::Speed{{4000, 0, 50}}}};
  }
  /// Each goes `points` times 20 steps on, with the tool.
  void add_chains(int chains, int points) {
    for (int c = 0; c < chains; ++c) {
      at_ += 100;
      add_way(at_);
      s_.steps.push_back({seq::Pen{true}});
      for (int p = 0; p < points; ++p) add_way(at_ += 20);
      s_.steps.push_back({seq::WaitMotion{}});
      s_.steps.push_back({seq::Pen{false}});
    }
  }
  void add_way(int to) {
    seq::Move m;
    m.to[0] = to;
    s_.steps.push_back({m});
    s_.steps.push_back({seq::WaitMotion{}});
  }
  std::shared_ptr<const Pieces> cut(int from_step = 0) {
    auto pieces = GetParam()->language().in_pieces(s_, session->catalog(), from_step);
    EXPECT_TRUE(pieces) << pieces.error().sentence();
    return pieces ? std::make_shared<Pieces>(std::move(*pieces)) : nullptr;
  }
  bool cut_from_nowhere() {
    const int behind = static_cast<int>(s_.steps.size());
    return GetParam()->language().in_pieces(s_, session->catalog(), behind).has_value();
  }
  /// More than fits, where memory is short.
  std::shared_ptr<const Pieces> long_one() {
    add_chains(12, session->catalog().program.capacity > 1000 ? 100 : 8);
    return cut();
  }
  [[nodiscard]] bool is_on() const {
    return (seen_on_bench().outputs >> session->catalog().find_output(output_) & 1u) != 0;
  }
  bool ends(Duration patience = seconds(600)) {
    return run_until([this] { return !now().pieces.running && !now().any_axis_moving(); }, patience);
  }
  [[nodiscard]] std::string reported() {
    std::string all;
    session->notices().drain([&](const Notice& n) { all += n.text + "\n"; });
    return all;
  }

  seq::Sequence s_;
  static constexpr int longest_chain = 100 * 20 + 100;
  int at_ = 0, output_ = -1;
};
INSTANTIATE_TEST_SUITE_P(Every, PiecesContractTest, testing::ValuesIn(types_with_a_language()), name_of_type);

TEST_P(PiecesContractTest, EachPieceFitsAndBeginsWhereTheOneBeforeEnds) {
  const auto pieces = long_one();
  ASSERT_TRUE(pieces);
  const int capacity = session->catalog().program.capacity;
  EXPECT_GT(pieces->all.size(), 1u);
  EXPECT_EQ(pieces->lifts, 0) << "each chain fits";
  int step = -1;
  for (const Piece& piece : pieces->all) {
    EXPECT_GT(piece.first_step, step);
    step = piece.first_step;
    const auto* load = std::get_if<intent::LoadProgram>(&*piece.does.front().what);
    if (!load) continue;  // moves, one by one
    const std::string& text = load->text;
    const ProgramReport report = GetParam()->language().analyse(text, 0);
    EXPECT_FALSE(report.has_errors()) << text;
    for (const auto& [slot, cost] : report.cost) EXPECT_TRUE(capacity == 0 || cost <= capacity) << cost;
  }
}

TEST_P(PiecesContractTest, AllOfItIsDoneWithTheToolOffInBetween) {
  const auto pieces = long_one();
  must(intent::RunInPieces(pieces));
  int seen_on = 0;
  bool was_on = is_on();
  ASSERT_TRUE(run_until(
      [&] {
        seen_on += is_on() && !was_on;
        was_on = is_on();
        return !now().pieces.running;
      },
      seconds(900)));
  EXPECT_EQ(seen_on, 12);
  EXPECT_FALSE(is_on());
  EXPECT_EQ(axis().position, Steps(at_));
  EXPECT_EQ(now().pieces.done, now().pieces.total);
  const std::string sentence = reported();
  EXPECT_EQ(sentence.find("iece"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("tool"), std::string::npos) << sentence;
}

TEST_P(PiecesContractTest, AStopEndsAllAndItGoesOnFromAPiece) {
  const auto pieces = long_one();
  must(intent::RunInPieces(pieces));
  const int into = std::min<int>(1, static_cast<int>(pieces->all.size()) - 1);
  ASSERT_TRUE(run_until([&] { return now().pieces.done == into && is_on(); }, seconds(600)));
  session->send(intent::Stop());
  ASSERT_TRUE(ends());
  run(seconds(3));
  EXPECT_FALSE(is_on());
  const Steps there = axis().position;
  run(seconds(20));
  EXPECT_EQ(axis().position, there) << "nothing follows a stop";
  EXPECT_LT(there, Steps(at_));
  const auto rest = cut(now().pieces.step);
  ASSERT_TRUE(rest);
  EXPECT_LE(rest->all.size(), pieces->all.size());
  must(intent::RunInPieces(rest));
  bool backwards = false;
  ASSERT_TRUE(run_until(
      [&] {
        if (!is_on()) return !now().pieces.running && !now().any_axis_moving();
        backwards = backwards || axis().position < there - Steps(longest_chain);
        return false;
      },
      seconds(900)));
  EXPECT_FALSE(backwards) << "chains that were whole are not drawn again";
  EXPECT_EQ(axis().position, Steps(at_));
  EXPECT_EQ(now().pieces.done, now().pieces.total);
}

TEST_P(PiecesContractTest, TheRestOfADrawingSurvivesTheRunOfAFrame) {
  auto drawing = *long_one();
  drawing.drawing = 7;
  must(intent::RunInPieces(std::make_shared<const Pieces>(drawing)));
  ASSERT_TRUE(run_until([&] { return is_on() && now().pieces.step >= 0; }, seconds(600)));
  EXPECT_EQ(now().pieces.rest_of, 0u);
  session->send(intent::Stop());
  ASSERT_TRUE(ends());
  run(seconds(3));
  const int step = now().pieces.rest_step;
  EXPECT_EQ(now().pieces.rest_of, 7u);
  const auto frame = cut(step);  // as a frame does, it tells of no drawing
  ASSERT_TRUE(frame);
  must(intent::RunInPieces(frame));
  ASSERT_TRUE(run_until([&] { return is_on(); }, seconds(600)));
  session->send(intent::Stop());
  ASSERT_TRUE(ends());
  EXPECT_EQ(now().pieces.drawing, 0u);
  EXPECT_EQ(now().pieces.rest_of, 7u);
  EXPECT_EQ(now().pieces.rest_step, step);
  drawing.drawing = 8;
  must(intent::RunInPieces(std::make_shared<const Pieces>(drawing)));
  EXPECT_TRUE(run_until([&] { return now().pieces.rest_of == 0; }, seconds(60)))
      << "another drawing takes its place";
}

TEST_P(PiecesContractTest, TheRestOfADrawingSurvivesADrawingThatDidNotBegin) {
  auto drawing = *long_one();
  drawing.drawing = 7;
  must(intent::RunInPieces(std::make_shared<const Pieces>(drawing)));
  ASSERT_TRUE(run_until([&] { return is_on() && now().pieces.step >= 0; }, seconds(600)));
  session->send(intent::Stop());
  ASSERT_TRUE(ends());
  run(seconds(3));
  ASSERT_EQ(now().pieces.rest_of, 7u);
  const int step = now().pieces.rest_step;
  drawing.drawing = 8;  // refused: its first act cannot be done
  drawing.all.front().does = {{intent::LoadProgram(0, "; Tool off: whatever"), {}}};
  must(intent::RunInPieces(std::make_shared<const Pieces>(drawing)));
  ASSERT_TRUE(ends(seconds(60)));
  EXPECT_FALSE(now().pieces.ended_because.view().empty());
  EXPECT_EQ(now().pieces.rest_of, 7u);
  EXPECT_EQ(now().pieces.rest_step, step);
  const auto rest = cut(step);
  ASSERT_TRUE(rest);
  must(intent::RunInPieces(rest));
  ASSERT_TRUE(run_until([&] { return !now().pieces.running && !now().any_axis_moving(); }, seconds(900)));
  EXPECT_EQ(axis().position, Steps(at_)) << "and it is gone on with";
}

TEST_P(PiecesContractTest, AHoldKeepsTheNextPieceBack) {
  const auto pieces = long_one();
  if (pieces->all.size() < 2) GTEST_SKIP() << "it is one piece";
  must(intent::RunInPieces(pieces));
  ASSERT_TRUE(run_until([&] { return is_on(); }, seconds(60)));
  must(intent::Pause());
  run(seconds(120));
  const Steps there = axis().position;
  EXPECT_FALSE(is_on());
  EXPECT_TRUE(now().pieces.held);
  EXPECT_LT(there, Steps(at_));
  run(seconds(10));
  EXPECT_EQ(axis().position, there);
  must(intent::Resume());
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_));
}

TEST_P(PiecesContractTest, APieceThatDoesNotEndWhereItShouldIsTheLast) {
  const auto pieces = long_one();
  if (pieces->all.size() < 2) GTEST_SKIP() << "it is one piece";
  place(0, Steps(-50'000), Steps(150));
  must(intent::RunInPieces(pieces));
  ASSERT_TRUE(ends());
  run(seconds(5));
  EXPECT_LT(now().pieces.done, now().pieces.total);
  EXPECT_FALSE(is_on());
  EXPECT_FALSE(reported().empty());
}

TEST_P(PiecesContractTest, APieceThatIsRefusedInMidDrawingIsTheLast) {
  auto pieces = *long_one();
  if (pieces.all.size() < 2) GTEST_SKIP() << "it is one piece";
  pieces.drawing = 7;
  pieces.all[1].does = {{intent::LoadProgram(0, "; Tool off: whatever"), {}}};
  must(intent::RunInPieces(std::make_shared<const Pieces>(pieces)));
  ASSERT_TRUE(run_until([this] { return is_on(); }, seconds(60)));
  ASSERT_TRUE(ends());
  EXPECT_FALSE(is_on());
  EXPECT_EQ(now().pieces.done, 1);
  EXPECT_THAT(std::string(now().pieces.ended_because.view()), HasSubstr("how the tool is switched off"));
  EXPECT_EQ(now().pieces.rest_of, 7u);
  EXPECT_EQ(now().pieces.rest_step, pieces.all[1].first_step);
  const Steps there = axis().position;
  run(seconds(20));
  EXPECT_FALSE(is_on());
  EXPECT_EQ(axis().position, there);
}

TEST_P(PiecesContractTest, AChainThatFitsNowhereIsLiftedOnItsWay) {
  if (session->catalog().program.capacity == 0) GTEST_SKIP() << "it keeps no program";
  add_chains(1, session->catalog().program.capacity > 1000 ? 1500 : 120);
  const auto pieces = cut();
  ASSERT_TRUE(pieces);
  if (pieces->all.front().draws < 0) {  // else it goes on while it is sent
    ASSERT_GT(pieces->all.size(), 1u);
    EXPECT_GT(pieces->lifts, 0);
  }
  must(intent::RunInPieces(pieces));
  ASSERT_TRUE(ends(seconds(1800)));
  EXPECT_EQ(axis().position, Steps(at_));
}

TEST_P(PiecesContractTest, NothingFollowsAPowerCut) {
  const auto pieces = long_one();
  must(intent::RunInPieces(pieces));
  ASSERT_TRUE(run_until([this] { return is_on(); }, seconds(60)));
  operate(bench::PowerCycle());
  run(seconds(60));
  EXPECT_FALSE(now().pieces.running);
  const Steps there = axis().position;
  run(seconds(30));
  EXPECT_EQ(axis().position, there);
  EXPECT_LT(now().pieces.done, now().pieces.total);
}

TEST_P(PiecesContractTest, NothingMovesItsOriginMeanwhile) {
  must(intent::RunInPieces(long_one()));
  ASSERT_TRUE(run_until([this] { return is_on(); }, seconds(60)));
  const IntentOutcome zero = perform(intent::SetPosition(0));
  EXPECT_EQ(zero.state, IntentState::refused);
  EXPECT_THAT(std::string(zero.sentence.view()), HasSubstr("in pieces"));
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_));
}

TEST_P(PiecesContractTest, TheRestOfADrawingBeginsWhereTheToolWasUp) {
  add_chains(3, 4);
  int down = 0;
  for (int i = 0; ix(i) < s_.steps.size(); ++i)
    if (const auto* pen = std::get_if<seq::Pen>(&s_.steps[ix(i)].body); pen && pen->down) down = i;
  const auto rest = cut(down + 3);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->all.front().first_step, down);
  EXPECT_FALSE(cut_from_nowhere());
  must(intent::RunInPieces(rest));
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_));
}

// Drawn in one go, at the pace of a serial line: the tool never stands still on its way.
TEST_P(PiecesContractTest, ABufferNeverRunsDryOnTheWay) {
  TearDown();
  session.reset();
  open(make_wire_opener(), ",wire=real");
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  constexpr int arcs = 5000, radius = 20;
  s_.axes = {{"X", 1}, {"Y", 1}};
  seq::Move start;
  start.to[0] = 0, start.to[1] = 0;
  s_.steps.push_back({start});
  s_.steps.push_back({seq::WaitMotion{}});
  s_.steps.push_back({seq::Pen{true}});
  for (int a = 0; a < arcs; ++a) {  // a wave along X and back
    const int way = a < arcs / 2 ? 1 : -1;
    at_ += 2 * radius * way;
    seq::Arc arc;
    arc.x = at_ - radius * way, arc.y = 0, arc.degrees = a % 2 == 0 ? 180 : -180;
    s_.steps.push_back({arc});
  }
  s_.steps.push_back({seq::WaitMotion{}});
  s_.steps.push_back({seq::Pen{false}});
  const auto pieces = cut();
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->all.size(), 1u);
  must(intent::RunInPieces(pieces));
  ASSERT_TRUE(run_until([this] { return now().feed.sent > 1; }, seconds(60)));
  Duration longest_rest{};
  Instant moved_at = time.now();
  std::array<Steps, 2> there{};
  ASSERT_TRUE(run_until(
      [&] {
        if (const std::array<Steps, 2> here{load_of(0), load_of(1)}; std::exchange(there, here) != here)
          moved_at = time.now();
        if (is_on() && now().feed.running && now().feed.sent > 2)
          longest_rest = std::max(longest_rest, time.now() - moved_at);
        return !now().pieces.running;
      },
      seconds(40'000)));
  EXPECT_LT(longest_rest, Millis(20)) << "a step takes less";
  EXPECT_FALSE(is_on());
  EXPECT_EQ(now().axes[0].position, Steps(at_));
  EXPECT_EQ(now().pieces.done, 1) << reported();
}

TEST_P(PiecesContractTest, ABufferIsDrawnWithTheRampsThatAreSet) {
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  s_.steps = {{seq::Pen{false}}, {seq::Speed{{4000, 150, 80}}}};
  add_chains(1, 1500);  // more than a program holds
  const auto pieces = cut();
  ASSERT_TRUE(pieces);
  std::vector<std::int64_t> set;
  for (const Piece& piece : pieces->all)
    for (const PieceAct& act : piece.does)
      if (const auto* param = act.what ? std::get_if<intent::SetParam>(&*act.what) : nullptr) {
        EXPECT_GE(session->catalog().find_param(param->mnemonic), 0) << param->mnemonic;
        set.push_back(param->value);
      }
  EXPECT_THAT(set, testing::IsSupersetOf({std::int64_t{150}, std::int64_t{80}}));
  must(intent::RunInPieces(pieces));
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_)) << reported();
}

TEST_P(PiecesContractTest, ASequenceSetsHowCloseChordsLieToItsArcs) {
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  s_.axes = {{"X", 10}, {"Y", 10}};
  add_chains(1, 1500);  // more than a program holds
  seq::Move start;
  start.to[0] = 100, start.to[1] = 0;
  s_.steps.push_back({start});
  s_.steps.push_back({seq::Pen{true}});
  s_.steps.push_back({seq::Arc{0, 0, 360, {}}});
  s_.steps.push_back({seq::Pen{false}});
  const auto moves = [this] {
    const auto pieces = cut();
    return pieces ? pieces->all.back().step_of_row.size() : 0;
  };
  EXPECT_EQ(moves(), 100u) << "of 1000 pulses, half a pulse beside it: 3.6 degrees each";
  s_.tolerance = 5;  // 50 pulses
  EXPECT_EQ(moves(), 10u);
}

TEST_P(PiecesContractTest, AHeldBufferHasItsToolOffAndGoesOn) {
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  add_chains(1, 3000);
  must(intent::RunInPieces(cut()));
  ASSERT_TRUE(run_until([this] { return is_on() && now().feed.sent > 100; }, seconds(60)));
  must(intent::Pause());
  ASSERT_TRUE(run_until([this] { return !now().any_axis_moving() && !is_on(); }, seconds(60)));
  const Steps held = axis().position;
  EXPECT_LT(held, Steps(at_));
  run(seconds(5));
  EXPECT_EQ(axis().position, held);
  EXPECT_FALSE(is_on());
  EXPECT_EQ(perform(intent::MoveBy({{id(0), Steps(500)}})).state, IntentState::refused);
  must(intent::Resume());
  ASSERT_TRUE(run_until([&] { return axis().position > held; }, seconds(10)));
  EXPECT_TRUE(is_on());
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_));
  EXPECT_FALSE(is_on());
}

TEST_P(PiecesContractTest, AStopInTheMiddleOfABufferSwitchesItsToolOff) {
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  add_chains(1, 3000);
  must(intent::RunInPieces(cut()));
  ASSERT_TRUE(run_until([this] { return is_on() && now().feed.sent > 100; }, seconds(60)));
  must(intent::Stop());
  ASSERT_TRUE(run_until([this] { return !now().any_axis_moving() && !is_on(); }, seconds(5)));
  run(seconds(30));
  EXPECT_FALSE(now().pieces.running);
  EXPECT_FALSE(is_on());
  EXPECT_LT(axis().position, Steps(at_));
}

/// An axis that does not move has an alarm: the controller takes no more moves, but would do those that it
/// has.
TEST_P(PiecesContractTest, ABufferThatTakesNoMoreMovesIsStoppedWithItsToolOff) {
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  add_chains(1, 3000);
  must(intent::RunInPieces(cut()));
  ASSERT_TRUE(run_until([this] { return is_on() && now().feed.sent > 100; }, seconds(60)));
  operate(bench::Alarm(id(2), true));
  ASSERT_TRUE(run_until([this] { return !now().feed.running; }, seconds(5)));
  const Steps broke_off = axis().position;
  ASSERT_TRUE(run_until([this] { return !is_on(); }, seconds(1)));
  ASSERT_TRUE(run_until([this] { return !now().any_axis_moving(); }, seconds(1)));
  EXPECT_LT(axis().position - broke_off, Steps(30 * 20)) << "it has not done all that was in the buffer";
  run(seconds(5));
  EXPECT_FALSE(now().pieces.running);
  EXPECT_FALSE(is_on());
  EXPECT_THAT(reported(), HasSubstr("was not fully accepted"));
}

TEST_P(PiecesContractTest, ABufferNeedsLoopsOpenAndReportsThisBeforeAnythingMoves) {
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  add_chains(1, 1500);  // more than a program holds
  const auto pieces = cut();
  ASSERT_TRUE(pieces);
  ASSERT_FALSE(pieces->open_loops.empty());
  const OpenLoop& loop = pieces->open_loops.back();
  must(intent::SetParam(loop.parameter, 1));
  ASSERT_TRUE(run_until([&] { return now().axes[loop.axis.index].in_counts; }, seconds(10)));
  EXPECT_EQ(loops_in_the_way(*pieces, now()), 1u << loop.axis.index);
  const IntentOutcome asked = perform(intent::RunInPieces(pieces));
  EXPECT_EQ(asked.state, IntentState::refused);
  EXPECT_THAT(std::string(asked.sentence.view()), HasSubstr("accepts no moves. Nothing was sent."));
  run(seconds(5));
  EXPECT_FALSE(now().pieces.running);
  EXPECT_EQ(axis().position, Steps(0));
  must(intent::SetParam(loop.parameter, 0));
  ASSERT_TRUE(run_until([&] { return loops_in_the_way(*pieces, now()) == 0; }, seconds(10)));
  must(intent::RunInPieces(pieces));
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_)) << reported();
}

TEST_P(PiecesContractTest, TheSpeedOfABufferCanBeOverridden) {
  EXPECT_EQ(perform(intent::OverrideSpeed(50)).state, IntentState::refused) << "nothing is under way";
  if (session->catalog().move_list.columns.empty()) GTEST_SKIP() << "it has no buffer for moves";
  add_chains(1, 3000);
  must(intent::RunInPieces(cut()));
  ASSERT_TRUE(run_until([this] { return now().feed.sent > 300; }, seconds(60)));
  const double full = axis().speed.value;
  must(intent::OverrideSpeed(50));
  EXPECT_EQ(perform(intent::OverrideSpeed(5)).state, IntentState::refused);
  const int behind = now().feed.sent + 100;  // what is in the buffer goes as it was sent
  ASSERT_TRUE(run_until([&] { return now().feed.sent > behind; }, seconds(60)));
  EXPECT_NEAR(axis().speed.value, full / 2, full / 20);
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_));
}

TEST_P(PiecesContractTest, TheSpeedOfTheNextProgramCanBeOverridden) {
  const auto first = long_one();
  if (first->all.front().draws >= 0) GTEST_SKIP() << "its moves go through a buffer";
  constexpr int way = 40'000, ramps = 3'000;
  add_way(at_ += way);
  const auto pieces = cut();
  must(intent::RunInPieces(pieces));
  ASSERT_GT(pieces->all.size(), 1u);
  ASSERT_TRUE(run_until([this] { return is_on(); }, seconds(60)));
  EXPECT_EQ(perform(intent::OverrideSpeed(5)).state, IntentState::refused);
  EXPECT_EQ(now().pieces.percent, 100);
  must(intent::OverrideSpeed(50));
  ASSERT_TRUE(run_until([&] { return axis().position >= Steps(at_ - way + ramps); }, seconds(900)));
  const Instant from = time.now();
  ASSERT_TRUE(run_until([&] { return axis().position >= Steps(at_ - ramps); }, seconds(60))) << reported();
  const double took = std::chrono::duration<double>(time.now() - from).count();
  EXPECT_NEAR(took, (way - 2 * ramps) / 2000.0, 0.5) << "half of 4000 steps/s";
  EXPECT_EQ(perform(intent::OverrideSpeed(100)).state, IntentState::refused) << "it is the last";
  ASSERT_TRUE(ends());
  EXPECT_EQ(axis().position, Steps(at_)) << reported();
}

TEST_P(PiecesContractTest, AFaultNamesTheStepOfTheWholeSequence) {
  add_chains(3, 2);
  s_.steps.push_back({seq::Output{99, true}});
  const auto pieces = GetParam()->language().in_pieces(s_, session->catalog());
  ASSERT_FALSE(pieces);
  EXPECT_THAT(pieces.error().what, HasSubstr(fmt::format("Step {}", s_.steps.size())));
}

}  // namespace
}  // namespace hw
