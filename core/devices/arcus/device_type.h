#pragma once
// What the rows of both models in the list of controllers share. The rest of a row each model fills in.
#include "core/device/registry.h"
#include "core/devices/arcus/explain.h"

namespace hw::arcus {

template <const Model& model, std::vector<CommandInfo> (*command_help)()>
DeviceType family_type() {
  DeviceType t{};
  t.model = model.name;
  t.explain = [](std::string_view bytes, Way way, TrafficKind kind, std::string_view asked) {
    static const std::vector<CommandInfo> known = command_help();
    return explain(model, known, bytes, way, kind, asked);
  };
  t.probe = "\r@NNID\r";
  t.recognises = [](std::string_view reply) { return names_product(reply, model); };
  return t;
}

}  // namespace hw::arcus
