#include "core/devices/vme58/contour_reading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {
namespace {

namespace seq = sequence;  // its names are also those of commands
using Place = std::array<double, 2>;

class ContourReader {
 public:
  ContourReader(std::span<const TextCommand> commands, const ReadText& frame, const Catalog& catalog)
      : commands_(commands), frame_(frame), catalog_(catalog) {}

  std::optional<ContourRead> run() {
    if (!next(Op::CV) || !commands_[0].numbers[0] || !next(Op::CD) || !find_plane(commands_[1]))
      return std::nullopt;
    const auto begin = places(commands_[1]);
    if (!begin) return std::nullopt;
    ContourRead read;
    seq::Contour& contour = read.contour;
    contour.plane = plane_;
    contour.own = seq::Speeds{*commands_[0].numbers[0] / per_unit(0)};
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
  /// Finds the two axes that `command` gives a place, in the order of the blocks' axes.
  bool find_plane(const TextCommand& command) {
    std::vector<std::pair<int, int>> found;  // place among the blocks' axes, place on the board
    for (std::size_t n = 0; n < command.numbers.size(); ++n)
      if (command.numbers[n])
        found.emplace_back(frame_.place_of(catalog_, static_cast<int>(n)), static_cast<int>(n));
    if (found.size() != 2) return false;
    std::sort(found.begin(), found.end());
    plane_ = {found[0].first, found[1].first};
    axes_ = {found[0].second, found[1].second};
    return plane_.right >= 0;
  }
  [[nodiscard]] double per_unit(std::size_t i) const {
    return frame_.axes[ix(i == 0 ? plane_.right : plane_.up)].per_unit;
  }
  /// The places of the two axes; none: others are given, or one is missing.
  [[nodiscard]] std::optional<Place> places(const TextCommand& command) const {
    Place p{};
    for (const std::size_t a : {0u, 1u}) {
      const auto place = static_cast<std::size_t>(axes_[a]);
      if (command.given() != 2 || place >= command.numbers.size() || !command.numbers[place])
        return std::nullopt;
      p[a] = *command.numbers[place] / per_unit(a);
    }
    return p;
  }
  /// Inside a contour the numbers belong to the two axes in their order.
  [[nodiscard]] std::optional<Place> pair(const TextCommand& command) const {
    if (command.numbers.size() < 2 || !command.numbers[0] || !command.numbers[1]) return std::nullopt;
    const std::size_t first = turned() ? 1 : 0;
    return Place{*command.numbers[first] / per_unit(0), *command.numbers[1 - first] / per_unit(1)};
  }
  [[nodiscard]] bool turned() const { return axes_[0] > axes_[1]; }
  [[nodiscard]] std::optional<seq::Step::Body> piece(const TextCommand& command) const {
    if (!command.fact || !command.flaw.empty()) return std::nullopt;
    switch (command.fact->op) {
      case Op::contour_MT: {
        const auto to = pair(command);
        if (!to || command.numbers.size() != 2) return std::nullopt;
        seq::Move move;
        move.to[ix(plane_.right)] = (*to)[0], move.to[ix(plane_.up)] = (*to)[1];
        return move;
      }
      case Op::CR: {
        const auto centre = pair(command);
        if (!centre || command.numbers.size() != 3 || !command.numbers[2]) return std::nullopt;
        return seq::Arc{
            (*centre)[0], (*centre)[1], degrees(*command.numbers[2] * (turned() ? -1 : 1)), {}, plane_};
      }
      case Op::contour_AN:
      case Op::contour_AF:
        if (command.numbers.size() != 1 || !command.numbers[0]) return std::nullopt;
        return seq::Output{first_auxiliary + static_cast<int>(*command.numbers[0]),
                           command.is(Op::contour_AN), 0};
      default: return std::nullopt;
    }
  }
  /// The angle, rounded to the fewest digits that give the same command.
  static double degrees(double radians) {
    const double exact = radians / std::numbers::pi * 180, round = std::round(exact * 1e5) / 1e5;
    return fmt::format("{:.9f}", round / 180 * std::numbers::pi) == fmt::format("{:.9f}", radians) ? round
                                                                                                   : exact;
  }

  std::span<const TextCommand> commands_;
  const ReadText& frame_;
  const Catalog& catalog_;
  seq::Plane plane_;
  std::array<int, 2> axes_{-1, -1};  ///< its two axes on the board
  std::size_t at_ = 0;
};

}  // namespace

std::optional<ContourRead> read_contour(std::span<const TextCommand> commands, const ReadText& frame,
                                        const Catalog& catalog) {
  return ContourReader(commands, frame, catalog).run();
}

}  // namespace hw::vme58
