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

class Driver;  // declared only, so that code which lists or draws controllers need not compile coroutines
struct DriverContext;
class Emulator;

/// key=value options of an address ("motors" -> "4"). Keys are known to the device type or to the transport.
using DeviceOptions = std::map<std::string, std::string>;

/// The maker's unit of intent::Acceleration.
struct AccelerationUnit {
  std::string_view unit;     ///< "ms"
  std::string_view meaning;  ///< what the number means, as a sentence
  std::int64_t minimum = 0, maximum = 0;
};

/// Constant. Each member that may be null or empty is marked so, and all callers handle that. The least that
/// a controller needs is in tests/example: model, make_catalog and make_driver.
struct DeviceType {
  std::string_view model;
  Result<Catalog> (*make_catalog)(const DeviceOptions&);
  std::unique_ptr<Driver> (*make_driver)(DriverContext);
  /// Null: there is no emulator, so its address is refused, programs are not rehearsed, and there is no
  /// bench.
  Result<std::unique_ptr<Emulator>> (*make_emulator)(const DeviceOptions&);
  /// Null: it has no programs, so none is checked, written, rehearsed or sent in pieces.
  const Language& (*language)();
  /// Explains bytes on the wire in a sentence, for the terminal. Pure; any thread. Null: nothing is
  /// explained.
  std::string (*explain)(std::string_view bytes, Way way, TrafficKind kind, std::string_view asked);
  /// A question for `scan`, sent at each rate of the catalog; harmless to every other listed controller too.
  /// NN stands for the two digits of a device on a shared line. Empty: the model is not searched for.
  std::string_view probe;
  /// Whether the reply to `probe` is this model's. Null if `probe` is empty.
  bool (*recognises)(std::string_view reply);
  /// Without a range: its motions take no acceleration of their own.
  AccelerationUnit acceleration = {};
  /// Whether a reply is a refusal by the controller. Null: it has no such replies.
  bool (*refuses)(std::string_view reply) = nullptr;
};

/// In the order of the address table. From core/devices/registry.cpp.
std::span<const DeviceType> device_types();
const DeviceType* find_device_type(std::string_view model);
/// Adds a controller to the list, as the tests do with one that is not in the product. To be called only at
/// the start of a program, before the results of the two functions above are in use.
void add_device_type(const DeviceType& type);

}  // namespace hw
