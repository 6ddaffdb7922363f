#pragma once
// What is asked of every wish to set a parameter, on any controller, before anything is sent: is it known, in
// its range, possible now, and confirmed where the catalog warns.
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"

namespace hw {

struct ParamRules {
  std::string_view who;                                            ///< "A VXM"
  std::string (*write)(const ParamInfo&, std::int64_t) = nullptr;  ///< a value in a sentence; null: plain
  std::function<Result<>(const ParamInfo&)> may_now = nullptr;     ///< whatever else forbids it now
};

/// Its place in the catalog; or why not, and that nothing was sent.
Result<std::size_t> check_param(const Catalog& catalog, const intent::SetParam& wish,
                                const ParamRules& rules);

}  // namespace hw
