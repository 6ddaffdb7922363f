#pragma once
// What the console needs of the world around it. Given by whoever builds it; kept apart from console.h, so
// that panels need not compile coroutines.
#include <functional>
#include <string>
#include <utility>

#include "core/session/user_files.h"
#include "core/session/wire.h"
#include "gui/model/traffic_log.h"

namespace hw::gui {

class DeviceFinder;
class PortFinder;
class Worker;

struct Outside {
  Scheduler& scheduler;
  WireOpener open_wire;
  std::function<void()> wake;   ///< any thread: a frame is wanted
  PortFinder* ports = nullptr;  ///< null: finds nothing
  DeviceFinder* devices = nullptr;
  Worker* worker = nullptr;  ///< long jobs of programs; null: within the frame
  UserFolders folders = UserFolders::none();
  std::function<std::string(const Address&)> usb_serial;  ///< of the adapter behind an address; may be null
  DayClock day;                                           ///< what time it is; 0: counts from the start
  Outside(Scheduler& s, WireOpener opener, std::function<void()> w)
      : scheduler(s), open_wire(std::move(opener)), wake(std::move(w)) {}
};

}  // namespace hw::gui
