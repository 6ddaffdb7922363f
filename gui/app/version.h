#pragma once
#include <string>

namespace hw::app {

/// "0.1.0 (da60c0421f3b)": the version and the commit that it was built from. "changed": and what was not
/// committed. Without git only the version.
std::string version();

}  // namespace hw::app
