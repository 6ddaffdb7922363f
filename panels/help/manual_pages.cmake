# The pages of the manual, carried inside the binary: the help of this program is that of this program, wherever it
# is started.
file(GLOB manual_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/assets/manual/*.md)
list(SORT manual_files)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${manual_files})
set(manual_rows "")
foreach(file IN LISTS manual_files)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} page)
  string(APPEND manual_rows "    {\"${name}\", R\"manual(${page})manual\"},\n")
endforeach()
string(CONCAT manual_source [[
#include "panels/help/manual_pages.h"

namespace hw::panels {

static constexpr ManualPage pages_of_the_manual[] = {
]] "${manual_rows}" [[
};

std::span<const ManualPage> manual_pages() { return pages_of_the_manual; }

}  // namespace hw::panels
]])
file(WRITE ${PROJECT_BINARY_DIR}/generated/manual_pages.new "${manual_source}")
file(COPY_FILE ${PROJECT_BINARY_DIR}/generated/manual_pages.new ${PROJECT_BINARY_DIR}/generated/manual_pages.cpp
  ONLY_IF_DIFFERENT)
target_sources(hw_panels PRIVATE ${PROJECT_BINARY_DIR}/generated/manual_pages.cpp)
