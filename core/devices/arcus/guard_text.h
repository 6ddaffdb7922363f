#pragma once
// The program of the guard of held jogs (decision AMB-142): what it says, how it is offered, and whether it
// is what a controller holds.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/device/jog_guard.h"
#include "core/devices/arcus/facts.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// The axes that a hand jogs, a bit each; and what the program works with.
inline constexpr int guard_axes_variable = 49, guard_work_variable = 48;

/// The last one: a controller with a single program begins with the first.
[[nodiscard]] constexpr int guard_program(const Model& model) { return model.programs - 1; }

/// `time_out`: TOC as it is while no jog is held, which the program puts back.
[[nodiscard]] std::string guard_text(const Model& model, std::int64_t time_out);
[[nodiscard]] std::vector<std::string> guard_lines(const language::Dialect& dialect, const Model& model,
                                                   std::int64_t time_out);
/// The time-out that it puts back; none: this is another program.
[[nodiscard]] std::optional<std::int64_t> read_guard(const std::vector<std::string>& lines,
                                                     const language::Dialect& dialect, const Model& model);

[[nodiscard]] JogGuardFacts guard_facts(const Model& model);

}  // namespace hw::arcus
