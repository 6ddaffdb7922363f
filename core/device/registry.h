#pragma once
// The list of controllers. A new one is a folder in core/devices/ and one line in core/devices/registry.cpp.
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/link/traffic.h"

namespace hw {

class Driver;  // kept out of here: whoever only lists or draws controllers need not compile coroutines
struct DriverContext;
class Emulator;

/// key=value options of an address ("motors" -> "4"). Keys are known to the device type or to the transport.
using DeviceOptions = std::map<std::string, std::string>;

/// What intent::Acceleration counts, as the maker has it.
struct AccelerationUnit {
  std::string_view unit;     ///< "ms"
  std::string_view meaning;  ///< what the number says, and of what; a sentence
  std::int64_t minimum = 0, maximum = 0;
};

/// All of it is constant. What may be null or empty says so; all of the house takes it so.
struct DeviceType {
  std::string_view model;
  Result<Catalog> (*make_catalog)(const DeviceOptions&);
  std::unique_ptr<Driver> (*make_driver)(DriverContext);
  /// Null: there is no emulator. Its address is refused, programs are not rehearsed, and there is no bench.
  Result<std::unique_ptr<Emulator>> (*make_emulator)(const DeviceOptions&);
  const Language& (*language)();
  /// What bytes on the wire mean, for the terminal. Pure; any thread. Appends to nothing, returns a sentence.
  std::string (*explain)(std::string_view bytes, Way way, TrafficKind kind, std::string_view asked);
  /// A harmless question and whether the answer is this model's (`scan`): sent at each rate of the catalog.
  /// Where several devices can share a line, NN in it stands for the two digits of the one that is asked.
  /// Empty: it is never looked for.
  std::string_view probe;
  /// Null if `probe` is empty.
  bool (*recognises)(std::string_view reply);
  AccelerationUnit acceleration = {};
  /// Whether an answer is the controller's own "no" to what was sent. Null: it has no such answers.
  bool (*refuses)(std::string_view reply) = nullptr;
};

/// In the order of the address table. From core/devices/registry.cpp.
std::span<const DeviceType> device_types();
const DeviceType* find_device_type(std::string_view model);

}  // namespace hw
