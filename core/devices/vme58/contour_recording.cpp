#include "core/devices/vme58/contour_recording.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/devices/vme58/catalog.h"

namespace hw::vme58 {
namespace {

namespace seq = sequence;  // its names are also those of commands
using Point = std::array<double, 2>;

// Inside a contour operands belong to its axes in order (decision M68), outside to places. The first axis of
// a contour is the first in board order, so a contour with swapped axes is written mirrored.
class Recorder {
 public:
  Recorder(SequenceDraft& draft, const seq::Contour& contour)
      : draft_(draft), contour_(contour), axes_{contour.plane.right, contour.plane.up} {}

  Result<ContourRecording> run() {
    if (!draft_.has(contour_.plane)) return draft_.refuse_single_axis("a contour");
    turned_ = draft_.axis(axes_[0]) > draft_.axis(axes_[1]);
    if (auto begun = begin(); !begun) return fail(begun.error());
    for (std::size_t i = 0; i < contour_.steps.size(); ++i) {
      draft_.enter(contour_.steps[i], i);
      if (auto put = contour_.steps[i].skipped ? Result<>() : piece(contour_.steps[i]); !put)
        return fail(put.error());
      draft_.leave();
    }
    if (!direction_) return draft_.refuse("the contour has no line and no arc.");
    if (entries_ > draft_.catalog.contour_size)
      return draft_.refuse(
          fmt::format("it has {} entries, and the board holds {}.", entries_, draft_.catalog.contour_size));
    draft_.line(contour_.ends_ramped ? "CE" : "CK");
    made_.way_there.to[ix(axes_[0])] = contour_.x - contour_.lead_in * (*direction_)[0];
    made_.way_there.to[ix(axes_[1])] = contour_.y - contour_.lead_in * (*direction_)[1];
    for (const std::size_t i : {0u, 1u}) made_.end[i] = std::llround(here_[i]);
    return std::move(made_);
  }

 private:
  Result<> begin() {
    const auto speeds = draft_.speeds_of(axes_[0], contour_.own);
    if (!speeds) return fail(speeds.error());
    if (speeds->high == 0) return draft_.refuse("put a speed step before the contour: it needs a speed.");
    const auto at = point(contour_.x, contour_.y);
    if (!at) return fail(at.error());
    here_ = *at;
    std::string places;
    for (int place = 0; place <= std::max(draft_.axis(axes_[0]).index, draft_.axis(axes_[1]).index);
         ++place) {
      if (place > 0) places += ',';
      for (const std::size_t i : {0u, 1u})
        if (draft_.axis(axes_[i]).index == place) places += fmt::format("{:.0f}", here_[i]);
    }
    draft_.lines(fmt::format("CV{};\nCD{};", speeds->high, places));
    return {};
  }
  Result<> piece(const seq::Step& step) {
    if (const auto* move = std::get_if<seq::Move>(&step.body)) return line(*move);
    if (const auto* round = std::get_if<seq::Arc>(&step.body)) return arc(*round);
    if (const auto* switched = std::get_if<seq::Output>(&step.body)) return output(*switched);
    return draft_.refuse_in_contour();
  }
  Result<> line(const seq::Move& m) {
    if (m.relative) return draft_.refuse("moves of a contour are absolute.");
    for (int a = 0; a < draft_.axis_count(); ++a)
      if (m.to[ix(a)] && a != axes_[0] && a != axes_[1])
        return draft_.refuse(
            fmt::format("the contour lies in {}, and no other axis can move in it.", plane()));
    const auto to = point(m.to[ix(axes_[0])].value_or(unit(0)), m.to[ix(axes_[1])].value_or(unit(1)));
    if (!to) return fail(to.error());
    const double dx = (*to)[0] - here_[0], dy = (*to)[1] - here_[1], length = std::hypot(dx, dy);
    if (length == 0) return draft_.refuse("the line ends where it begins.");
    set_off({dx / length, dy / length});
    put("MT", pair(*to), 2);
    here_ = *to;
    return {};
  }
  Result<> arc(const seq::Arc& a) {
    if (a.plane != contour_.plane)
      return draft_.refuse(fmt::format("the contour lies in {}, and its arcs must lie there too.", plane()));
    if (!draft_.alike(a.plane))
      return draft_.refuse("its axes differ in their counts per unit: the arc would be an ellipse.");
    const auto centre = point(a.x, a.y);
    if (!centre) return fail(centre.error());
    const double rx = here_[0] - (*centre)[0], ry = here_[1] - (*centre)[1], radius = std::hypot(rx, ry);
    if (radius == 0) return draft_.refuse("the centre of the arc is the point where it begins.");
    if (!(a.degrees != 0)) return draft_.refuse("the arc has an angle of 0 degrees.");
    const double sense = a.degrees > 0 ? 1 : -1, angle = a.degrees / 180 * std::numbers::pi;
    set_off({-sense * ry / radius, sense * rx / radius});
    put("CR", fmt::format("{},{:.9f}", pair(*centre), angle * (turned_ ? -1 : 1)), 3);
    const double end = std::atan2(ry, rx) + angle;
    here_ = {(*centre)[0] + radius * std::cos(end), (*centre)[1] + radius * std::sin(end)};
    return {};
  }
  Result<> output(const seq::Output& o) {
    const auto place = draft_.output(o.output);
    if (!place) return fail(place.error());
    const int port = o.output - first_auxiliary;
    if (port < 0)
      return draft_.refuse(
          fmt::format("{} cannot be switched within a contour: only the auxiliary outputs can.",
                      draft_.catalog.outputs[ix(*place)].name));
    put(o.on ? "AN" : "AF", std::to_string(port), 1);
    return {};
  }

  /// Adds a command: it takes one entry, and one more for each operand (decision M18).
  void put(std::string_view letters, std::string_view operands, int count) {
    draft_.line(fmt::format("{}{};", letters, operands));
    entries_ += 1 + count;
  }
  /// The present place on an axis of the contour, in units.
  [[nodiscard]] double unit(std::size_t i) const {
    return here_[i] / draft_.sequence.axes[ix(axes_[i])].per_unit;
  }
  [[nodiscard]] std::string plane() const {
    return fmt::format("{} and {}", draft_.name(axes_[0]), draft_.name(axes_[1]));
  }
  [[nodiscard]] Result<Point> point(double x, double y) const {
    const auto a = draft_.position(axes_[0], x), b = draft_.position(axes_[1], y);
    if (!a || !b) return fail(!a ? a.error() : b.error());
    return Point{static_cast<double>(*a), static_cast<double>(*b)};
  }
  [[nodiscard]] std::string pair(const Point& p) const {
    return turned_ ? fmt::format("{:.0f},{:.0f}", p[1], p[0]) : fmt::format("{:.0f},{:.0f}", p[0], p[1]);
  }
  void set_off(Point direction) {
    if (!direction_) direction_ = direction;
  }

  SequenceDraft& draft_;
  const seq::Contour& contour_;
  const std::array<int, 2> axes_;  ///< axes of its plane
  ContourRecording made_;
  Point here_{};
  std::optional<Point> direction_;
  int entries_ = 0;
  bool turned_ = false;
};

}  // namespace

Result<ContourRecording> record_contour(SequenceDraft& draft, const seq::Contour& contour) {
  return Recorder(draft, contour).run();
}

}  // namespace hw::vme58
