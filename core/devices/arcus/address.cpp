#include "core/devices/arcus/address.h"

#include <fmt/core.h>

namespace hw::arcus {

int factory_id(const Model& model) {
  for (const SettingFact& fact : model.settings)
    if (fact.id == Setting::device_name) return static_cast<int>(fact.factory);
  return 0;
}

Result<int> id_option(const DeviceOptions& options, const Model& model) {
  const auto found = options.find("id");
  if (found == options.end()) return factory_id(model);
  const std::string& text = found->second;
  const auto digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
  if (text.size() == 2 && digit(0) && digit(1)) {
    const int id = (text[0] - '0') * 10 + text[1] - '0';
    if (id != model.broadcast) return id;
    return fail(FaultKind::text,
                fmt::format("id={} is the address of every {} on the line, and no device replies to it.",
                            text, model.title),
                "Nothing was opened.", "Give the two digits of one device's name, 01 to 99.");
  }
  return fail(FaultKind::text, fmt::format("id={} is not a device address.", text), "Nothing was opened.",
              fmt::format("Give the last two digits of the device name: id={:02} for {}{:02}.",
                          factory_id(model), model.name_prefix, factory_id(model)));
}

std::string two_digits(int id) { return fmt::format("{:02}", id); }

}  // namespace hw::arcus
