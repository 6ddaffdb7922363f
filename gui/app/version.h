#pragma once
#include <string>

namespace hw::app {

/// "0.1.0 (da60c0421f3b)": the version and the commit it was built from. "changed": with uncommitted changes.
/// Without git only the version.
std::string version();

}  // namespace hw::app
