// What the options of an address make of the catalog.
#include "core/devices/vme58/catalog.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "core/device/servo_tuning.h"
#include "core/devices/vme58/emulator.h"

namespace hw::vme58 {
namespace {

std::int64_t fallback(const Catalog& c, std::string_view mnemonic) {
  return c.params[static_cast<std::size_t>(c.find_param(mnemonic))].fallback;
}

TEST(Vme58Catalog, EveryChoiceThatItOffersIsOneOfTheEmulators) {
  const auto catalog = make_catalog({});
  ASSERT_TRUE(catalog);
  std::vector<std::string> keys;
  for (const OptionInfo& option : catalog->options) {
    keys.push_back(option.key);
    for (const auto& [value, label] : option.choices) {
      EXPECT_TRUE(make_catalog({{option.key, value}})) << option.key << "=" << value;
      EXPECT_TRUE(make_emulator({{option.key, value}})) << option.key << "=" << value;
      EXPECT_FALSE(label.empty());
    }
  }
  EXPECT_THAT(keys, testing::ElementsAre("variant", "jumpers"));
}

TEST(Vme58Catalog, FirstChoicesAreTheUsualOnes) {
  const auto usual = make_catalog({});
  DeviceOptions first;
  for (const OptionInfo& option : usual->options) first[option.key] = option.choices.front().first;
  const auto chosen = make_catalog(first);
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->name, usual->name);
  ASSERT_EQ(chosen->outputs.size(), usual->outputs.size());
  for (std::size_t i = 0; i < usual->outputs.size(); ++i)
    EXPECT_EQ(chosen->outputs[i].name, usual->outputs[i].name);
}

TEST(Vme58Catalog, JumpersDecideWhichLinesAreOutputs) {
  const auto catalog = make_catalog({{"jumpers", "OII"}});
  ASSERT_TRUE(catalog);
  EXPECT_GE(catalog->find_output(0), 0);
  EXPECT_GE(catalog->find_output(3), 0);
  EXPECT_LT(catalog->find_output(8), 0);
  EXPECT_GE(catalog->find_output(13), 0) << "the last two are outputs for good";
}

TEST(Vme58Catalog, EachLineHasItsDirection) {
  const auto catalog = make_catalog({{"jumpers", "IOI"}});
  ASSERT_TRUE(catalog);
  ASSERT_EQ(catalog->inputs.size(), 14u);
  const auto line = [&](std::size_t n) -> const InputInfo& { return catalog->inputs[n]; };
  EXPECT_EQ(line(3).name, "In 3");
  EXPECT_EQ(line(3).group, "Lines 0 to 3: inputs");
  EXPECT_FALSE(line(3).of_output);
  EXPECT_TRUE(line(4).of_output);
  EXPECT_EQ(line(4).group, "Lines 4 to 7: outputs");
  EXPECT_THAT(line(4).help, testing::HasSubstr("an output by the jumper of lines 4 to 7"));
  EXPECT_EQ(line(11).group, "Lines 8 to 11: inputs");
  EXPECT_EQ(line(12).group, "Lines 12 to 13: outputs");
  EXPECT_THAT(line(12).help, testing::HasSubstr("always an output"));
  EXPECT_EQ(catalog->outputs[0].group, line(4).group) << "its switch stands with it";
  EXPECT_EQ(catalog->outputs.back().group, "Auxiliary: outputs");
  EXPECT_EQ(make_catalog({})->inputs[13].group, "Lines 8 to 13: outputs")
      << "neighbours of the same direction";
}

TEST(Vme58Catalog, NoActionIsOfferedThatNoAxisCanDo) {
  const auto without = make_catalog({{"variant", "4"}});
  ASSERT_TRUE(without);
  EXPECT_LT(without->find_action("encoder_ratio"), 0);
  EXPECT_LT(without->find_action("slip_interrupt"), 0);
  EXPECT_GE(without->find_action("force_position"), 0);
  for (const OptionInfo& option : without->options)
    for (const auto& [value, label] : option.choices) {
      if (option.key != "variant") continue;
      const auto catalog = make_catalog({{"variant", value}});
      for (const ActionInfo& action : catalog->actions)
        for (const ActionField& field : action.fields)
          EXPECT_FALSE(field.id == "axis" && field.choices.empty()) << value << " " << action.id;
    }
}

// A cell is empty only where the axis lacks what it would show.
TEST(Vme58Catalog, TablesNameNothingThatIsNotThere) {
  const auto catalog = make_catalog({});
  ASSERT_TRUE(catalog);
  using Shows = AxisColumn::Shows;
  for (const AxisTable& table : catalog->axis_tables)
    for (const AxisColumn& column : table.columns)
      for (const AxisInfo& axis : catalog->axes) {
        const auto of_axis = [&](std::string id) {
          if (const auto star = id.find('*'); star != id.npos) id.replace(star, 1, axis.name);
          return id;
        };
        const std::string id = of_axis(column.id);
        const bool is_readout = column.shows == Shows::readout, is_motion = column.shows == Shows::motion;
        EXPECT_TRUE(is_motion || (is_readout ? catalog->find_readout(id) : catalog->find_action(id)) >= 0)
            << id;
        EXPECT_TRUE(column.state.empty() || catalog->find_readout(of_axis(column.state)) >= 0)
            << column.state;
      }
}

TEST(Vme58Catalog, GainsStandUnderTheHeadingThatTheTuningPanelLooksFor) {
  const auto catalog = make_catalog({});
  ASSERT_TRUE(catalog);
  const int kp = catalog->find_param("KPX");
  ASSERT_GE(kp, 0);
  EXPECT_EQ(catalog->params[static_cast<std::size_t>(kp)].group, servo_loop_group);
}

TEST(Vme58Catalog, ValuesLeftOpenByTheDataSheetAreShownAsConfigured) {
  const auto catalog = make_catalog({{"velocity", "3000"},
                                     {"acceleration", "7000"},
                                     {"base_velocity", "20"},
                                     {"contour_size", "50"},
                                     {"servo_update_us", "500"},
                                     {"base", "0xF000"}});
  ASSERT_TRUE(catalog);
  EXPECT_EQ(fallback(*catalog, "VLX"), 3000);
  EXPECT_EQ(fallback(*catalog, "ACS"), 7000);
  EXPECT_EQ(fallback(*catalog, "VBY"), 20);
  EXPECT_EQ(catalog->contour_size, 50);
  EXPECT_EQ(catalog->servo_update, std::chrono::microseconds(500));
  EXPECT_EQ(catalog->made_from.count("base"), 0u) << "of the way to the board, not of the board";
  EXPECT_EQ(catalog->made_from.size(), 5u);
  EXPECT_FALSE(make_catalog({{"velocity", "fast"}}));
}

}  // namespace
}  // namespace hw::vme58
