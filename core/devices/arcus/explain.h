#pragma once
// The meaning of traffic in plain words, for the terminal. Pure; any thread.
#include <span>
#include <string>
#include <string_view>

#include "core/device/catalog.h"
#include "core/devices/arcus/facts.h"
#include "core/link/traffic.h"

namespace hw::arcus {

/// `asked`: the text last sent before a received entry. Result empty: nothing to explain.
std::string explain(const Model& model, std::span<const CommandInfo> known, std::string_view bytes, Way way,
                    TrafficKind kind, std::string_view asked);
/// Bits of a status word: "accelerating, + limit switch"; "at rest" when none is set.
std::string status_words(const Model& model, std::int64_t word);
/// Whether a reply to ID is this model's.
bool names_product(std::string_view reply, const Model& model);

}  // namespace hw::arcus
