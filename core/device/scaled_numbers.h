#pragma once

namespace hw {

/// Of languages whose numbers a setting of the controller can scale, also that of another host: a second base
/// class beside Language. The steps of such a text are not known for certain.
class ScaledNumbers {
 public:
  virtual ~ScaledNumbers() = default;
};

}  // namespace hw
