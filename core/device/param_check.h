#pragma once
// Checks a request to set a parameter, on any controller, before anything is sent: the parameter is known,
// the value in range and possible now, and confirmed if the catalog warns.
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"

namespace hw {

struct ParamRules {
  std::string_view title;  ///< "A VXM"
  std::string (*write)(const ParamInfo&,
                       std::int64_t) = nullptr;  ///< formats a value for a sentence; null: plain
  std::function<Result<>(const ParamInfo&)> may_now = nullptr;  ///< any other reason why it cannot be set now
};

/// The parameter's place in the catalog, or why it was refused.
Result<std::size_t> check_param(const Catalog& catalog, const intent::SetParam& request,
                                const ParamRules& rules);

}  // namespace hw
