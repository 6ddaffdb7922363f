#pragma once
// The common part of both models' catalogs. Each model's catalog.cpp adds its own.
#include "core/device/registry.h"
#include "core/devices/arcus/catalog_params.h"

namespace hw::arcus {

/// The groups of readouts, in this order in every catalog of the family.
enum Group : int { motion, loop, latches, sync_outputs, variable_values, buffer, analog_inputs };

/// Axes, inputs, outputs, limits of numbers, programs, variables, capabilities, homing, setup.
Catalog common_catalog(const Model& model, const Wording& wording);

// Pieces for actions and readouts.
std::vector<ParamChoice> axis_choices(const Model& model, bool all);
ActionField axis_field(const Model& model, bool all = false);
ActionField switch_field();
ActionField number_field(std::string id, std::string label, std::string unit, std::int64_t minimum,
                         std::int64_t maximum, std::int64_t fallback = 0);
ActionField position_field(std::string id, std::string label, std::string unit);
/// The field in pulses, or in counts while StepNLoop of that axis is on.
ActionField followed(ActionField field, int axis = -1);
ActionInfo make_action(std::string id, std::string label, std::string help, std::string group,
                       std::vector<ActionField> fields, std::string manual);
/// A numeric readout.
ReadoutInfo value_readout(std::string label, std::string unit, std::string help);
/// "LTaS" -> one readout per axis.
void add_readouts(Catalog& catalog, const Model& model, Group group, std::string_view form,
                  const ReadoutInfo& pattern);
void add_readout(Catalog& catalog, Group group, std::string id, ReadoutInfo info);

/// Actions whose form differs between the models only by the axis letter: clear, modes, speed and target
/// under way, latch, sync, subroutines.
void add_common_actions(Catalog& catalog, const Model& model, std::string_view chapter);
/// The tables of Control: a row per axis.
void add_axis_tables(Catalog& catalog, const Model& model);
/// StepNLoop states and errors, latch and sync states.
void add_common_readouts(Catalog& catalog, const Model& model);

struct CommandRow {
  const char *form, *example, *help;
  bool moves = false;
  const char* manual = "";
};
std::vector<CommandInfo> commands_of(std::span<const CommandRow> rows);

}  // namespace hw::arcus
