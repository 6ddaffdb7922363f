// Every row of the table of the data sheet has a case of its own in vme58.forms.
#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {

TEST(Vme58Table, EveryFormHasACase) {
  ASSERT_EQ(form_table().size(), 267u) << "vme58.tsv was not read";
  for (const Form& f : form_table()) EXPECT_TRUE(has_case(f.id)) << f.id << " has no case in vme58.forms";
}

TEST(Vme58Table, EveryCaseHasARow) {
  for (const std::string& id : cases_without_row()) ADD_FAILURE() << id << " stands in no row of vme58.tsv";
}

}  // namespace hw::vme58::proof
