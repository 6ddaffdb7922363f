// Every row of the tables of interactive commands, by a case of its own (form_case.h).
#include <algorithm>
#include <map>
#include <set>

#include "tests/core/devices/arcus/form_case.h"

namespace hw::arcus::proof {
namespace {

class ArcusForms : public ::testing::TestWithParam<Which> {};

std::string name_of(const ::testing::TestParamInfo<Which>& info) {
  return info.param == Which::pmx ? "Pmx" : "Dmx";
}

TEST_P(ArcusForms, EveryRowHasOneCaseAndEveryCaseARow) {
  std::set<std::string> rows, cases;
  for (const Form& form : form_table(GetParam())) rows.insert(form.id);
  for (const FormCase& c : form_cases(GetParam())) EXPECT_TRUE(cases.insert(c.id).second) << c.id << " twice";
  EXPECT_GT(rows.size(), 100u);
  for (const std::string& id : rows) EXPECT_TRUE(cases.count(id) != 0) << "no case for " << id;
  for (const std::string& id : cases) EXPECT_TRUE(rows.count(id) != 0) << "no row for " << id;
}

INSTANTIATE_TEST_SUITE_P(Tables, ArcusForms, ::testing::Values(Which::pmx, Which::dmx), name_of);

class FormTest : public ::testing::Test {
 public:
  FormTest(Which which, Form form, FormCase body)
      : which_(which), form_(std::move(form)), body_(std::move(body)) {}
  void TestBody() override { run_form_case(which_, form_, body_); }

 private:
  Which which_;
  Form form_;
  FormCase body_;
};

class SessionTest : public ::testing::Test {
 public:
  SessionTest(Which which, FormCase body) : which_(which), body_(std::move(body)) {}
  void TestBody() override { run_session(which_, body_); }

 private:
  Which which_;
  FormCase body_;
};

/// A test for each case, under the id of its row, and one for each session.
const bool registered = [] {
  for (const Which which : {Which::pmx, Which::dmx}) {
    for (const FormCase& c : session_cases(which))
      ::testing::RegisterTest("ArcusSession", c.id.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                              [which, c]() -> ::testing::Test* { return new SessionTest(which, c); });
    std::map<std::string, Form> rows;
    for (const Form& form : form_table(which)) rows[form.id] = form;
    for (const FormCase& c : form_cases(which)) {
      if (rows.count(c.id) == 0) continue;
      std::string name = c.id;
      std::replace(name.begin(), name.end(), '.', '_');
      const Form form = rows[c.id];
      ::testing::RegisterTest(
          "ArcusForm", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
          [which, form, c]() -> ::testing::Test* { return new FormTest(which, form, c); });
    }
  }
  return true;
}();

}  // namespace
}  // namespace hw::arcus::proof
