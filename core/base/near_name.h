#pragma once
// The known name that an unknown one was probably meant to be.
#include <string>
#include <string_view>
#include <vector>

namespace hw {

/// The name among `names` that is close enough to `wanted`; empty: none.
std::string_view near_name(std::string_view wanted, const std::vector<std::string>& names);

/// ` Did you mean "HSX"?`, with the leading space; empty: no name is close.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names);

}  // namespace hw
