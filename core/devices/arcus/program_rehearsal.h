#pragma once
// A dry run of a program on an emulator, in virtual time. Pure and long: for a worker thread.
#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/devices/arcus/emulator_arcus.h"
#include "core/devices/arcus/language/dialect.h"

namespace hw::arcus {

/// `emulator`: fresh from power-up. Program 0 is started, and what it starts itself.
Result<Rehearsal> rehearse_program(std::string_view text, const RehearseOptions& options, Emulator& emulator,
                                   const Catalog& catalog, const language::Dialect& dialect);

}  // namespace hw::arcus
