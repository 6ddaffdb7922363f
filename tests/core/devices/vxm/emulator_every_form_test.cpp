// Every command form of the manual has a test of its own.
#include "tests/core/devices/vxm/form_case.h"

namespace hw::vxm::proof {

TEST(VxmTable, EveryFormHasACase) {
  ASSERT_GT(form_table().size(), 190u) << "vxm.tsv was not read";
  for (const Form& f : form_table()) EXPECT_TRUE(has_case(f.id)) << "no [" << f.id << "] in vxm.forms";
}

TEST(VxmTable, EveryCaseHasARow) {
  for (const std::string& id : cases_without_row()) ADD_FAILURE() << id << " stands in no row of vxm.tsv";
}

}  // namespace hw::vxm::proof
