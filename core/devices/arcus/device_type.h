#pragma once
// The common part of both models' rows in the list of controllers. Each model fills in the rest.
#include "core/device/registry.h"
#include "core/devices/arcus/catalog_params.h"
#include "core/devices/arcus/codec.h"
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
  t.acceleration = acceleration_unit(model);
  t.refuses = [](std::string_view reply) { return decode_reply(reply).refused(); };
  return t;
}

}  // namespace hw::arcus
