#include "tests/gui/gallery.h"

#include <functional>
#include <string>

#include "gui/widgets/badge.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/digits.h"
#include "gui/widgets/hold_button.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/number_field.h"
#include "gui/widgets/slider.h"
#include "gui/widgets/state_word.h"
#include "gui/widgets/text.h"

namespace hw::gui {
namespace {

constexpr float first_column = 160, column = 180;
using Pretend = Ui::Pretend;

/// One row of the table: places cells by column.
class Row {
 public:
  Row(Ui& ui, float y, const char* name, const char* caption, float height = 72)
      : ui_(ui), y_(y), height_(height) {
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(ui.px(24), ui.px(y)),
                                              ImVec2(ui.px(1416), ui.px(y) + ui.hair()), ui[Tone::line]);
    draw_text(ui, ui.px(24, y + height / 2 - 20), Face::body_bold, ui[Tone::ink], name);
    draw_text(ui, ui.px(24, y + height / 2 + 2), Face::small, ui[Tone::ink2], caption);
  }
  void cell(int n, float h, Pretend pretend, const std::function<void(const std::string&)>& draw) {
    at(n, h);
    ui_.pretend = pretend;
    ImGui::BeginGroup();
    draw("row" + std::to_string(static_cast<int>(y_)) + "/" + std::to_string(n));
    ImGui::EndGroup();
    ui_.pretend = Pretend::nothing;
  }
  void at(int n, float h, float x = 0) {
    ImGui::SetCursorScreenPos(
        ui_.px(first_column + column * static_cast<float>(n) + x, y_ + (height_ - h) / 2));
  }

 private:
  Ui& ui_;
  float y_, height_;
};

void reason(Ui& ui, const char* words) {
  ImGui::SameLine();
  ImGui::BeginGroup();
  wrapped(ui, Face::small, Tone::ink2, words, 84);
  ImGui::EndGroup();
}

void hold_row(Ui& ui, float y) {
  Row row(ui, y, "Hold button", "moves while held");
  const auto plain = [&](const std::string& id) { hold_button(ui, id, "1+", {.icon = Icon::play}); };
  row.cell(0, 56, Pretend::nothing, plain);
  row.cell(1, 56, Pretend::hovered, plain);
  row.cell(2, 56, Pretend::held, plain);
  row.cell(3, 56, Pretend::ring, plain);
  const char* why[] = {"Program 0 is running", "Position is 1.2 s old", "1+ stands on its limit"};
  for (int i = 0; i < 3; ++i)
    row.cell(4 + i, 56, Pretend::nothing, [&](const std::string& id) {
      hold_button(ui, id, "1+", {.icon = Icon::play, .disabled = why[i]});
      reason(ui, why[i]);
    });
}

void button_rows(Ui& ui, float y) {
  Row moving(ui, y, "Moving button", "motion edge");
  const auto go = [&](const std::string& id) { button(ui, id, "Go", {.width = 64, .moving = true}); };
  moving.cell(0, 32, Pretend::nothing, go);
  moving.cell(1, 32, Pretend::hovered, go);
  moving.cell(2, 32, Pretend::held, go);
  moving.cell(3, 32, Pretend::ring, go);
  moving.cell(4, 32, Pretend::nothing, [&](const std::string& id) {
    button(ui, id, "Go", {.disabled = "home 1 first", .width = 64, .moving = true});
  });
  moving.cell(5, 32, Pretend::nothing, [&](const std::string& id) {
    button(ui, id, "Run", {.icon = Icon::play, .keys = "ctrl \n", .height = 40, .moving = true});
  });
  moving.cell(6, 32, Pretend::nothing, [&](const std::string& id) {
    button(ui, id, "\xE2\x88\x92", {.icon = Icon::home_minus, .moving = true});
    ImGui::SameLine();
    button(ui, id + "b", "+", {.icon_after = Icon::home_plus, .moving = true});
  });
  Row plain(ui, y + 72, "Button", "moves nothing");
  const auto simulate = [&](const std::string& id) {
    button(ui, id, "Simulate", {.icon = Icon::play_outline});
  };
  plain.cell(0, 32, Pretend::nothing, simulate);
  plain.cell(1, 32, Pretend::hovered, simulate);
  plain.cell(2, 32, Pretend::held, simulate);
  plain.cell(3, 32, Pretend::ring, simulate);
  plain.cell(4, 32, Pretend::nothing, [&](const std::string& id) {
    button(ui, id, "Simulate", {.icon = Icon::play_outline, .disabled = "the program is empty"});
  });
  plain.cell(5, 32, Pretend::nothing, [&](const std::string& id) {
    button(ui, id, "Start the demo", {.style = ButtonStyle::primary});
    ImGui::SameLine();
    link(ui, id + "l", "Show");
  });
  plain.cell(6, 32, Pretend::nothing, [&](const std::string& id) {
    button(ui, id, "Stop", {.style = ButtonStyle::danger, .icon = Icon::stop});
    ImGui::SameLine();
    button(ui, id + "q", "Save", {.style = ButtonStyle::quiet, .keys = "ctrl S"});
  });
}

void lamp_rows(Ui& ui, float y) {
  Row toggles(ui, y, "Toggle lamp", "output");
  const auto toggle = [&](ToggleState state, std::string_view disabled = {}) {
    return [&ui, state, disabled](const std::string& id) {
      toggle_lamp(ui, id, "Out 1", {.state = state, .disabled = disabled, .width = 136});
    };
  };
  toggles.cell(0, 32, Pretend::nothing, toggle(ToggleState::off));
  toggles.cell(1, 32, Pretend::hovered, toggle(ToggleState::off));
  toggles.cell(2, 32, Pretend::nothing, toggle(ToggleState::on));
  toggles.cell(3, 32, Pretend::ring, toggle(ToggleState::on));
  toggles.cell(4, 32, Pretend::nothing, toggle(ToggleState::off, "owned by sync X"));
  toggles.cell(5, 32, Pretend::nothing, toggle(ToggleState::stale));
  toggles.cell(6, 32, Pretend::nothing, toggle(ToggleState::refused));
  Row lamps(ui, y + 72, "Lamp", "input, limit");
  const auto lamp_of = [&](LampShape shape, LampState state, const char* name, const char* word) {
    return [&ui, shape, state, name, word](const std::string& id) {
      lamp(ui, id, name, {.shape = shape, .state = state, .word = word});
    };
  };
  lamps.cell(0, 32, Pretend::nothing, lamp_of(LampShape::square, LampState::off, "1+", "clear"));
  lamps.cell(1, 32, Pretend::nothing, lamp_of(LampShape::round, LampState::off, "In 1", "high"));
  lamps.cell(2, 32, Pretend::nothing, lamp_of(LampShape::square, LampState::hit, "1+", "HIT"));
  lamps.cell(3, 32, Pretend::nothing, lamp_of(LampShape::round, LampState::on, "DI3", "on"));
  lamps.cell(4, 32, Pretend::nothing, lamp_of(LampShape::square, LampState::disabled, "1+", "switched off"));
  lamps.cell(5, 32, Pretend::nothing, lamp_of(LampShape::square, LampState::unknown, "1+", "clear?"));
  lamps.cell(6, 32, Pretend::nothing, lamp_of(LampShape::round, LampState::armed, "Latch", "armed"));
}

void field_row(Ui& ui, float y) {
  Row row(ui, y, "Param row", "field");
  static NumberField fields[7];
  const auto field = [&](int n, NumberOptions o) {
    return [&ui, n, o](const std::string& id) {
      NumberOptions options = o;
      options.range.decimals = 1;
      options.width = 100;
      if (n == 6 && fields[n].text.empty()) {
        fields[n].set(8000, 0);
        fields[n].sentence = "1 to 6000 only";
      }
      number_field(ui, id, "KP", n == 6 ? std::optional<double>() : 12.5, fields[n], options);
    };
  };
  row.cell(0, 32, Pretend::nothing, field(0, {}));
  row.cell(1, 32, Pretend::hovered, field(1, {.range = {.unit = "mm"}}));
  row.cell(2, 32, Pretend::held, field(2, {}));
  row.cell(3, 32, Pretend::ring, field(3, {}));
  row.cell(4, 32, Pretend::nothing, field(4, {.disabled = "stop the axis first"}));
  row.cell(5, 32, Pretend::nothing, field(5, {.stale = true}));
  row.cell(6, 44, Pretend::nothing, field(6, {.range = {.min = 1, .max = 6000}}));
}

void digits_rows(Ui& ui, float y) {
  Row row(ui, y, "Digits", "position");
  const auto number = [&](DigitsState state, const char* value, State word) {
    return [&ui, state, value, word](const std::string& id) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      digits(ui, id, "position", value, "mm", {.face = Face::digits32, .state = state, .width = 150});
      draw_state_right(ui, id + "s", ImVec2(at.x + ui.px(150), at.y + ui.px(40)), word, Face::body_bold);
    };
  };
  row.cell(0, 60, Pretend::nothing, number(DigitsState::good, "7.800", State::idle));
  row.cell(1, 60, Pretend::hovered,
           number(DigitsState::good,
                  "\xE2\x88\x92"
                  "50.000",
                  State::homing_minus));
  row.cell(2, 60, Pretend::nothing, number(DigitsState::good, "7.835", State::moving_plus));
  row.cell(3, 60, Pretend::ring, number(DigitsState::good, "7.800", State::limit_minus));
  row.cell(4, 60, Pretend::nothing, number(DigitsState::off, "1.111", State::off));
  row.cell(5, 60, Pretend::nothing, number(DigitsState::stale, "8.888", State::stale));
  row.cell(6, 60, Pretend::nothing, number(DigitsState::untrusted, "7.800", State::untrusted));
  Row words(ui, y + 76, "State word", "shape, word, colour");
  const State left[] = {State::idle, State::moving_minus, State::homing_plus, State::limit_plus,
                        State::off,  State::waiting,      State::lost};
  for (int i = 0; i < 7; ++i)
    words.cell(i, 20, Pretend::nothing, [&](const std::string& id) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      draw_state_right(ui, id, ImVec2(at.x + ui.px(120), at.y), left[i], Face::body_bold);
    });
}

void meter_rows(Ui& ui, float y) {
  Row row(ui, y, "Meter", "memory, queue");
  const auto bar = [&](float share, MeterOptions o, const char* words) {
    return [&ui, share, o, words](const std::string& id) {
      MeterOptions options = o;
      options.width = 136;
      meter(ui, id, "memory", share, options);
      gap(ui, 2);
      const ImVec2 at = ImGui::GetCursorScreenPos();
      draw_text(ui, ImVec2(at.x - 0, at.y), Face::small,
                ui[o.over  ? Tone::fault
                   : o.old ? Tone::ink3
                           : Tone::ink],
                words);
    };
  };
  row.cell(0, 26, Pretend::nothing, bar(0.11f, {}, "27 of 256 bytes"));
  row.cell(2, 26, Pretend::nothing, bar(0.33f, {.tone = Tone::motion}, "22.3 of 68.6 s"));
  row.cell(5, 26, Pretend::nothing, bar(0.11f, {.old = true}, "27 of 256, before line 8"));
  row.cell(6, 26, Pretend::nothing, bar(1, {.over = true}, "261 of 256: 5 bytes too many"));
  Row badges(ui, y + 72, "Badge", "marks, never clicks");
  badges.cell(0, 20, Pretend::nothing, [&](const std::string& id) { emulated_badge(ui, id); });
  badges.cell(2, 20, Pretend::nothing,
              [&](const std::string& id) { badge(ui, id, BadgeTone::warn, Icon::diamond, "UNTRUSTED"); });
  badges.cell(4, 20, Pretend::nothing,
              [&](const std::string& id) { badge(ui, id, BadgeTone::fault, Icon::plug, "03 LOST"); });
}

void choice_row(Ui& ui, float y) {
  Row row(ui, y, "Segment, list", "one of several");
  static const std::string_view slots[] = {"0", "1", "2", "3", "4"};
  static const std::string_view units[] = {"mm", "steps", "inch"};
  static double speed = 0.55;
  row.cell(0, 32, Pretend::nothing, [&](const std::string& id) { segment(ui, id, slots, 0); });
  row.cell(1, 32, Pretend::nothing, [&](const std::string& id) { dropdown(ui, id, "unit", units, 0); });
  row.cell(2, 32, Pretend::hovered, [&](const std::string& id) { dropdown(ui, id, "unit", units, 1); });
  row.cell(3, 32, Pretend::nothing,
           [&](const std::string& id) { button(ui, id, "0.1 mm", {.width = 80, .on = true}); });
  row.cell(4, 32, Pretend::nothing,
           [&](const std::string& id) { slider(ui, id, "speed", speed, {.width = 150}); });
  row.cell(5, 32, Pretend::ring,
           [&](const std::string& id) { slider(ui, id, "speed", speed, {.width = 150}); });
  row.cell(6, 32, Pretend::nothing, [&](const std::string& id) {
    slider(ui, id, "speed", speed, {.disabled = "a program runs", .width = 150});
  });
}

void icon_row(Ui& ui, float y) {
  Row row(ui, y, "Icons", "drawn, no glyphs");
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (int i = 1; i < static_cast<int>(Icon::count); ++i)
    draw_icon(list, static_cast<Icon>(i), ui.px(150 + 32 * static_cast<float>(i), y + 24), ui.px(12),
              ui[Tone::ink]);
  draw_brand(list, ui.px(190, y + 52), ui.px(26), ui[Tone::ink], ui[Tone::motion]);
  for (int lit = 0; lit < 5; ++lit)
    draw_signal(list, ui.px(240 + 40 * static_cast<float>(lit), y + 44), ui.px(22), lit, ui[Tone::ok],
                ui[Tone::line]);
  ImGui::SetCursorScreenPos(ui.px(1200, y + 8));
  stop_button(ui, ui.px(200, 56));
}

}  // namespace

void draw_gallery(Ui& ui) {
  draw_text(ui, ui.px(24, 20), Face::stop, ui[Tone::ink], "Components and their states");
  const char* titles[] = {"Rest", "Hover", "Active", "Focus", "Disabled, with reason", "Stale", "Error"};
  for (int i = 0; i < 7; ++i)
    draw_text(ui, ui.px(first_column + column * static_cast<float>(i), 72), Face::small, ui[Tone::ink2],
              titles[i]);
  hold_row(ui, 96);
  button_rows(ui, 168);
  lamp_rows(ui, 312);
  field_row(ui, 456);
  digits_rows(ui, 532);
  meter_rows(ui, 684);
  choice_row(ui, 828);
  icon_row(ui, 900);
}

}  // namespace hw::gui
