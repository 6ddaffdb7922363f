#include "core/devices/vme58/contour_reading.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {
namespace {

namespace seq = sequence;  // its names are those of commands too
using Place = std::array<double, 2>;

class ContourReader {
 public:
  ContourReader(std::span<const TextCommand> commands, const ReadText& frame, const Catalog& catalog)
      : commands_(commands), frame_(frame) {
    for (const std::size_t a : {0u, 1u})
      if (a < frame.axes.size()) axes_[a] = catalog.find_axis(frame.axes[a].name);
  }

  std::optional<ContourRead> run() {
    if (axes_[0] < 0 || axes_[1] < 0 || !next(Op::CV) || !commands_[0].numbers[0]) return std::nullopt;
    ContourRead read;
    seq::Contour& contour = read.contour;
    contour.own = seq::Speeds{*commands_[0].numbers[0] / frame_.axes[0].per_unit};
    const auto begin = next(Op::CD) ? places(commands_[at_ - 1]) : std::nullopt;
    if (!begin) return std::nullopt;
    contour.x = (*begin)[0], contour.y = (*begin)[1];
    while (at_ < commands_.size() && !commands_[at_].is(Op::CE) && !commands_[at_].is(Op::CK)) {
      auto step = piece(commands_[at_++]);
      if (!step) return std::nullopt;
      contour.steps.push_back({std::move(*step)});
    }
    if (at_ == commands_.size()) return std::nullopt;
    contour.ends_ramped = commands_[at_++].is(Op::CE);
    const auto way_there = next(Op::MT) ? places(commands_[at_ - 1]) : std::nullopt;
    if (!way_there || !next(Op::GO) || !next(Op::CX)) return std::nullopt;
    contour.lead_in = std::hypot((*begin)[0] - (*way_there)[0], (*begin)[1] - (*way_there)[1]);
    read.length = at_;
    return read;
  }

 private:
  bool next(Op op) {
    return at_ < commands_.size() && commands_[at_].is(op) && commands_[at_++].flaw.empty();
  }
  /// Of the two axes, and no others.
  [[nodiscard]] std::optional<Place> places(const TextCommand& command) const {
    Place p{};
    for (const std::size_t a : {0u, 1u}) {
      const auto place = static_cast<std::size_t>(axes_[a]);
      if (command.given() != 2 || place >= command.numbers.size() || !command.numbers[place])
        return std::nullopt;
      p[a] = *command.numbers[place] / frame_.axes[a].per_unit;
    }
    return p;
  }
  /// Inside of it the numbers are of the two axes in their order.
  [[nodiscard]] std::optional<Place> pair(const TextCommand& command) const {
    if (command.numbers.size() < 2 || !command.numbers[0] || !command.numbers[1]) return std::nullopt;
    const std::size_t first = turned() ? 1 : 0;
    return Place{*command.numbers[first] / frame_.axes[0].per_unit,
                 *command.numbers[1 - first] / frame_.axes[1].per_unit};
  }
  [[nodiscard]] bool turned() const { return axes_[0] > axes_[1]; }
  [[nodiscard]] std::optional<seq::Step::Body> piece(const TextCommand& command) const {
    if (!command.fact || !command.flaw.empty()) return std::nullopt;
    switch (command.fact->op) {
      case Op::contour_MT: {
        const auto to = pair(command);
        if (!to || command.numbers.size() != 2) return std::nullopt;
        seq::Move move;
        move.to[0] = (*to)[0], move.to[1] = (*to)[1];
        return move;
      }
      case Op::CR: {
        const auto centre = pair(command);
        if (!centre || command.numbers.size() != 3 || !command.numbers[2]) return std::nullopt;
        return seq::Arc{(*centre)[0], (*centre)[1], degrees(*command.numbers[2] * (turned() ? -1 : 1)), {}};
      }
      case Op::contour_AN:
      case Op::contour_AF:
        if (command.numbers.size() != 1 || !command.numbers[0]) return std::nullopt;
        return seq::Output{first_auxiliary + static_cast<int>(*command.numbers[0]),
                           command.is(Op::contour_AN), 0};
      default: return std::nullopt;
    }
  }
  /// As few digits as are the same command.
  static double degrees(double radians) {
    const double exact = radians / std::numbers::pi * 180, round = std::round(exact * 1e5) / 1e5;
    return fmt::format("{:.9f}", round / 180 * std::numbers::pi) == fmt::format("{:.9f}", radians) ? round
                                                                                                   : exact;
  }

  std::span<const TextCommand> commands_;
  const ReadText& frame_;
  std::array<int, 2> axes_{-1, -1};
  std::size_t at_ = 0;
};

}  // namespace

std::optional<ContourRead> read_contour(std::span<const TextCommand> commands, const ReadText& frame,
                                        const Catalog& catalog) {
  return ContourReader(commands, frame, catalog).run();
}

}  // namespace hw::vme58
