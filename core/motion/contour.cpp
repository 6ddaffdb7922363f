#include "core/motion/contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/profile.h"

namespace hw::motion {
namespace {

constexpr auto fine = static_cast<double>(Contour::steps_per_count);

std::int64_t step_at(double s) { return static_cast<std::int64_t>(std::ceil(s * fine - 1e-6)); }

}  // namespace

Contour::Contour(const Offsets& start) : start_(start) {
  for (std::size_t a = 0; a < path_axes; ++a) end_[a] = static_cast<double>(start[a]);
}

double Contour::Piece::at(std::size_t axis, double s) const {
  if (!arc) return from[axis] + way[axis] * s;
  if (axis == x) return centre_x + radius * std::cos(angle_at(s));
  return axis == y ? centre_y + radius * std::sin(angle_at(s)) : from[axis];
}

double Contour::Piece::share(std::size_t axis, double s) const {
  if (!arc) return way[axis];
  const double turn = sweep >= 0 ? 1 : -1;
  if (axis == x) return -turn * std::sin(angle_at(s));
  return axis == y ? turn * std::cos(angle_at(s)) : 0;
}

void Contour::add(Piece piece) {
  piece.begin = length_;
  length_ += piece.length;
  for (std::size_t a = 0; a < path_axes; ++a)
    end_[a] = piece.length > 0 ? piece.at(a, piece.length) : end_[a];
  pieces_.push_back(piece);
}

void Contour::line_to(const Point& to) {
  Piece p;
  p.from = end_;
  double squares = 0;
  for (std::size_t a = 0; a < path_axes; ++a) squares += (to[a] - end_[a]) * (to[a] - end_[a]);
  p.length = std::sqrt(squares);
  for (std::size_t a = 0; a < path_axes && p.length > 0; ++a) p.way[a] = (to[a] - end_[a]) / p.length;
  add(p);
  end_ = to;
}

void Contour::arc(std::size_t x_axis, std::size_t y_axis, double centre_x, double centre_y, double sweep) {
  Piece p;
  p.arc = true, p.from = end_, p.x = x_axis, p.y = y_axis, p.centre_x = centre_x, p.centre_y = centre_y;
  p.sweep = sweep;
  p.radius = std::hypot(end_[x_axis] - centre_x, end_[y_axis] - centre_y);
  p.angle = std::atan2(end_[y_axis] - centre_y, end_[x_axis] - centre_x);
  p.length = p.radius * std::abs(sweep);
  add(p);
}

void Contour::ray() {
  Piece p;
  p.from = end_;
  for (auto last = pieces_.rbegin(); last != pieces_.rend(); ++last) {
    if (last->length == 0) continue;
    for (std::size_t a = 0; a < path_axes; ++a) p.way[a] = last->share(a, last->length);
    break;
  }
  const Point end = end_;
  p.length = static_cast<double>(Profile::endless) / fine - length_;
  add(p);
  end_ = end, endless_ = true;
}

const Contour::Piece* Contour::piece_at(double s) const {
  const auto behind = std::upper_bound(pieces_.begin(), pieces_.end(), s,
                                       [](double at, const Piece& p) { return at < p.begin; });
  if (behind == pieces_.begin()) return nullptr;
  auto here = std::prev(behind);
  while (here->length == 0 && here != pieces_.begin()) --here;
  return here->length > 0 ? &*here : nullptr;
}

double Contour::along(std::int64_t step) const {
  return std::clamp(static_cast<double>(step) / fine, 0.0, length_);
}

std::int64_t Contour::steps() const { return endless_ ? Profile::endless : step_at(length_); }

std::int64_t Contour::end_of(std::size_t piece) const {
  return step_at(pieces_[piece].begin + pieces_[piece].length);
}

std::int64_t Contour::offset(std::size_t axis, std::int64_t step) const {
  const double s = along(step);
  const Piece* p = piece_at(s);
  return p == nullptr ? 0 : std::llround(p->at(axis, s - p->begin)) - start_[axis];
}

double Contour::exact(std::size_t axis, double step) const {
  const double s = std::clamp(step / fine, 0.0, length_);
  const Piece* p = piece_at(s);
  return p == nullptr ? 0 : p->at(axis, s - p->begin) - static_cast<double>(start_[axis]);
}

bool Contour::moves(std::size_t axis) const {
  return std::any_of(pieces_.begin(), pieces_.end(), [axis](const Piece& p) {
    return p.length > 0 && (p.arc ? axis == p.x || axis == p.y : p.way[axis] != 0);
  });
}

std::int64_t Contour::next_turn(std::int64_t step) const {
  const Piece* p = piece_at(along(step));
  while (p != nullptr && step_at(p->begin + p->length) <= step) p = p == &pieces_.back() ? nullptr : p + 1;
  if (p == nullptr) return steps();
  const std::int64_t end = std::min(step_at(p->begin + p->length), steps());
  if (!p->arc) return end;
  constexpr double quarter = std::numbers::pi / 2;
  const double way = p->sweep >= 0 ? 1 : -1;
  const double here = way * p->angle_at(std::max(along(step) - p->begin, 0.0));
  double next = (std::floor(here / quarter) + 1) * quarter;
  for (int i = 0; i < 3; ++i, next += quarter) {
    const double s = p->begin + (next - way * p->angle) / std::abs(p->sweep) * p->length;
    const std::int64_t turn = std::llround(s * fine);
    if (turn > step) return std::min(turn, end);
  }
  return end;
}

int Contour::direction(std::size_t axis, std::int64_t step) const {
  const std::int64_t ahead = offset(axis, next_turn(step)) - offset(axis, step);
  return ahead > 0 ? 1 : ahead < 0 ? -1 : 0;
}

std::optional<std::int64_t> Contour::first_at(std::size_t axis, std::int64_t step,
                                              std::int64_t wanted) const {
  const std::int64_t way = direction(axis, step);
  std::int64_t low = step, high = next_turn(step);
  if (way == 0 || way * offset(axis, high) < way * wanted) return std::nullopt;
  if (way * offset(axis, low) >= way * wanted) return std::min(low + 1, high);
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (way * offset(axis, middle) >= way * wanted ? high : low) = middle;
  }
  return high;
}

double Contour::share(std::size_t axis, double step) const {
  const double s = std::clamp(step / fine, 0.0, length_);
  const Piece* p = piece_at(s);
  return p == nullptr ? 0 : p->share(axis, s - p->begin);
}

}  // namespace hw::motion
