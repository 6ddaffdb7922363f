#include "core/devices/arcus/text_goals.h"

#include <cmath>
#include <numbers>

#include "core/base/index.h"
#include "core/device/sequence_travel.h"
#include "core/devices/arcus/codec.h"
#include "core/devices/arcus/facts.h"
#include "core/sequence/arc_shape.h"

namespace hw::arcus {
namespace {

AxisTarget target_at(int axis, Steps place) { return {AxisId{static_cast<std::uint8_t>(axis)}, place}; }

int axis_of(const Model& model, char letter) {
  const auto axis = model.axis_letters.find(letter);
  return axis == std::string_view::npos ? -1 : static_cast<int>(axis);
}

/// Takes the number at the front of `text` off it.
std::optional<std::int64_t> take_number(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of("+-0123456789"), text.size());
  const std::size_t begin = text.starts_with('+') ? 1 : 0;
  const auto number = decode_number(text.substr(begin, end - begin));
  if (number) text.remove_prefix(end);
  return number;
}

class CommandReader {
 public:
  CommandReader(const Forms& forms, std::optional<bool> incremental, const Snapshot& now)
      : forms_(forms), incremental_(incremental), now_(now) {}

  [[nodiscard]] std::vector<AxisTarget> places(std::string_view command) const {
    if (auto jogged = jog(command); !jogged.empty()) return jogged;
    if (command.starts_with('T')) return changed_target(command.substr(1));
    if (!incremental_) return {};
    if (auto moved = move(command); !moved.empty()) return moved;
    if (*incremental_ || forms_.model->axes() < 2) return {};
    if (command.starts_with('I')) return buffered_move(command.substr(1));
    if (command.starts_with("CIR") || command.starts_with("ARC")) return arc(command);
    return {};
  }

 private:
  [[nodiscard]] std::vector<AxisTarget> jog(std::string_view command) const {
    for (int axis = 0; axis < forms_.model->axes(); ++axis)
      for (const Sign sign : {Sign::minus, Sign::plus})
        if (command == fill(forms_, forms_.jog, axis, sign))
          return {target_at(axis, sign == Sign::plus ? without_end : Steps(0) - without_end)};
    return {};
  }
  /// TX1000, with one axis T1000: absolute in either mode (decision AMB-079).
  [[nodiscard]] std::vector<AxisTarget> changed_target(std::string_view words) const {
    const int axis = forms_.model->axes() == 1 ? 0 : words.empty() ? -1 : axis_of(*forms_.model, words[0]);
    if (axis < 0) return {};
    if (forms_.model->axes() > 1) words.remove_prefix(1);
    const auto number = take_number(words);
    if (!number || !words.empty()) return {};
    return {target_at(axis, Steps(*number))};
  }
  /// X1000Y-500
  [[nodiscard]] std::vector<AxisTarget> move(std::string_view command) const {
    std::vector<AxisTarget> places;
    while (!command.empty()) {
      const int axis = axis_of(*forms_.model, command.front());
      if (axis < 0) return {};
      command.remove_prefix(1);
      const auto number = take_number(command);
      const AxisState& state = now_.axes[axis];
      if (!number || (*incremental_ && (!state.position_known || !is_place(*number)))) return {};
      const Steps place = *incremental_ ? state.goal() + Steps(*number) : Steps(*number);
      if (*incremental_ && !is_place(place.value)) return {};
      places.push_back(target_at(axis, place));
    }
    return places;
  }
  /// Ix:y:z:speed
  [[nodiscard]] static std::vector<AxisTarget> buffered_move(std::string_view numbers) {
    const auto all = decode_numbers(numbers, 4);
    if (!all) return {};
    return {target_at(0, Steps((*all)[0])), target_at(1, Steps((*all)[1])), target_at(2, Steps((*all)[2]))};
  }
  static bool is_place(std::int64_t number) { return number >= position_min && number <= position_max; }
  /// CIRPx:y and ARCPx:y:end:sweep turn clockwise, CIRN and ARCN counterclockwise.
  [[nodiscard]] std::vector<AxisTarget> arc(std::string_view command) const {
    const bool whole = command.starts_with("CIR");
    if (command.size() < 4 || (command[3] != 'P' && command[3] != 'N')) return {};
    const auto numbers = decode_numbers(command.substr(4), whole ? 2 : 4);
    if (!numbers || !now_.axes[0].position_known || !now_.axes[1].position_known) return {};
    if (!is_place((*numbers)[0]) || !is_place((*numbers)[1])) return {};
    const double sweep = whole ? 360 : static_cast<double>((*numbers)[3]) / 1000;
    std::vector<AxisTarget> places = reach((*numbers)[0], (*numbers)[1], command[3] == 'P' ? -sweep : sweep);
    if (whole) return places;
    // Which of the two counts when they disagree is a guess (decision AMB-066).
    const double turn = to_end((*numbers)[0], (*numbers)[1], command[3] == 'P', (*numbers)[2]);
    if (std::abs(std::remainder(turn - sweep, 360)) < 1) return places;
    for (const AxisTarget& place : reach((*numbers)[0], (*numbers)[1], command[3] == 'P' ? -turn : turn))
      places.push_back(place);
    return places;
  }
  [[nodiscard]] double from(int axis, std::int64_t centre) const {
    return static_cast<double>(now_.axes[axis].commanded().value - centre);
  }
  /// Degrees from here to the end angle, which counts from the minus X side, clockwise (decision AMB-063).
  [[nodiscard]] double to_end(std::int64_t x, std::int64_t y, bool clockwise, std::int64_t end) const {
    const double start = std::atan2(from(1, y), -from(0, x)) * 180 / std::numbers::pi;
    const double way = static_cast<double>(end) / 1000 - start;
    const double turn = std::fmod(clockwise ? way : -way, 360);
    return turn < 0 ? turn + 360 : turn;
  }
  [[nodiscard]] std::vector<AxisTarget> reach(std::int64_t x, std::int64_t y, double degrees) const {
    const sequence::Arc shape{static_cast<double>(x), static_cast<double>(y), degrees};
    const sequence::ArcReach all =
        sequence::reach_of(shape, static_cast<double>(now_.axes[0].commanded().value),
                           static_cast<double>(now_.axes[1].commanded().value));
    const auto place = [](int axis, double where) { return target_at(axis, Steps(std::llround(where))); };
    return {place(0, all.left), place(0, all.right), place(1, all.below), place(1, all.above)};
  }

  const Forms& forms_;
  const std::optional<bool> incremental_;
  const Snapshot& now_;
};

}  // namespace

TextGoals goals_of(const Forms& forms, std::string_view text, int own, std::optional<bool> incremental,
                   const Snapshot& now) {
  const int to = address_of(text);
  if (to >= 0 && to != own && to != forms.model->broadcast) return {};
  const std::string command = command_in(text);
  TextGoals goals;
  goals.places = CommandReader(forms, incremental, now).places(command);
  // The console reads a program as one that begins in absolute mode.
  const auto program = thread_named_in(command);
  const bool starts = program && command.substr(command.find('=') + 1) == "1";
  if (starts && incremental == false) goals.runs = *program;
  return goals;
}

}  // namespace hw::arcus
