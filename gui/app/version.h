#pragma once
#include <string>

namespace hw::app {

/// "0.1.0 (da60c0421f3b)": the version and the commit of the build. "changed" marks uncommitted changes.
/// Without git it is only the version.
std::string version();

}  // namespace hw::app
