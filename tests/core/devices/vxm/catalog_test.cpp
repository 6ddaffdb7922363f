#include "core/devices/vxm/catalog.h"

#include <set>

#include <gtest/gtest.h>

#include "core/device/snapshot.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {
namespace {

Catalog catalog(const char* motors) { return make_catalog({{"motors", motors}}).value(); }

TEST(VxmCatalog, MotorsDecideTheAxes) {
  EXPECT_EQ(make_catalog({})->axes.size(), 2u);
  EXPECT_EQ(catalog("4").axes.size(), 4u);
  EXPECT_EQ(catalog("4").find_axis("3"), 2);
  EXPECT_EQ(catalog("1").axes.size(), 1u);
  const auto five = make_catalog({{"motors", "5"}});
  ASSERT_FALSE(five);
  EXPECT_EQ(five.error().sentence(),
            "motors=5 is not possible with a VXM. Nothing was opened. Give motors=1 or 2 for one controller, "
            "motors=3 "
            "or 4 for a Master with its Slave.");
}

TEST(VxmCatalog, TheJogButtonsOfAMotorHaveItsNameOverThem) {
  for (const BenchButton& button : catalog("4").bench.buttons) {
    const bool jogs = button.row == 0;
    EXPECT_EQ(button.caption, jogs ? "Motor " + button.name.substr(0, 1) : "") << button.name;
  }
}

TEST(VxmCatalog, EveryParameterHasAnExplanation) {
  std::set<std::string> seen;
  for (const ParamInfo& p : catalog("4").params) {
    EXPECT_TRUE(seen.insert(p.mnemonic).second) << p.mnemonic << " stands twice";
    EXPECT_NE(p.label, p.mnemonic);
    EXPECT_GE(p.label.size(), 8u) << p.mnemonic;
    EXPECT_GE(p.explanation.size(), 40u) << p.mnemonic;
    EXPECT_FALSE(p.group.empty()) << p.mnemonic;
    EXPECT_FALSE(p.manual.empty()) << p.mnemonic;
    EXPECT_TRUE(p.accepts(p.fallback)) << p.mnemonic;
    for (const ParamChoice& c : p.choices) EXPECT_FALSE(c.label.empty()) << p.mnemonic;
    for (const ParamBit& b : p.bits) EXPECT_GE(b.label.size(), 6u) << p.mnemonic;
  }
  EXPECT_LE(seen.size(), static_cast<std::size_t>(max_params));
}

TEST(VxmCatalog, HasEverySetAndGetOfTheManual) {
  const Catalog two = catalog("2"), four = catalog("4");
  for (const char* name :
       {"M1M", "MA1M", "B", "DM", "DA", "j1M", "J2M", "jA1M", "JA2M", "L1M", "P2M", "PA", "I", "Bx", "O"})
    EXPECT_GE(two.find_param(name), 0) << name;
  for (const char* name : {"M3M", "j4M", "P4M", "PMA"}) {
    EXPECT_LT(two.find_param(name), 0) << name;
    EXPECT_GE(four.find_param(name), 0) << name;
  }
}

TEST(VxmCatalog, TheMotorTypeWarningNamesItsMotor) {
  const Catalog c = catalog("2");
  const std::string warning = c.params[c.find_param("M2M")].warning;
  EXPECT_NE(warning.find("motor 2"), std::string::npos);
  EXPECT_EQ(warning.find("motor 1"), std::string::npos);
}

TEST(VxmCatalog, RangesAreTheManuals) {
  const Catalog c = catalog("2");
  const auto param = [&](const char* name) { return c.params[c.find_param(name)]; };
  EXPECT_TRUE(param("j1M").accepts(0));
  EXPECT_FALSE(param("J1M").accepts(39));
  EXPECT_TRUE(param("L1M").accepts(-2));
  EXPECT_FALSE(param("L1M").accepts(3));
  EXPECT_FALSE(param("B").accepts(10));
  EXPECT_FALSE(param("PA").accepts(0));
  EXPECT_FALSE(param("jA1M").accepts(25));
}

TEST(VxmCatalog, ParametersAgreeWithTheFactsOfTheWire) {
  const Catalog c = catalog("4");
  for (const SetupFact& fact : setup_facts)
    for (int m = 1; m <= max_motors; ++m) {
      std::string name(fact.mnemonic);
      if (const auto place = name.find('m'); place != name.npos) name[place] = static_cast<char>('0' + m);
      ASSERT_GE(c.find_param(name), 0) << name;
      const ParamInfo& p = c.params[static_cast<std::size_t>(c.find_param(name))];
      EXPECT_TRUE(p.accepts(fact.min) && p.accepts(fact.max)) << name;
      EXPECT_FALSE(p.accepts(fact.max + 1)) << name;
      EXPECT_TRUE(fact.min - 1 == 0 || !p.accepts(fact.min - 1)) << name;
      EXPECT_EQ(p.accepts(0), fact.also_zero || (fact.min <= 0 && fact.max >= 0)) << name;
      EXPECT_EQ(p.fallback, fact.factory) << name;
      EXPECT_EQ(p.readable, fact.readable) << name;
    }
}

TEST(VxmCatalog, EveryCommandHasHelpAndOnlyRunsMove) {
  std::set<std::string> forms;
  for (const CommandInfo& c : catalog("4").commands) {
    EXPECT_TRUE(forms.insert(c.form).second) << c.form;
    EXPECT_GE(c.help.size(), 10u) << c.form;
    EXPECT_FALSE(c.example.empty()) << c.form;
    EXPECT_FALSE(c.moves && c.stored) << c.form;
    EXPECT_EQ(c.moves, c.form == "R" || c.form == "G" || c.form == "H") << c.form;
  }
}

TEST(VxmCatalog, UnitsAreTheManualsTable) {
  const Catalog c = catalog("2");
  for (const UnitChoice& u : c.units)
    if (u.label.find("E04: ") != std::string::npos) {
      EXPECT_DOUBLE_EQ(u.per_step, 0.001);
      EXPECT_EQ(u.unit, "inch");
      return;
    }
  FAIL() << "no BiSlide E04";
}

TEST(VxmCatalog, RecognisesAnswersToV) {
  for (const char* yes : {"R", "B", "J", "b", "VR", "R\r", "VJ", "^R"}) EXPECT_TRUE(recognises(yes)) << yes;
  for (const char* no : {"", "V", "?V\r", "X", "RR", "\r"}) EXPECT_FALSE(recognises(no)) << no;
}

}  // namespace
}  // namespace hw::vxm
