#pragma once
// Serves emulators to other programs while the console runs (transports/emulator_service), on the io thread.
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/time/scheduler.h"
#include "gui/shell/emulator_server.h"

namespace hw::app {

class EmulatorServing final : public gui::EmulatorServer {
 public:
  EmulatorServing(Scheduler& scheduler, std::function<void()> wake)
      : scheduler_(scheduler), wake_(std::move(wake)) {}

  void serve(const std::string& key, const Address& address, std::shared_ptr<Session> session) override;
  void end(std::string_view key) override;
  const gui::ServedEmulator* find(std::string_view key) override;

  struct Wire;  ///< between the io thread and the GUI thread

 private:
  struct Served {
    gui::ServedEmulator now;
    std::shared_ptr<Wire> wire;
  };
  Scheduler& scheduler_;
  std::function<void()> wake_;
  std::map<std::string, Served, std::less<>> served_;
  int started_ = 0;
};

}  // namespace hw::app
