#pragma once
// The name that somebody probably meant who wrote one that there is not.
#include <string>
#include <string_view>
#include <vector>

namespace hw {

/// The one of `names` that comes near enough to `wanted`; empty: none does.
std::string_view near_name(std::string_view wanted, const std::vector<std::string>& names);

/// ` Did you mean "HSX"?`, with the space before it; empty: no name comes near.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names);

}  // namespace hw
