#pragma once
// The texts of every setting. Ranges, factory values and forms are in each model's facts.h; the purpose of a
// setting is the same for both models and is described here once.
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/registry.h"
#include "core/devices/arcus/facts.h"

namespace hw::arcus {

/// The wording that differs between the models.
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
inline AccelerationUnit acceleration_unit(const Model& model) {
  return {"ms", "the time of the ramp, as ACC; of the ramp down too unless separate deceleration is on", 1,
          longest_ramp_ms(model)};
}

}  // namespace hw::arcus
