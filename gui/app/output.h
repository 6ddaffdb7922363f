#pragma once
// The program's output to a shell: results go to stdout, everything else to stderr. All output goes through
// here, so that no result is lost silently. A call returns when the output has left the program; the reader
// of a pipe sees it at once.
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/base/result.h"

namespace hw::app {

/// Writes a result to stdout. Returns false when writing failed (a pipe without a reader, a full disk).
/// Nothing is written from then on, and the program ends with status 1: see output_loss().
bool write_result(std::string_view text);
template <class... T>
bool print_result(fmt::format_string<T...> format, T&&... values) {
  return write_result(fmt::format(format, std::forward<T>(values)...));
}

/// Whether a result could not be written.
[[nodiscard]] bool output_is_lost();
/// Why a result could not be written. The caller reports it.
[[nodiscard]] Fault output_loss();
/// Whether the loss was reported.
[[nodiscard]] bool output_loss_is_reported();

/// As RunOptions::print.
Result<> print_of_script(std::string_view text);

/// Calls `act`, on the writing thread, when the first result cannot be written during the object's lifetime.
/// One object at a time.
class OutputWatch {
 public:
  explicit OutputWatch(std::function<void()> act);
  ~OutputWatch();
  OutputWatch(const OutputWatch&) = delete;
  OutputWatch& operator=(const OutputWatch&) = delete;
};

/// Writes a line to stderr, with control characters written out. A failure to write it is ignored.
void write_aside(std::string_view line);

}  // namespace hw::app
