#include "gui/widgets/icons.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace hw::gui {
namespace {

/// Draws on a grid of 12 x 12 with its centre at 0, 0. Straight edges lie on whole pixels.
struct Pen {
  ImDrawList* list;
  ImVec2 centre;
  float unit;
  ImU32 colour;

  [[nodiscard]] float thickness(float w) const { return std::max(1.0f, std::floor(w * unit + 0.5f)); }
  [[nodiscard]] ImVec2 at(float x, float y) const { return ImVec2(centre.x + x * unit, centre.y + y * unit); }
  [[nodiscard]] static float whole(float v) { return std::floor(v + 0.5f); }
  void box(float x0, float y0, float x1, float y1) const {
    const ImVec2 a = at(x0, y0), b = at(x1, y1);
    list->AddRectFilled(ImVec2(whole(a.x), whole(a.y)), ImVec2(whole(b.x), whole(b.y)), colour);
  }
  void frame(float x0, float y0, float x1, float y1, float w) const {
    const ImVec2 a = at(x0, y0), b = at(x1, y1);
    const float t = thickness(w), in = (t - 1) * 0.5f;
    list->AddRect(ImVec2(whole(a.x) + in, whole(a.y) + in), ImVec2(whole(b.x) - in, whole(b.y) - in), colour,
                  0, 0, t);
  }
  void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const {
    list->AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour);
  }
  void path(std::initializer_list<ImVec2> points, float w, bool closed = false) const {
    for (ImVec2 p : points) list->PathLineTo(at(p.x, p.y));
    list->PathStroke(colour, closed ? ImDrawFlags_Closed : ImDrawFlags_None, w * unit);
  }
  void ring(float x, float y, float r, float w) const {
    list->AddCircle(at(x, y), r * unit, colour, 0, w * unit);
  }
  void disc(float x, float y, float r) const { list->AddCircleFilled(at(x, y), r * unit, colour); }
  /// An arrow to the side, behind half a circle.
  void turn_back(float side) const {
    constexpr float quarter = 1.5707963f;
    list->PathLineTo(at(5 * side, -1.5f));
    list->PathArcTo(at(-2 * side, 1.5f), 3 * unit, side < 0 ? -quarter : 3 * quarter, quarter);
    list->PathLineTo(at(side, 4.5f));
    list->PathStroke(colour, ImDrawFlags_None, 1.5f * unit);
    path({ImVec2(2 * side, -4.5f), ImVec2(5 * side, -1.5f), ImVec2(2 * side, 1.5f)}, 1.5f);
  }
};

using V = ImVec2;

bool draw_solid(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::play: p.triangle(V(-4, -4.5f), V(4.5f, 0), V(-4, 4.5f)); return true;
    case Icon::back: p.triangle(V(4, -4.5f), V(4, 4.5f), V(-4.5f, 0)); return true;
    case Icon::up: p.triangle(V(-4.5f, 4), V(0, -4.5f), V(4.5f, 4)); return true;
    case Icon::down: p.triangle(V(-4.5f, -4), V(4.5f, -4), V(0, 4.5f)); return true;
    case Icon::pause: p.box(-4, -5, -1, 5), p.box(1, -5, 4, 5); return true;
    case Icon::step: p.triangle(V(-5, -4.5f), V(2, 0), V(-5, 4.5f)), p.box(3, -5, 5, 5); return true;
    case Icon::stop: p.box(-5, -5, 5, 5); return true;
    case Icon::disc: p.disc(0, 0, 5); return true;
    case Icon::square_solid: p.box(-6, -6, 6, 6); return true;
    case Icon::limit_minus:
      p.box(-5.5f, -5, -3.5f, 5), p.triangle(V(5, -4.5f), V(5, 4.5f), V(-2.5f, 0));
      return true;
    case Icon::limit_plus:
      p.box(3.5f, -5, 5.5f, 5), p.triangle(V(-5, -4.5f), V(2.5f, 0), V(-5, 4.5f));
      return true;
    case Icon::warning: p.triangle(V(0, -5.5f), V(6, 5), V(-6, 5)); return true;
    case Icon::diamond_solid:
      p.list->AddQuadFilled(p.at(0, -6), p.at(6, 0), p.at(0, 6), p.at(-6, 0), p.colour);
      return true;
    case Icon::plug:
      p.box(-3, -5, -1, 5), p.box(-5.5f, -1, -3, 1);
      p.box(2, -5, 4, 5), p.box(4, -1, 6, 1);
      return true;
    default: return false;
  }
}

void draw_lines(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::play_outline: p.path({V(-3.5f, -4.5f), V(4, 0), V(-3.5f, 4.5f)}, 1.5f, true); break;
    case Icon::ring: p.ring(0, 0, 4.5f, 1.5f); break;
    case Icon::ring_dot: p.ring(0, 0, 5, 1.5f), p.disc(0, 0, 2); break;
    case Icon::square: p.frame(-6, -6, 6, 6, 1.5f); break;
    case Icon::home_minus:
      p.box(-5.5f, -5, -3.5f, 5);
      p.path({V(5, 0), V(-1.5f, 0)}, 1.5f), p.path({V(1.5f, -3), V(-1.5f, 0), V(1.5f, 3)}, 1.5f);
      break;
    case Icon::home_plus:
      p.box(3.5f, -5, 5.5f, 5);
      p.path({V(-5, 0), V(1.5f, 0)}, 1.5f), p.path({V(-1.5f, -3), V(1.5f, 0), V(-1.5f, 3)}, 1.5f);
      break;
    case Icon::cross: p.path({V(-4, -4), V(4, 4)}, 1.5f), p.path({V(-4, 4), V(4, -4)}, 1.5f); break;
    case Icon::check: p.path({V(-4.5f, 0.5f), V(-1.5f, 3.5f), V(4.5f, -3.5f)}, 1.75f); break;
    case Icon::clock: p.ring(0, 0, 5, 1.5f), p.path({V(0, -3), V(0, 0.5f), V(2.5f, 0.5f)}, 1.5f); break;
    case Icon::house:
      p.path({V(-5, 0), V(0, -4.5f), V(5, 0)}, 1.25f),
          p.path({V(-3.5f, -1), V(-3.5f, 4.5f), V(3.5f, 4.5f), V(3.5f, -1)}, 1.25f);
      break;
    case Icon::tally:
      for (const float x : {-3.0f, 0.0f, 3.0f}) p.path({V(x, -4), V(x, 4)}, 1.25f);
      p.path({V(-5, 2.5f), V(5, -2.5f)}, 1.25f);
      break;
    case Icon::hand:
      p.path({V(0, -5), V(0, 2)}, 1.5f), p.path({V(-3, -1), V(0, 2), V(3, -1)}, 1.5f),
          p.path({V(-4, 4.5f), V(4, 4.5f)}, 1.5f);
      break;
    case Icon::diamond: p.path({V(0, -5), V(5, 0), V(0, 5), V(-5, 0)}, 1.5f, true); break;
    case Icon::emulated:
      p.frame(-6, -6, 3, 3, 1.5f);
      p.path({V(5, -1.75f), V(5, 5), V(-2, 5)}, 1.5f);
      break;
    case Icon::info:
      p.ring(0, 0, 5, 1.25f), p.box(-0.75f, -0.5f, 0.75f, 3), p.box(-0.75f, -3, 0.75f, -1.5f);
      break;
    default: break;
  }
}

void draw_signs(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::chevron_down: p.path({V(-3.5f, -1.75f), V(0, 1.75f), V(3.5f, -1.75f)}, 1.5f); break;
    case Icon::chevron_up: p.path({V(-3.5f, 1.75f), V(0, -1.75f), V(3.5f, 1.75f)}, 1.5f); break;
    case Icon::chevron_left: p.path({V(1.75f, -3.5f), V(-1.75f, 0), V(1.75f, 3.5f)}, 1.5f); break;
    case Icon::chevron_right: p.path({V(-1.75f, -3.5f), V(1.75f, 0), V(-1.75f, 3.5f)}, 1.5f); break;
    case Icon::plus: p.box(-6, -0.75f, 6, 0.75f), p.box(-0.75f, -6, 0.75f, 6); break;
    case Icon::minus: p.box(-6, -0.75f, 6, 0.75f); break;
    case Icon::arrow_left:
      p.path({V(5, 0), V(-4.5f, 0)}, 1.5f), p.path({V(-1, -3.5f), V(-4.5f, 0), V(-1, 3.5f)}, 1.5f);
      break;
    case Icon::arrow_right:
      p.path({V(-5, 0), V(4.5f, 0)}, 1.5f), p.path({V(1, -3.5f), V(4.5f, 0), V(1, 3.5f)}, 1.5f);
      break;
    case Icon::enter:
      p.path({V(5, -4), V(5, 1), V(-4.5f, 1)}, 1.25f),
          p.path({V(-2, -1.5f), V(-4.5f, 1), V(-2, 3.5f)}, 1.25f);
      break;
    case Icon::prompt: p.path({V(-1.5f, -3), V(1.5f, 0), V(-1.5f, 3)}, 1.25f); break;
    case Icon::folder:
      p.path({V(-5.5f, 4.5f), V(-5.5f, -4.5f), V(-1.5f, -4.5f), V(0, -2.5f), V(5.5f, -2.5f), V(5.5f, 4.5f)},
             1.25f, true);
      break;
    case Icon::file:
      p.path({V(-4, 5.5f), V(-4, -5.5f), V(1, -5.5f), V(4, -2.5f), V(4, 5.5f)}, 1.25f, true);
      break;
    default: break;
  }
}

/// Icons for the tools of a list, where their words do not fit.
void draw_tool(const Pen& p, Icon icon) {
  switch (icon) {
    case Icon::copy: p.frame(-5, -6, 2, 2, 1.25f), p.path({V(5, -2), V(5, 5.5f), V(-2, 5.5f)}, 1.25f); break;
    case Icon::empty:
      p.box(-5.5f, -4, 5.5f, -2.75f), p.box(-2, -6, 2, -4.75f);
      p.path({V(-4, -2), V(-3.25f, 5.5f), V(3.25f, 5.5f), V(4, -2)}, 1.25f);
      break;
    case Icon::save:
      p.box(-0.75f, -6, 0.75f, 1), p.triangle(V(-4, -1), V(4, -1), V(0, 3)), p.box(-5.5f, 4, 5.5f, 5.5f);
      break;
    case Icon::meaning: p.box(-5, -3, 5, -1.5f), p.box(-5, 1.5f, 5, 3); break;
    case Icon::folded:
      p.box(-6, -0.75f, 6, 0.75f);
      p.path({V(-3, -6), V(0, -3), V(3, -6)}, 1.25f), p.path({V(-3, 6), V(0, 3), V(3, 6)}, 1.25f);
      break;
    case Icon::undo: p.turn_back(-1); break;
    case Icon::redo: p.turn_back(1); break;
    default: break;
  }
}

}  // namespace

void draw_icon(ImDrawList* list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
  const Pen pen{list, centre, size / 12, colour};
  if (icon == Icon::none || draw_solid(pen, icon)) return;
  draw_lines(pen, icon);
  draw_signs(pen, icon);
  draw_tool(pen, icon);
}

void draw_brand(ImDrawList* list, ImVec2 centre, float size, ImU32 ink, ImU32 knob) {
  const float r = size * 0.5f - size / 24, w = size / 12;
  const float hub = size * 0.11f;
  // The rim leaves a gap for the knob at the upper right.
  constexpr float pi = 3.14159265f;
  const float knob_angle = -pi * 0.28f, half_gap = 0.42f;
  list->PathArcTo(centre, r, knob_angle + half_gap, knob_angle + 2 * pi - half_gap, 40);
  list->PathStroke(ink, ImDrawFlags_None, w);
  for (int spoke = 0; spoke < 3; ++spoke) {
    const float a = -pi * 0.5f + static_cast<float>(spoke) * 2 * pi / 3;
    list->AddLine(centre, ImVec2(centre.x + r * std::cos(a), centre.y + r * std::sin(a)), ink, w);
  }
  list->AddCircleFilled(centre, hub, ink);
  list->AddCircleFilled(ImVec2(centre.x + r * std::cos(knob_angle), centre.y + r * std::sin(knob_angle)),
                        size * 0.125f, knob);
}

void draw_signal(ImDrawList* list, ImVec2 top_left, float size, int lit, ImU32 colour, ImU32 off) {
  const float unit = size / 22;
  for (int bar = 0; bar < 4; ++bar) {
    const float x = std::floor(top_left.x + static_cast<float>(bar) * 6 * unit + 0.5f);
    const float h = std::floor((4 + static_cast<float>(bar) * 4) * unit + 0.5f);
    const float bottom = top_left.y + std::floor(16 * unit + 0.5f);
    list->AddRectFilled(ImVec2(x, bottom - h), ImVec2(x + std::floor(4 * unit + 0.5f), bottom),
                        bar < lit ? colour : off);
  }
}

}  // namespace hw::gui
