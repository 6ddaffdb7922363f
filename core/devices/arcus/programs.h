#pragma once
// Stored programs: compiled here and loaded, read back; run, paused, continued by thread.
#include <string>
#include <vector>

#include "core/devices/arcus/language/dialect.h"
#include "core/devices/arcus/language/program.h"
#include "core/devices/arcus/stored_lines.h"

namespace hw::arcus {

class Programs {
 public:
  Programs(const Console& console, const language::Dialect& dialect, Conversation& conversation,
           CodeAtWork& code, MotionStatus& status, Threads& threads, StoredLines& stored)
      : console_(console),
        dialect_(dialect),
        conversation_(conversation),
        code_(code),
        status_(status),
        threads_(threads),
        stored_(stored) {}

  /// Carries out program intents; refuses all others.
  Task<Result<>> perform(IntentBody body);

 private:
  Task<Result<>> load(int program, std::string text);
  Task<Result<>> may_be_program(int program, const language::Program& code);
  void note_stored(const std::vector<std::string>& lines);
  Task<Result<>> upload(int program);
  Task<Result<>> run(int program);
  Task<Result<>> control(int thread, int what);
  void has_run(int thread);
  Task<Result<>> control_all(int thread, int what);

  const Console& console_;
  const language::Dialect& dialect_;
  Conversation& conversation_;
  CodeAtWork& code_;
  MotionStatus& status_;
  Threads& threads_;
  StoredLines& stored_;
};

}  // namespace hw::arcus
