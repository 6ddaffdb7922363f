#include "gui/app/output.h"

#include <cerrno>

#include <unistd.h>

#include "core/base/shown_text.h"
#include "core/session/user_files.h"

namespace hw::app {
namespace {

// A process has one stdout.
int lost_by = 0;  // errno; 0: everything was written
bool loss_reported = false;
std::function<void()> when_output_is_lost;

std::string why_lost() {
  switch (lost_by) {
    case EPIPE: return "nobody reads the other end of the pipe";
    case EBADF: return "it is closed";
    default: return reason_of(lost_by);
  }
}

}  // namespace

bool write_result(std::string_view text) {
  if (lost_by != 0) return false;
  lost_by = write_all(STDOUT_FILENO, text);
  if (lost_by == 0) return true;
  if (const auto act = std::exchange(when_output_is_lost, nullptr)) act();
  return false;
}

bool output_is_lost() { return lost_by != 0; }
bool output_loss_is_reported() { return loss_reported; }

Fault output_loss() {
  loss_reported = true;
  return Fault(FaultKind::port, fmt::format("The output cannot be written: {}.", why_lost()));
}

Result<> print_of_script(std::string_view text) {
  if (write_result(text)) return {};
  return fail(output_loss());
}

OutputWatch::OutputWatch(std::function<void()> act) { when_output_is_lost = std::move(act); }
OutputWatch::~OutputWatch() { when_output_is_lost = nullptr; }

void write_aside(std::string_view line) {
  const std::string whole = shown_text(line, std::string_view::npos, LineEnds::kept) + "\n";
  static_cast<void>(write_all(STDERR_FILENO, whole));
}

}  // namespace hw::app
