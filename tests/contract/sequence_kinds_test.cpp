// Every kind of step with its settings, for every listed controller: it is written and read back as that
// step, written as other steps that do the same, or refused by a sentence that names it.
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "core/device/language.h"
#include "core/sequence/fields.h"
#include "core/sequence/sequence_file.h"
#include "tests/contract/rig.h"
#include "tests/core/device/read_back.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::HasSubstr;
using testing::StartsWith;

/// `same`: read back it says the same. `other`: the controller does it by other steps, or by more of them.
enum class Kept : std::uint8_t { same, other, refused };
constexpr Kept S = Kept::same, O = Kept::other, R = Kept::refused;

/// What a step needs of its controller.
struct Lines {
  int input = 1, output = 1;
  std::string own_text;
};
struct Kind {
  const char* name;
  std::function<seq::Step::Body(const Lines&)> make;
  std::array<Kept, 4> kept;  ///< in the order of `models`
};
constexpr std::array<std::string_view, 4> models{"vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"};

seq::Move move(double first, std::optional<double> second = {}, bool relative = false) {
  seq::Move m;
  m.to[0] = first, m.to[1] = second;
  m.relative = relative;
  return m;
}
seq::MoveOnInput on_input(const Lines& l, seq::MoveOnInput::Kind kind) {
  seq::MoveOnInput m;
  m.input = l.input, m.kind = kind, m.to = 70;
  return m;
}
using Input = seq::MoveOnInput::Kind;

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"speed",
       [](auto&) {
         return seq::Speed{{2000, 0, 500}};
       },
       {S, S, S, S}},
      {"move to", [](auto&) { return move(70); }, {S, S, S, S}},
      {"move by", [](auto&) { return move(70, {}, true); }, {S, S, S, S}},
      {"move of two", [](auto&) { return move(70, 90); }, {O, S, S, S}},
      {"move at its own speed",
       [](auto&) {
         seq::Move m = move(70);
         m.own = seq::Speeds{500};
         return m;
       },
       {O, O, O, O}},
      {"arc",
       [](auto&) {
         return seq::Arc{0, 0, 90};
       },
       {R, S, R, O}},
      {"arc the other way",
       [](auto&) {
         return seq::Arc{0, 0, -90};
       },
       {R, S, R, O}},
      {"circle",
       [](auto&) {
         return seq::Arc{0, 0, 360};
       },
       {R, S, R, O}},
      {"jog",
       [](auto&) {
         return seq::Jog{0, Sign::plus};
       },
       {R, S, S, S}},
      {"jog back",
       [](auto&) {
         return seq::Jog{0, Sign::minus};
       },
       {R, S, S, S}},
      {"home",
       [](auto&) {
         return seq::Home{0, Sign::minus};
       },
       {S, S, S, S}},
      {"home forth",
       [](auto&) {
         return seq::Home{0, Sign::plus};
       },
       {S, S, S, S}},
      {"stop",
       [](auto&) {
         return seq::Stop{0, false};
       },
       {R, S, S, R}},
      {"stop at once",
       [](auto&) {
         return seq::Stop{0, true};
       },
       {R, S, S, R}},
      {"stop all", [](auto&) { return seq::Stop{}; }, {R, S, O, R}},
      {"wait for all", [](auto&) { return seq::WaitMotion{}; }, {O, S, S, S}},
      {"wait for one", [](auto&) { return seq::WaitMotion{0}; }, {O, S, O, O}},
      {"delay", [](auto&) { return seq::Delay{250}; }, {S, S, S, S}},
      {"input on",
       [](auto& l) {
         return seq::WaitInput{l.input, true};
       },
       {S, S, S, R}},
      {"input off",
       [](auto& l) {
         return seq::WaitInput{l.input, false};
       },
       {S, S, S, S}},
      {"move on input", [](auto& l) { return on_input(l, Input::move); }, {S, S, S, R}},
      {"jog on input", [](auto& l) { return on_input(l, Input::jog); }, {R, S, S, R}},
      {"home on input", [](auto& l) { return on_input(l, Input::home); }, {O, S, S, R}},
      {"move on input behind a stop",
       [](auto& l) {
         seq::MoveOnInput m = on_input(l, Input::move);
         m.stops_first = true;
         return m;
       },
       {O, S, S, R}},
      {"output on",
       [](auto& l) {
         return seq::Output{l.output, true};
       },
       {S, S, S, S}},
      {"output off",
       [](auto& l) {
         return seq::Output{l.output, false};
       },
       {S, S, S, S}},
      {"all outputs",
       [](auto&) {
         return seq::Output{-1, true, 1};
       },
       {O, S, S, O}},
      {"power on",
       [](auto&) {
         return seq::Enable{0, true};
       },
       {R, S, S, R}},
      {"power off",
       [](auto&) {
         return seq::Enable{0, false};
       },
       {R, S, S, R}},
      {"tool down", [](auto&) { return seq::Pen{true}; }, {O, S, S, O}},
      {"tool up", [](auto&) { return seq::Pen{false}; }, {O, S, S, O}},
      {"comment", [](auto&) { return seq::Comment{"what comes next"}; }, {O, O, O, O}},
      {"loop",
       [](auto&) {
         return seq::Repeat{3, {{move(5, {}, true)}}};
       },
       {S, S, S, S}},
      {"loop for ever",
       [](auto&) {
         return seq::Repeat{0, {{move(5, {}, true)}}};
       },
       {S, S, S, S}},
      {"own text",
       [](auto& l) {
         return seq::Custom{"of its own", l.own_text};
       },
       {O, O, O, O}},
      {"contour",
       [](auto&) {
         seq::Contour c;
         c.x = 30, c.y = 40, c.ends_ramped = false;
         c.steps = {{move(90, 40)}};
         return c;
       },
       {O, O, R, O}},
      {"speed stairs",
       [](auto&) {
         return seq::SpeedStairs{0, {{100, 500}, {200, 800}}, 300};
       },
       {R, R, R, O}}};
  return all;
}

class SequenceKindsTest : public testing::TestWithParam<const DeviceType*> {
 protected:
  SequenceKindsTest() : catalog(*GetParam()->make_catalog({})), language(GetParam()->language()) {
    static const std::map<std::string_view, std::string> own{
        {"vxm", "P3"}, {"pmx-4ex-sa", "V1=5"}, {"dmx-k-sa", "V1=5"}, {"vme58", "WT3"}};
    lines = {catalog.input_number(0), free_output(catalog), own.at(GetParam()->model)};
  }
  /// Behind a speed and a move to where it begins.
  [[nodiscard]] seq::Sequence with(const seq::Step::Body& body) const {
    seq::Sequence s;
    s.unit = catalog.step_word;
    const std::size_t axes = std::min<std::size_t>(2, catalog.axes.size());
    for (std::size_t a = 0; a < axes; ++a) s.axes.push_back({catalog.axes[a].name, 1});
    s.pen_down = {{seq::Output{lines.output, true}}, {seq::Delay{100}}};
    s.pen_up = {{seq::Output{lines.output, false}}};
    s.steps = {{seq::Speed{{1000, 0, 250}}}, {move(30, 40)}, {body}};
    if (const auto* pen = std::get_if<seq::Pen>(&body)) s.steps.push_back({seq::Pen{!pen->down}});
    return s;
  }
  /// As steps the text is the same program again; remarks may stand elsewhere.
  void expect_same_commands(const std::string& text, const seq::Sequence& of) const {
    const auto read = language.read(text, of, catalog);
    ASSERT_TRUE(read) << read.error().sentence() << "\n" << text;
    const auto again = language.write(read->sequence, catalog);
    ASSERT_TRUE(again) << again.error().sentence() << "\n" << text;
    EXPECT_EQ(language.analyse(again->text, 0).listing, language.analyse(text, 0).listing) << again->text;
  }
  [[nodiscard]] Kept kept(const Kind& kind) const {
    const auto model = std::find(models.begin(), models.end(), GetParam()->model);
    return kind.kept[static_cast<std::size_t>(model - models.begin())];
  }
  const Catalog catalog;
  const Language& language;
  Lines lines;
};
std::vector<const DeviceType*> types_in_the_table() {
  std::vector<const DeviceType*> all = types_under_test();
  std::erase_if(all, [](const DeviceType* type) {
    return std::find(models.begin(), models.end(), type->model) == models.end();
  });
  return all;
}
INSTANTIATE_TEST_SUITE_P(Every, SequenceKindsTest, testing::ValuesIn(types_in_the_table()), name_of_type);

TEST_P(SequenceKindsTest, IsWrittenAndReadBackOrRefusedByItsName) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const seq::Step::Body body = kind.make(lines);
    const seq::Sequence s = with(body);
    const auto text = language.write(s, catalog);
    if (kept(kind) == Kept::refused) {
      ASSERT_FALSE(text) << text->text;
      EXPECT_THAT(text.error().what,
                  StartsWith("Step 3 (" + std::string(seq::kind_names[body.index()]) + "): "));
      continue;
    }
    EXPECT_TRUE(text) << text.error().sentence();
    if (!text) continue;
    for (const Problem& p : language.analyse(text->text, 0).problems)
      EXPECT_FALSE(p.error) << "line " << p.line + 1 << ": " << p.sentence << "\n" << text->text;
    expect_same_commands(text->text, s);
    const auto read = language.read(text->text, s, catalog);
    if (!read || kept(kind) != Kept::same) continue;
    const seq::StepList alone{seq::Step{body}};
    EXPECT_THAT(in_words(read->sequence.steps, read->sequence), HasSubstr(in_words(alone, s))) << text->text;
  }
}

TEST_P(SequenceKindsTest, IsTheSameInAFile) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const seq::Sequence s = with(kind.make(lines));
    const auto read = seq::read_sequence(seq::write_sequence(s), "kinds.toml");
    EXPECT_TRUE(read) << read.error().sentence();
    if (read) {
      EXPECT_EQ(seq::write_sequence(*read), seq::write_sequence(s));
      EXPECT_TRUE(s.axes.size() < 2 || *read == s) << "places of axes that it has not are in no file";
    }
  }
}

TEST(SequenceKinds, AreAllInTheTable) {
  std::set<std::size_t> found;
  for (const Kind& kind : kinds()) found.insert(kind.make({}).index());
  EXPECT_EQ(found.size(), seq::kind_names.size());
}

}  // namespace
}  // namespace hw
