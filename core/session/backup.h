#pragma once
// Backs up a whole controller to one file and restores it. Io thread.
#include <string>
#include <vector>

#include "core/session/parameter_file.h"
#include "core/session/session.h"

namespace hw {

/// Reads every readable parameter, the stored variables and every program slot. Changes nothing.
Task<Result<Backup>> take_backup(std::shared_ptr<Session> session);

struct RestoreReport {
  int parameters_written = 0, parameters_equal = 0, programs_written = 0, programs_emptied = 0,
      variables_written = 0;
  std::vector<std::string> left_out;  ///< entries that the controller cannot hold, a sentence each
  std::vector<std::string> warnings;  ///< of differing parameters that carry one, a sentence each
  [[nodiscard]] std::string sentence() const;
};

/// Treatment of parameters that carry a warning (a wrong motor type can destroy a motor).
enum class Warned : std::uint8_t { write, leave_out };

/// Writes the differing values, reads back, compares. Does not store them in the controller: the user
/// decides.
Task<Result<RestoreReport>> restore_backup(std::shared_ptr<Session> session, Backup backup,
                                           std::string file_name, Warned warned);

}  // namespace hw
