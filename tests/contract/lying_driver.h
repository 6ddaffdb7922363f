#pragma once
// A driver around a real one that passes everything on, but for what its lie changes. The real driver writes
// a snapshot of its own; what the pump sees is painted from it.
#include <map>
#include <memory>

#include "core/device/driver.h"
#include "core/device/registry.h"

namespace hw {

/// What a lie can remember of what it has seen.
struct LieMemory {
  explicit LieMemory(const DriverContext& context) : catalog(context.catalog), notify(context.notify) {}

  const Catalog& catalog;
  std::function<void(Notice)> notify;
  Snapshot first;  ///< what was read before anything was asked for
  bool has_first = false;
  std::string reply_before;
  std::map<int, std::string> texts;    ///< loaded, by slot
  std::map<int, std::int64_t> params;  ///< set, by index
  std::map<int, bool> power, outputs;  ///< switched, by axis and by place in the catalog
  std::map<int, Steps> targets, positions_set, positions_read;  ///< by axis
  std::uint32_t homed = 0;                                      ///< bit per axis

  void note(const IntentBody& asked, const Snapshot& now);
};

struct BentStop {
  StopOrder order;
  bool is_sent = true;
};

struct Lie {
  std::string_view name;
  /// Where it makes a difference; null: everywhere.
  bool (*concerns)(const Catalog&) = nullptr;
  /// Answered as done, and not sent.
  bool (*keeps_back)(LieMemory&, const IntentBody&) = nullptr;
  void (*bends)(LieMemory&, IntentBody&) = nullptr;
  void (*orders)(BentStop&) = nullptr;
  void (*paints)(LieMemory&, Snapshot& shown) = nullptr;
  void (*replies)(LieMemory&, std::string& reply) = nullptr;
  bool (*withholds)(const Notice&) = nullptr;
  bool believes_anything = false, knows_no_stop_text = false, moves_twice = false, hides_failures = false;
};

std::unique_ptr<Driver> make_lying_driver(const DeviceType& honest, DriverContext context, const Lie& lie);

}  // namespace hw
