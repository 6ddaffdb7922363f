#include "tests/simulation/lua_text.h"

#include <string_view>

#include <fmt/core.h>

#include "core/device/registry.h"
#include "core/session/address.h"
#include "tests/simulation/models.h"

namespace hw::simulation {
namespace {

class Script {
 public:
  explicit Script(const Plan& plan) : plan_(plan) {
    const auto address = Address::parse(plan.address());
    if (!address) return;
    ids_ = address->ids();
    const auto catalog = find_device_type(address->model)->make_catalog(address->devices().front().options);
    if (!catalog) return;
    for (const AxisInfo& axis : catalog->axes) axes_.push_back(axis.name);
    for (const HomingMode& mode : catalog->homing_modes) modes_.push_back(mode.id);
  }

  [[nodiscard]] std::string written() const {
    const std::string_view wire = find_model(plan_.model)->wire;
    const std::string place = plan_.address() + (wire.empty() ? "" : "," + std::string(wire));
    std::string all = fmt::format(
        "local c = hw.open(\"{}\")\n"
        "local function at(t) if t > hw.now() then hw.sleep(t - hw.now()) end end\n",
        place);
    for (const Step& step : plan_.steps) {
      const std::string call = call_of(step);
      all += call.empty() ? fmt::format("-- {}\n", step.written())
                          : fmt::format("at({:.3f}) {}\n", seconds(step.at), call);
    }
    return all + fmt::format("at({:.3f}) c:stop()\nprint(c:wait(20))\n", seconds(plan_.length));
  }

 private:
  [[nodiscard]] std::string key(std::int64_t axis) const {
    const std::string name =
        axis < static_cast<std::int64_t>(axes_.size()) ? axes_[static_cast<std::size_t>(axis)] : "?";
    return name[0] >= '0' && name[0] <= '9' ? name : "\"" + name + "\"";
  }
  [[nodiscard]] std::string who(const Step& s) const {
    return ids_.size() > 1 ? fmt::format("c.devices[\"{}\"]", ids_[static_cast<std::size_t>(s.device)]) : "c";
  }
  [[nodiscard]] static std::string text(const Step& s) {
    return fmt::format("[==[{}]==]", s.text);  // no text of ours holds such a bracket
  }
  [[nodiscard]] std::string axis_or_none(std::int64_t axis) const { return axis < 0 ? "" : key(axis); }

  // Empty: a script has no words for it.
  [[nodiscard]] std::string call_of(const Step& s) const {
    const std::string c = who(s);
    const auto n = [&](std::size_t place) { return s.numbers[place]; };
    const char* sign = s.numbers.size() > 1 && n(1) < 0 ? "-" : "+";
    if (s.verb == "stop") return fmt::format("{}:stop({})", c, axis_or_none(n(0)));
    if (s.verb == "abort") return fmt::format("{}:abort({})", c, axis_or_none(n(0)));
    if (s.verb == "stop_wire") return n(0) ? "c:abort()" : "c:stop()";
    if (s.verb == "move_by") return fmt::format("{}:move_by{{[{}]={}}}", c, key(n(0)), n(1));
    if (s.verb == "move_to") return fmt::format("{}:move_to{{[{}]={}}}", c, key(n(0)), n(1));
    if (s.verb == "line") return fmt::format("{}:move_by{{[{}]={},[{}]={}}}", c, key(0), n(0), key(1), n(1));
    if (s.verb == "jog" || s.verb == "jog_frozen")
      return fmt::format("{0}:jog({1}, \"{2}\") at({3:.3f}) {0}:stop({1})", c, key(n(0)), sign,
                         seconds(s.at) + static_cast<double>(n(2)) / 1000);
    if (s.verb == "home")
      return fmt::format("{}:home({}, \"{}\", \"{}\")", c, key(n(0)), sign,
                         modes_.at(static_cast<std::size_t>(n(2))));
    if (s.verb == "type" || s.verb == "type_motion" || s.verb == "type_stop")
      return fmt::format("{}:send({})", c, text(s));
    if (s.verb == "query" || s.verb == "query_stop")
      return fmt::format("{}:query({}, {:.3f})", c, text(s), static_cast<double>(n(0)) / 1000);
    if (s.verb == "load") return fmt::format("{}:load({}, {})", c, text(s), n(0));
    if (s.verb == "run") return fmt::format("{}:run({})", c, n(0));
    if (s.verb == "pause" || s.verb == "resume") return fmt::format("{}:{}()", c, s.verb);
    if (s.verb == "halt") return fmt::format("{}:halt()", c);
    if (s.verb == "set_param") return fmt::format("{}:set({}, {})", c, text(s), n(0));
    if (s.verb == "motor_power") return fmt::format("{}:send(\"EO={}\")", c, n(1) ? "15" : "0");
    if (s.verb == "power_cycle") return fmt::format("{}.bench:power_cycle()", c);
    if (s.verb == "limit")
      return fmt::format("{}.bench:limit({}, \"{}\", {})", c, key(n(0)), sign, n(2) ? "true" : "false");
    if (s.verb == "jam") return fmt::format("{}.bench:jam({}, {})", c, key(n(0)), n(1) ? "true" : "false");
    if (s.verb == "unplug")
      return fmt::format(
          "{0}.bench:unplug(true) {0}.bench:at({1:.3f}, function() {0}.bench:unplug(false) end)", c,
          seconds(s.at) + static_cast<double>(n(0)) / 1000);
    if (s.verb == "garble" && n(0) == 1 && n(1) == 0) return fmt::format("{}.bench:garble({})", c, n(2));
    if (s.verb == "drop" && n(0) == 1 && n(1) == 0) return fmt::format("{}.bench:drop({})", c, n(2));
    return {};
  }

  const Plan& plan_;
  std::vector<std::string> ids_, axes_, modes_;
};

}  // namespace

std::string lua_script(const Plan& plan) { return Script(plan).written(); }

}  // namespace hw::simulation
