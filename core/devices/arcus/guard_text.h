#pragma once
// The guard program for held jogs (decision AMB-142): its text, how it is offered, and how it is recognised
// in a controller.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/device/jog_guard.h"
#include "core/devices/arcus/facts.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// Variables: the axes jogged by hand, a bit each; and the program's work variable.
inline constexpr int guard_axes_variable = 49, guard_work_variable = 48;

/// The last program, because a user's single program is stored as the first.
[[nodiscard]] constexpr int guard_program(const Model& model) { return model.programs - 1; }

/// `time_out`: TOC while no jog is held; the program restores it.
[[nodiscard]] std::string guard_text(const Model& model, std::int64_t time_out);
[[nodiscard]] std::vector<std::string> guard_lines(const language::Dialect& dialect, const Model& model,
                                                   std::int64_t time_out);
/// The time-out that the program restores; none: another program.
[[nodiscard]] std::optional<std::int64_t> read_guard(const std::vector<std::string>& lines,
                                                     const language::Dialect& dialect, const Model& model);

[[nodiscard]] JogGuardFacts guard_facts(const Model& model);

}  // namespace hw::arcus
