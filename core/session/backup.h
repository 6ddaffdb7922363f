#pragma once
// A whole controller into one file and back. Io thread.
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
  std::vector<std::string> left_out;  ///< what the file says and the controller cannot hold, a sentence each
  std::vector<std::string> warnings;  ///< of parameters that carry one and differ, a sentence each
  [[nodiscard]] std::string sentence() const;
};

/// What is done with parameters that carry a warning (a wrong motor type can destroy a motor).
enum class Warned : std::uint8_t { write, leave_out };

/// Writes what differs, reads back, compares. Stores nothing: that is the user's decision.
Task<Result<RestoreReport>> restore_backup(std::shared_ptr<Session> session, Backup backup,
                                           std::string file_name, Warned warned);

}  // namespace hw
