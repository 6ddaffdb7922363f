// Replies. In AA and AM values are in the order of the axes, separated by commas (decision M02).
#include <cmath>
#include <cstdio>
#include <string>

#include "core/devices/vme58/emulator_board.h"

namespace hw::vme58 {
namespace {

// Decision M01.
constexpr std::string_view frame = "\n\r", status_frame = "\n\r\r";

/// With the quirk `padded`: blanks, sign and leading zeros, as other firmware prints them (decision M99).
std::string padded(std::string number) {
  const bool minus = number.front() == '-';
  return (minus ? "  -000" : "  +000") + number.substr(minus ? 1 : 0);
}

std::string rounded(double value) { return std::to_string(std::llround(value)); }

std::string lines_in_hex(unsigned lines) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "%04X", lines & 0xFFFFu);
  return text.data();
}

}  // namespace

void Board::answer(const Command& c) {
  const auto list = [](unsigned axes, std::string_view between, auto value_of) {
    std::string text;
    each_axis(axes, [&](int a) {
      if (!text.empty()) text += between;
      text += value_of(a);
    });
    return text;
  };
  const auto number = [this](std::string plain) {
    return make_.padded ? padded(std::move(plain)) : std::move(plain);
  };
  const auto values = [&](auto value_of) {
    return list(context_axes(), ",", [&](int a) { return number(value_of(a)); });
  };
  const auto status = [this](int a) { return axis_status(a); };
  std::string text;
  std::string_view around = frame;
  switch (c.op()) {
    case Op::WY: text = "VME58 ver " + make_.firmware + "-" + std::string(variant_->name); break;
    case Op::RP: text = values([this](int a) { return std::to_string(motion_.position(a)); }); break;
    case Op::RE: text = values([this](int a) { return std::to_string(motion_.encoder(a)); }); break;
    case Op::RC: text = values([this](int a) { return rounded(motion_.settings(a).acceleration); }); break;
    case Op::RV: text = values([this](int a) { return rounded(motion_.velocity(a)); }); break;
    case Op::RU: text = values([this](int a) { return user_position(a); }); break;
    case Op::RQ:
      text = number(std::to_string(recorder_.on() ? make_.contour_size - recorder_.entries()
                                                  : tasks_[ix(context_)].queue.room()));
      break;
    case Op::BX: text = number(lines_in_hex(io_.levels())); break;
    case Op::RB: text = number(lines_in_hex(io_.outputs())); break;
    case Op::RL:
      text = list(fitted_, "", [this](int a) { return (flags_.slip() >> a & 1u) != 0 ? "S" : "N"; });
      break;
    case Op::RA:
    case Op::QA: text = axis_status(context_), around = status_frame; break;
    case Op::RI:
    case Op::QI: text = list(fitted_, ",", status), around = status_frame; break;
    case Op::EA: text = encoder_status(context_), around = status_frame; break;
    default: return;
  }
  if (c.op() == Op::RA) flags_.clear_done(context_axes());
  if (c.op() == Op::RI) flags_.clear_done(fitted_);
  replies_ += around;
  replies_ += text;
  replies_ += around;
}

/// Direction, done, limit, home (decision M91).
std::string Board::axis_status(int axis) const {
  return {motion_.direction(axis) == Sign::plus ? 'P' : 'M',
          (flags_.done_letters() >> axis & 1u) != 0 ? 'D' : 'N', motion_.limit_active(axis) ? 'L' : 'N',
          motion_.home_active(axis) ? 'H' : 'N'};
}

/// Slip detection, holding, slipped, in the band, at home (decision M04).
std::string Board::encoder_status(int axis) const {
  const AxisSettings& s = motion_.settings(axis);
  return {s.slip_tolerance > 0 ? 'E' : 'D',
          s.holding ? 'E' : 'D',
          (flags_.slip() >> axis & 1u) != 0 ? 'S' : 'N',
          motion_.in_position(axis) ? 'P' : 'N',
          motion_.encoder_home_active(axis) ? 'H' : 'N',
          'N'};
}

/// Up to six decimals, at least one (decision M09).
std::string Board::user_position(int axis) const {
  const double unit = motion_.settings(axis).user_unit;
  const auto counts = static_cast<double>(motion_.position(axis));
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(), "%.6f", unit == 0 ? counts : counts / unit);
  std::string shown = text.data();
  while (shown.back() == '0' && shown[shown.size() - 2] != '.') shown.pop_back();
  return shown == "-0.0" ? "0.0" : shown;
}

}  // namespace hw::vme58
