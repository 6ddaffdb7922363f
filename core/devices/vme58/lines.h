#pragma once
// General lines and auxiliary outputs, by the maker's numbers. In the maker's terms, on is low for a general
// line (BL) and high for an auxiliary output (AN).
#include <map>

#include "core/device/intent.h"
#include "core/device/tool_off.h"
#include "core/devices/vme58/commands.h"

namespace hw::vme58 {

class Lines {
 public:
  Lines(Wire& wire, Readings& readings, const Selection& selection, Commands& commands,
        const Catalog& catalog, Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        selection_(selection),
        commands_(commands),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// Takes the directions that RB reports: bit per line that is an output. The lines are shown as the address
  /// declares them; warns if the board differs.
  void take_directions(unsigned outputs);
  /// Takes the levels: bit per line that is high.
  void take(std::uint16_t levels);
  Task<Result<>> set(intent::SetOutput request);
  /// Uses the queue of an axis at rest: in another the command would wait for the end of the motion.
  Task<Result<>> switch_tool_off(ToolOff tool);
  /// Notes the state of an auxiliary output, which the window does not show.
  void know_auxiliary(int axis, bool on);
  /// The output may be switched at any time: its state is unknown.
  void doubt_auxiliary(int axis);
  /// A program switches the output when the command's turn in a queue, or its place on a contour, comes. Its
  /// state is unknown until the program has ended.
  void queue_auxiliary(int axis, bool on);
  /// `whole`: all of the program was carried out, so the outputs are as it last switched them.
  void program_ended(bool whole);
  void as_from_factory();

 private:
  [[nodiscard]] std::string through_free_queue(std::string text) const;
  Task<Result<>> set_auxiliary(int axis, bool on, std::uint32_t mask);
  Task<Result<>> set_line(int line, bool on, std::uint32_t mask);

  Wire& wire_;
  Readings& readings_;
  const Selection& selection_;
  Commands& commands_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
  unsigned directions_ = factory_outputs;
  std::map<int, bool> queued_;  ///< auxiliary outputs, as the program that runs leaves them
};

}  // namespace hw::vme58
