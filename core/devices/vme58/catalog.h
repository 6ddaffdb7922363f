#pragma once
#include "core/device/catalog.h"
#include "core/device/registry.h"
#include "core/devices/vme58/facts.h"

namespace hw::vme58 {

inline constexpr AccelerationUnit acceleration_unit{"counts/s²", "as AC of the axis", 1, acceleration_max};

/// Readout groups, in their order.
enum Group : std::uint8_t { flag_group, queue_group, memory_group, loop_group };
/// Auxiliary outputs are numbered after the general lines: 14 is X.
inline constexpr int first_auxiliary = io_lines;
/// Ways of homing, in the catalog's order.
enum class HomeMode : std::uint8_t { edge, back_to_edge, stop_dead };
/// Actions, in the catalog's order. From encoder_ratio on they need an axis with an encoder.
enum class Action : std::uint8_t {
  clear_flags,
  flush,
  fraction_jog,
  remainder,
  clear_while,
  force_position,
  encoder_ratio,
  hold,
  track,
  slip_interrupt
};

Result<Catalog> make_catalog(const DeviceOptions& options);
bool recognises(std::string_view reply);

std::vector<CommandInfo> command_help();
std::vector<ParamInfo> param_infos(const Variant& variant);
/// Adds the tables of Control, a row per axis, after the actions and the set-up.
void add_axis_tables(Catalog& catalog);
/// Catalog::stopping_way.
std::optional<double> stopping_way(const Catalog& catalog, const Snapshot& now, AxisId axis);
void add_memory_map(Catalog& catalog, const Variant& variant);

}  // namespace hw::vme58
