#pragma once
// Records one axis for the tuning view: one sample per copy of the data area made by the board.
#include <functional>

#include "core/device/intent.h"
#include "core/devices/vme58/parameter_values.h"
#include "core/motion/servo_watch.h"

namespace hw::vme58 {

class Samples {
 public:
  Samples(const Wire& wire, const Readings& readings, const ParameterValues& values, const Catalog& catalog,
          const Snapshot& snapshot, std::function<void(const AxisSample&)> sample)
      : wire_(wire),
        readings_(readings),
        values_(values),
        catalog_(catalog),
        snapshot_(snapshot),
        sample_(std::move(sample)) {}

  void start(const intent::Sample& request);
  void end() { axis_ = -1; }
  [[nodiscard]] bool are_taken() const { return axis_ >= 0 && wire_.now() < until_; }
  /// The axes have been read.
  void take(Instant at);

 private:
  const Wire& wire_;
  const Readings& readings_;
  const ParameterValues& values_;
  const Catalog& catalog_;
  const Snapshot& snapshot_;
  std::function<void(const AxisSample&)> sample_;
  int axis_ = -1;
  Instant until_{};
  motion::ServoWatch watch_;
};

}  // namespace hw::vme58
