// One sequence, written in the language of each listed controller: it is understood there, and the dry run
// moves the axes as the sequence says.
#include <algorithm>

#include <gmock/gmock.h>

#include "core/device/language.h"
#include "core/device/sequence_draft.h"
#include "tests/contract/rig.h"
#include "tests/core/device/read_back.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::HasSubstr;

class SequenceContractTest : public testing::TestWithParam<const DeviceType*> {
 protected:
  SequenceContractTest() : catalog(*GetParam()->make_catalog({})), language(GetParam()->language()) {
    axes = std::min<int>(2, static_cast<int>(catalog.axes.size()));
    s.unit = "mm";
    for (int a = 0; a < axes; ++a) s.axes.push_back({catalog.axes[ix(a)].name, 100});
    s.steps = {{seq::Speed{{20, 0, 200}}}};
  }
  void add(seq::Step::Body body) { s.steps.push_back({std::move(body)}); }
  seq::Move to(double first, double second) const {
    seq::Move m;
    m.to[0] = first;
    if (axes > 1) m.to[1] = second;
    return m;
  }
  seq::Move by(int axis, double way) const {
    seq::Move m;
    m.to[ix(axis)] = way;
    m.relative = true;
    return m;
  }
  int last() const { return axes - 1; }
  int free_output() const { return hw::free_output(catalog); }
  SequenceText written() {
    auto text = language.write(s, catalog);
    EXPECT_TRUE(text) << text.error().sentence();
    if (!text) return {};
    EXPECT_EQ(static_cast<std::size_t>(std::count(text->text.begin(), text->text.end(), '\n')),
              text->step_of_line.size());
    for (const Problem& p : language.analyse(text->text, 0).problems)
      EXPECT_FALSE(p.error) << "line " << p.line + 1 << ": " << p.sentence << "\n" << text->text;
    expect_reads_back(language, text->text, s, catalog);
    return std::move(*text);
  }
  Rehearsal rehearsed() {
    const SequenceText text = written();
    auto done = language.rehearse(text.text, RehearseOptions());
    EXPECT_TRUE(done) << done.error().sentence() << "\n" << text.text;
    if (!done) return {};
    EXPECT_TRUE(done->finished) << text.text;
    EXPECT_EQ(done->error, "") << text.text;
    return std::move(*done);
  }
  std::string refusal() {
    const auto text = language.write(s, catalog);
    return text ? "written:\n" + text->text : text.error().what;
  }
  static std::int64_t end_of(const Rehearsal& r, const std::string& axis) {
    for (const RehearsedAxis& a : r.axes)
      if (a.name == axis) return a.position;
    return -1;
  }

  const Catalog catalog;
  const Language& language;
  int axes = 1;
  seq::Sequence s;
};
INSTANTIATE_TEST_SUITE_P(Every, SequenceContractTest, testing::ValuesIn(types_with_a_language()),
                         [](const auto& info) {
                           std::string name(info.param->model);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(SequenceContractTest, MovesWaitsAndLoopsDoWhatTheyState) {
  const int out = free_output();
  add(seq::Comment{"to and fro\nand on"});
  add(to(5, -2.5));
  add(seq::WaitMotion{});
  add(seq::Output{out, true});
  add(seq::Delay{250});
  seq::Repeat inner;
  inner.times = 2;
  inner.steps = {{by(last(), -0.5)}, {seq::WaitMotion{}}};
  seq::Repeat outer;
  outer.times = 3;
  outer.steps = {{by(0, 1.25)}, {seq::WaitMotion{}}, {inner}};
  add(outer);
  s.steps.push_back({to(99, 99), true});
  const Rehearsal r = rehearsed();
  const std::int64_t back = 3 * 2 * 50;
  if (axes > 1) {
    EXPECT_EQ(end_of(r, s.axes[0].name), 500 + 3 * 125);
    EXPECT_EQ(end_of(r, s.axes[1].name), -250 - back);
  } else {
    EXPECT_EQ(end_of(r, s.axes[0].name), 500 + 3 * 125 - back);
  }
  EXPECT_EQ(r.outputs.at(std::to_string(out)), 1);
  EXPECT_GT(r.duration_s, 0.25);
}

TEST_P(SequenceContractTest, LoopsStandInLoops) {
  seq::Repeat loop;
  loop.times = 2;
  loop.steps = {{by(0, 1)}, {seq::WaitMotion{}}};
  for (int depth = 0; depth < 3; ++depth) {
    seq::Repeat around;
    around.times = 2;
    around.steps = {{by(0, 0.5)}, {seq::WaitMotion{}}, {loop}};
    loop = around;
  }
  add(by(0, 1));
  add(seq::WaitMotion{});
  add(loop);
  EXPECT_EQ(end_of(rehearsed(), s.axes[0].name), 100 + 16 * 100 + (2 + 4 + 8) * 50);
}

TEST_P(SequenceContractTest, AMotionsOwnSpeedIsItsOwn) {
  add(to(2, 0));
  add(seq::WaitMotion{});
  const double usual = rehearsed().duration_s;
  seq::Move slow = to(4, 0);
  slow.own = seq::Speeds{2};
  add(slow);
  add(seq::WaitMotion{});
  const double slowly = rehearsed().duration_s - usual;
  add(to(6, 0));
  add(seq::WaitMotion{});
  const double again = rehearsed().duration_s - usual - slowly;
  EXPECT_GT(slowly, 2 * usual) << "2 mm at 2 mm/s";
  EXPECT_NEAR(again, usual, 0.3 * usual);
}

TEST_P(SequenceContractTest, TheToolIsLoweredAndRaisedByItsRoutines) {
  const int out = free_output();
  s.pen_down = {{seq::Output{out, true}}, {seq::Delay{100}}};
  s.pen_up = {{seq::Output{out, false}}, {seq::Delay{50}}};
  for (int n = 0; n < 3; ++n) {
    add(seq::Pen{true});
    add(by(0, 1));
    add(seq::WaitMotion{});
    add(seq::Pen{false});
  }
  Rehearsal r = rehearsed();
  EXPECT_EQ(r.outputs.at(std::to_string(out)), 0);
  const double with = r.duration_s;
  s.pen_down.pop_back(), s.pen_up.pop_back();
  EXPECT_NEAR(with - rehearsed().duration_s, 0.45, 0.02);
}

TEST_P(SequenceContractTest, ARefusalNamesTheStep) {
  seq::Repeat loop;
  loop.times = 2;
  loop.steps = {{seq::Delay{1}}, {to(1e9, 0)}};
  add(loop);
  EXPECT_THAT(refusal(), HasSubstr("Step 2.2 (move): 1000000000 mm of " + s.axes[0].name));
  s.steps.pop_back();
  add(seq::Output{61, true});
  EXPECT_THAT(refusal(), HasSubstr("Step 2 (output): "));
  EXPECT_THAT(refusal(), HasSubstr("has no output 61"));
  s.steps = {{seq::Speed{{1e7}}}};
  EXPECT_THAT(refusal(), HasSubstr("Step 1 (speed): a speed of"));
  s.axes[0].name = "Q";
  EXPECT_THAT(refusal(), HasSubstr("has no axis \"Q\""));
}

TEST_P(SequenceContractTest, ASpeedThatCannotBeKnownIsRefused) {
  s.steps = {{to(1, 0)}};
  std::get<seq::Move>(s.steps[0].body).own = seq::Speeds{10};
  add(to(2, 0));
  EXPECT_THAT(refusal(), HasSubstr("Step 2 (move): an earlier step has changed the speed"));
}

TEST_P(SequenceContractTest, EachLineIsOfItsStep) {
  seq::Repeat loop;
  loop.times = 3;
  loop.steps = {{by(0, 1)}, {seq::Delay{7}}};
  add(loop);
  add(seq::Delay{13});
  const SequenceText text = written();
  std::vector<int> steps = text.step_of_line;
  steps.erase(std::remove(steps.begin(), steps.end(), -1), steps.end());
  EXPECT_EQ(*std::max_element(steps.begin(), steps.end()), 4) << "speed, loop, move, delay, delay";
  for (int step = 0; step < 5; ++step)
    EXPECT_NE(std::find(steps.begin(), steps.end(), step), steps.end()) << step << "\n" << text.text;
}

}  // namespace
}  // namespace hw
