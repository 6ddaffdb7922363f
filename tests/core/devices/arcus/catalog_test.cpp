#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "core/device/command_form.h"
#include "core/device/registry.h"
#include "core/device/snapshot.h"
#include "core/devices/dmx_k_sa/facts.h"
#include "core/devices/pmx_4ex_sa/facts.h"

namespace hw::arcus {
namespace {

struct Subject {
  const Model* model;
  const char* table;
};

class ArcusCatalog : public testing::TestWithParam<Subject> {
 protected:
  [[nodiscard]] const Model& model() const { return *GetParam().model; }
  Catalog catalog = find_device_type(GetParam().model->name)->make_catalog({}).value();
};

INSTANTIATE_TEST_SUITE_P(Both, ArcusCatalog,
                         testing::Values(Subject{&pmx_4ex_sa::model, "arcus/pmx-4ex-sa.tsv"},
                                         Subject{&dmx_k_sa::model, "arcus/dmx-k-sa.tsv"}),
                         [](const auto& info) { return std::string(info.param.model->title.substr(0, 3)); });

TEST_P(ArcusCatalog, EveryParameterHasAnExplanation) {
  std::set<std::string> seen;
  for (const ParamInfo& p : catalog.params) {
    EXPECT_TRUE(seen.insert(p.mnemonic).second) << p.mnemonic << " stands twice";
    EXPECT_NE(p.label, p.mnemonic);
    EXPECT_GE(p.label.size(), 8u) << p.mnemonic;
    EXPECT_GE(p.explanation.size(), 40u) << p.mnemonic;
    EXPECT_EQ(p.label.find('{'), p.label.npos) << p.label;
    EXPECT_EQ(p.explanation.find('{'), p.explanation.npos) << p.explanation;
    EXPECT_FALSE(p.group.empty()) << p.mnemonic;
    EXPECT_GE(p.manual.size(), 20u) << p.mnemonic;
    EXPECT_TRUE(p.accepts(p.fallback)) << p.mnemonic;
    for (const ParamChoice& c : p.choices) EXPECT_GE(c.label.size(), 6u) << p.mnemonic;
    for (const ParamBit& b : p.bits) EXPECT_GE(b.label.size(), 6u) << p.mnemonic;
  }
  EXPECT_LE(seen.size(), static_cast<std::size_t>(max_params));
}

TEST_P(ArcusCatalog, EverySettingOfTheFactsIsAParameterWithItsRange) {
  std::size_t count = 0;
  for (const SettingFact& fact : model().settings) count += static_cast<std::size_t>(fact.count);
  ASSERT_EQ(catalog.params.size(), count);
  for (const SettingFact& fact : model().settings) {
    std::string name(fact.form);
    if (const auto a = name.find('a'); a != name.npos) name[a] = model().axis_letters.back();
    if (const auto n = name.find('n'); n != name.npos) name.replace(n, 1, std::to_string(fact.count));
    const int index = catalog.find_param(name);
    ASSERT_GE(index, 0) << name;
    const ParamInfo& p = catalog.params[static_cast<std::size_t>(index)];
    EXPECT_TRUE(p.accepts(fact.min)) << name;
    EXPECT_TRUE(p.accepts(p.maximum)) << name;
    EXPECT_FALSE(p.accepts(p.maximum + 1)) << name;
    EXPECT_LE(p.maximum, fact.max) << name;
    EXPECT_EQ(p.accepts(0), fact.also_zero || fact.min <= 0) << name;
    EXPECT_EQ(p.fallback, fact.factory) << name;
    EXPECT_EQ(p.stored, fact.stored) << name;
  }
}

TEST_P(ArcusCatalog, ReadoutsAndActionsAreWhole) {
  std::set<std::string> ids;
  EXPECT_LE(catalog.readouts.size(), static_cast<std::size_t>(max_readouts));
  for (const ReadoutInfo& r : catalog.readouts) {
    EXPECT_TRUE(ids.insert(r.id).second) << r.id << " stands twice";
    EXPECT_FALSE(r.label.empty()) << r.id;
    EXPECT_LT(r.group, static_cast<int>(catalog.readout_groups.size())) << r.id;
  }
  ids.clear();
  for (const ActionInfo& a : catalog.actions) {
    EXPECT_TRUE(ids.insert(a.id).second) << a.id << " stands twice";
    EXPECT_GE(a.help.size(), 20u) << a.id;
    EXPECT_FALSE(a.group.empty()) << a.id;
    for (const ActionField& f : a.fields) {
      EXPECT_LE(f.minimum, f.fallback) << a.id << " " << f.id;
      EXPECT_GE(f.maximum, f.fallback) << a.id << " " << f.id;
    }
  }
}

TEST_P(ArcusCatalog, EveryRowOfTheCommandTableHasHelp) {
  std::ifstream table(std::string(HW_TEST_DIR "/core/devices/") + GetParam().table);
  ASSERT_TRUE(table) << GetParam().table;
  std::string line;
  std::getline(table, line);
  int rows = 0;
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    std::string id, form, example;
    std::getline(cells, id, '\t');
    std::getline(cells, form, '\t');
    std::getline(cells, example, '\t');
    ++rows;
    std::string found;
    for (const CommandInfo& c : catalog.commands)
      if (CommandForm(c, catalog.axes).match(example) == CommandForm::Match::whole && found.empty())
        found = c.help;
    EXPECT_GE(found.size(), 10u) << id << ": " << example;
  }
  EXPECT_GT(rows, 100);
}

TEST_P(ArcusCatalog, MotionIsMarkedAsMotion) {
  const auto moves = [&](const char* text) {
    for (const CommandInfo& c : catalog.commands)
      if (CommandForm(c, catalog.axes).match(text) == CommandForm::Match::whole) return c.moves;
    ADD_FAILURE() << text << " is not known";
    return false;
  };
  EXPECT_TRUE(moves("X-1000"));
  EXPECT_TRUE(moves("SR1=1"));
  EXPECT_TRUE(moves("GS3"));
  EXPECT_FALSE(moves("STOP"));
  EXPECT_FALSE(moves("ABORT"));
  EXPECT_FALSE(moves("MST"));
  EXPECT_FALSE(moves("STORE"));
}

TEST(ArcusCatalogs, TheAddressIsTwoDigitsAndNoBroadcast) {
  const auto catalog = [](const char* model, const char* id) {
    return find_device_type(model)->make_catalog({{"id", id}});
  };
  EXPECT_EQ(catalog("dmx-k-sa", "07")->address, 7);
  EXPECT_EQ(catalog("pmx-4ex-sa", "00")->address, 0);
  EXPECT_EQ(catalog("dmx-k-sa", "00").error().sentence(),
            "id=00 is the address of every DMX-K-SA on the line, and no device replies to it. Nothing was "
            "opened. Give the two "
            "digits of one device's name, 01 to 99.");
  EXPECT_FALSE(catalog("dmx-k-sa", "7"));
  EXPECT_FALSE(catalog("pmx-4ex-sa", "4EX00"));
}

}  // namespace
}  // namespace hw::arcus
