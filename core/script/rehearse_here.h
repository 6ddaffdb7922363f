#pragma once
// A dry run of a program from the controller as it is now, for a script.
#include <string>

#include "core/script/bind.h"

namespace hw::script {

/// Reads what is not known of the controller yet, rehearses, and gives back a table: `duration`, `finished`,
/// `error` (nil: none), `endless`, `limit_touched`, `sent`; `axes` by name, each with `begin`, `position`,
/// `min`, `max`, `travel`; `outputs` by number; `stops`, each with `t`, `line`, `axis`, `direction`,
/// `reason`; `assumptions`, value by name. A text that cannot run: nil and the reason.
Task<Answer> rehearse_here(SessionPtr session, std::string text, int slot);

}  // namespace hw::script
