#include "gui/app/port_examination.h"

#include "transports/port_facts.h"

namespace hw::app {

static gui::ExaminedPort look_at_port(const std::string& path, std::string refused) {
  gui::ExaminedPort port;
  port.holder = other_user_of(path);
  port.adapter_timer = adapter_timer_file(path);
  if (const auto timer = read_adapter_timer(port.adapter_timer)) port.adapter_waits = Millis(*timer);
  port.adapter_timer_can_be_set = may_set_adapter_timer(port.adapter_timer);
  port.refused = std::move(refused);
  return port;
}

void PortExamination::keep_what_is_found(const std::string& path, std::function<gui::ExaminedPort()> look) {
  reader_.run(
      std::move(look), [this, path](gui::ExaminedPort found) { known_[path] = std::move(found); }, alive_);
}

void PortExamination::examine(const std::string& path) {
  keep_what_is_found(path, [path] { return look_at_port(path, {}); });
}

void PortExamination::set_adapter_timer(const std::string& path, int milliseconds) {
  keep_what_is_found(path, [path, milliseconds] {
    const auto set = hw::set_adapter_timer(adapter_timer_file(path), milliseconds);
    return look_at_port(path, set ? std::string() : set.error().sentence());
  });
}

const gui::ExaminedPort* PortExamination::find(const std::string& path) {
  reader_.deliver();
  const auto known = known_.find(path);
  return known == known_.end() ? nullptr : &known->second;
}

}  // namespace hw::app
