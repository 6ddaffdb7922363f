#include "core/device/param_check.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

Catalog catalog_of_one() {
  Catalog catalog;
  ParamInfo info;
  info.mnemonic = "LNX", info.label = "limits of X";
  info.minimum = 2, info.maximum = 9, info.also_zero = true;
  info.warning = "Take care.";
  info.harmless = 9;
  catalog.params.push_back(info);
  return catalog;
}

intent::SetParam request(std::string mnemonic, std::int64_t value, bool confirmed = false) {
  return intent::SetParam(std::move(mnemonic), value, confirmed);
}

TEST(ParamCheck, RefusesWhatIsNotKnownAndWhatIsOutOfRange) {
  const Catalog catalog = catalog_of_one();
  EXPECT_EQ(check_param(catalog, request("QQ", 1), {"A VXM"}).error().what, "A VXM has no parameter QQ.");
  EXPECT_EQ(check_param(catalog, request("LNX", 1), {"A VXM"}).error().what,
            "1 is not possible for LNX (limits of X): it takes 2 to 9, or 0.");
}

TEST(ParamCheck, AsksOnceWhereTheCatalogWarns) {
  const Catalog catalog = catalog_of_one();
  EXPECT_EQ(check_param(catalog, request("LNX", 3), {"A VXM"}).error().what, "Take care.");
  EXPECT_TRUE(check_param(catalog, request("LNX", 3, true), {"A VXM"}));
  EXPECT_TRUE(check_param(catalog, request("LNX", 9), {"A VXM"}));
}

TEST(ParamCheck, ReportsWhatElseForbidsItBeforeItAsks) {
  ParamRules rules{"A VXM"};
  rules.may_now = [](const ParamInfo&) { return Result<>(fail(FaultKind::refused, "It moves.")); };
  const Catalog catalog = catalog_of_one();
  EXPECT_EQ(check_param(catalog, request("LNX", 3), rules).error().what, "It moves.");
}

}  // namespace
}  // namespace hw
