#pragma once
// A dry run of a program from the controller's present state, for a script.
#include <string>

#include "core/script/bind.h"

namespace hw::script {

/// Reads the controller's unknown values, rehearses, and returns a table: `duration`, `finished`, `error`
/// (nil: none), `endless`, `limit_touched`, `sent`; `axes` by name, each with `begin`, `position`, `min`,
/// `max`, `travel`; `outputs` by number; `stops`, each with `t`, `line`, `axis`, `direction`, `reason`;
/// `assumptions`, value by name. For a text that cannot run: nil and the reason.
Task<Answer> rehearse_here(SessionPtr session, std::string text, int slot);

}  // namespace hw::script
