#pragma once
// Every setting in words. The numbers (ranges, factory values, forms) are in each model's facts.h; what a
// setting is for is the same for both models and stands here once.
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/devices/arcus/facts.h"

namespace hw::arcus {

/// What the words of one model have of their own.
struct Wording {
  std::string_view feature_chapter;  ///< of its manual: "ch. 6"
  std::vector<ParamBit> polarity_bits;
};

/// All settings of the model, in the order of its facts.
std::vector<ParamInfo> params(const Model& model, const Wording& wording);

/// "HSa" of axis X -> "HSX", "JVn" of 3 -> "JV3".
std::string mnemonic_of(const Model& model, const SettingFact& fact, int place);

/// The longest ramp that table A.0 allows at any speed.
std::int64_t longest_ramp_ms(const Model& model);

}  // namespace hw::arcus
