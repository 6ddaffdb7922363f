#pragma once
// A whole controller into one file and back. Io thread; the caller is the session's one reader (notices).
#include <string>
#include <vector>

#include "core/session/parameter_file.h"
#include "core/session/session.h"

namespace hw {

/// Reads every readable parameter, the stored variables and every program slot. Changes nothing.
Task<Result<Backup>> take_backup(std::shared_ptr<Session> session);

struct RestoreReport {
  int parameters_written = 0, parameters_equal = 0, programs_written = 0, variables_written = 0;
  std::vector<std::string> left_out;  ///< a sentence each
  [[nodiscard]] std::string sentence() const;
};

/// Writes what differs, reads back, compares. Parameters that carry a warning (a wrong motor type can destroy
/// a motor) are left out and named unless `warnings_read`. Stores nothing: that is the user's decision.
Task<Result<RestoreReport>> restore_backup(std::shared_ptr<Session> session, Backup backup,
                                           std::string file_name, bool warnings_read);

}  // namespace hw
