#pragma once
// General lines and auxiliary outputs, by the maker's numbers. On is low for a general line (BL), and high
// for an auxiliary one (AN): the maker's own words.
#include "core/device/intent.h"
#include "core/device/tool_off.h"
#include "core/devices/vme58/commands.h"

namespace hw::vme58 {

class Lines {
 public:
  Lines(Wire& wire, Readings& readings, const Selection& selection, Commands& commands,
        const Catalog& catalog, Snapshot& draft)
      : wire_(wire),
        readings_(readings),
        selection_(selection),
        commands_(commands),
        catalog_(catalog),
        draft_(draft) {}

  /// What RB tells: bit per line that is an output. They are shown in the directions that the address tells;
  /// another board says so.
  void go_these_ways(unsigned outputs);
  /// Bit per line that is high.
  void take(std::uint16_t levels);
  Task<Result<>> set(intent::SetOutput wish);
  /// Through the queue of an axis that rests: elsewhere it would wait for the end of the motion.
  Task<Result<>> switch_tool_off(ToolOff tool);
  /// The auxiliary output of an axis: nothing in the window tells of it.
  void know_auxiliary(int axis, bool on);
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
  Snapshot& draft_;
  unsigned directions_ = factory_outputs;
};

}  // namespace hw::vme58
