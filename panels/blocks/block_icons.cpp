#include "panels/blocks/block_icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "gui/widgets/icons.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

/// Draws on a grid of 12 x 12 centred at 0, 0, as for the icons of the console.
struct BlockPen {
  ImDrawList* list;
  ImVec2 centre;
  float unit;
  ImU32 colour;

  [[nodiscard]] ImVec2 at(float x, float y) const { return ImVec2(centre.x + x * unit, centre.y + y * unit); }
  void path(std::initializer_list<ImVec2> points, float w = 1.5f, bool closed = false) const {
    for (const ImVec2 p : points) list->PathLineTo(at(p.x, p.y));
    list->PathStroke(colour, closed ? ImDrawFlags_Closed : ImDrawFlags_None, w * unit);
  }
  /// Angles in degrees, clockwise from the right.
  void arc(float x, float y, float r, float from, float to, float w = 1.5f) const {
    constexpr float radian = std::numbers::pi_v<float> / 180;
    list->PathArcTo(at(x, y), r * unit, from * radian, to * radian, 16);
    list->PathStroke(colour, ImDrawFlags_None, w * unit);
  }
  void disc(float x, float y, float r) const { list->AddCircleFilled(at(x, y), r * unit, colour); }
  void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const {
    list->AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour);
  }
};

using V = ImVec2;

/// Icons that are icons of the console too.
struct IconOf {
  Icon operator()(const seq::Move& m) const { return m.relative ? Icon::plus : Icon::arrow_right; }
  Icon operator()(const seq::Home& h) const {
    return h.direction == Sign::plus ? Icon::home_plus : Icon::home_minus;
  }
  Icon operator()(const seq::Arc& a) const { return std::fabs(a.degrees) == 360 ? Icon::ring : Icon::none; }
  Icon operator()(const seq::Jog& j) const { return j.direction == Sign::plus ? Icon::play : Icon::back; }
  Icon operator()(const seq::Stop&) const { return Icon::stop; }
  Icon operator()(const seq::WaitMotion&) const { return Icon::pause; }
  Icon operator()(const seq::Delay&) const { return Icon::clock; }
  Icon operator()(const seq::MoveOnInput&) const { return Icon::play_outline; }
  Icon operator()(const seq::Enable&) const { return Icon::disc; }
  Icon operator()(const seq::Custom&) const { return Icon::file; }
  template <class Other>
  Icon operator()(const Other&) const {
    return Icon::none;
  }
};

/// Icons that only blocks have.
struct DrawOwn {
  const BlockPen& p;

  void operator()(const seq::Speed&) const {  // a dial
    p.arc(0, 1, 5, 150, 390), p.path({V(0, 1), V(2.5f, -2)});
  }
  void operator()(const seq::Arc&) const { p.arc(5, 5, 9.5f, 180, 270), p.disc(-4.5f, 4.5f, 1.5f); }
  void operator()(const seq::WaitInput&) const {  // arrow into a box
    p.path({V(0, -4.5f), V(4.5f, -4.5f), V(4.5f, 4.5f), V(0, 4.5f)});
    p.path({V(-5.5f, 0), V(1.5f, 0)}), p.path({V(-1, -2.5f), V(1.5f, 0), V(-1, 2.5f)});
  }
  void operator()(const seq::Output&) const {  // arrow out of a box
    p.path({V(0, -4.5f), V(-4.5f, -4.5f), V(-4.5f, 4.5f), V(0, 4.5f)});
    p.path({V(-2, 0), V(5.5f, 0)}), p.path({V(3, -2.5f), V(5.5f, 0), V(3, 2.5f)});
  }
  void operator()(const seq::Pen&) const {
    p.path({V(-5, 5), V(-4, 1.5f), V(2.5f, -5), V(5, -2.5f), V(-1.5f, 4)}, 1.25f, true);
  }
  void operator()(const seq::Comment&) const {
    p.path({V(-4.5f, -4), V(4.5f, -4)}), p.path({V(0, -4), V(0, 5)});
  }
  void operator()(const seq::Repeat&) const {
    p.arc(0, 0.5f, 4.5f, -40, 230), p.triangle(V(1, -5.5f), V(6, -4), V(2.5f, -0.5f));
  }
  void operator()(const seq::Contour&) const {
    p.path({V(-5, 4), V(-2, -3), V(2, 2), V(5, -4)}), p.disc(-5, 4, 1.25f);
  }
  void operator()(const seq::SpeedStairs&) const {
    p.path({V(-5.5f, 4), V(-2, 4), V(-2, 0), V(2, 0), V(2, -4), V(5.5f, -4)});
  }
  template <class Other>
  void operator()(const Other&) const {}
};

}  // namespace

void draw_block_icon(ImDrawList* list, const seq::Step::Body& body, ImVec2 centre, float size, ImU32 colour) {
  if (const Icon icon = std::visit(IconOf(), body); icon != Icon::none)
    return draw_icon(list, icon, centre, size, colour);
  const BlockPen pen{list, centre, size / 12, colour};
  std::visit(DrawOwn{pen}, body);
}

}  // namespace hw::panels
