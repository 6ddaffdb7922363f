#pragma once
// Set-up: one parameter at a time.
#include "core/devices/vme58/servo_drive.h"
#include "core/devices/vme58/speeds.h"

namespace hw::vme58 {

class Setup {
 public:
  Setup(Wire& wire, Readings& readings, const Selection& selection, Commands& commands,
        ParameterValues& values, ServoDrive& drive, Motions& motions, Speeds& speeds, const Catalog& catalog,
        Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        selection_(selection),
        commands_(commands),
        values_(values),
        drive_(drive),
        motions_(motions),
        speeds_(speeds),
        catalog_(catalog),
        snapshot_(snapshot) {}

  Task<Result<>> set(intent::SetParam request);

 private:
  Task<Result<>> check_shown_value(std::size_t place, std::int64_t wanted);

  Wire& wire_;
  Readings& readings_;
  const Selection& selection_;
  Commands& commands_;
  ParameterValues& values_;
  ServoDrive& drive_;
  Motions& motions_;
  Speeds& speeds_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
};

}  // namespace hw::vme58
