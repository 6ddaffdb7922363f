#include "panels/tool_path.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/drawing/path_svg.h"
#include "core/session/user_files.h"
#include "gui/area.h"
#include "gui/console.h"
#include "gui/offscreen.h"
#include "gui/tab.h"
#include "gui/units_format.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float hit_height = 36, legend_width = 248;

AxisId axis_at(int place) { return AxisId{static_cast<std::uint8_t>(place)}; }

std::uint32_t over_white(std::uint32_t pixel) {
  const unsigned alpha = pixel >> IM_COL32_A_SHIFT & 255u;
  std::uint32_t out = IM_COL32_A_MASK;
  for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT})
    out |= ((pixel >> shift & 255u) * alpha + 255u * (255u - alpha)) / 255u << shift;
  return out;
}

std::string length_text(double units, const DisplayUnit& right, const DisplayUnit& up) {
  if (right.name != up.name) return "in two units";
  return fmt::format("{} {}", format_number(units, std::min(right.decimals, 3)).view(), right.name);
}

}  // namespace

void ToolPath::make(const Frame& f) {
  if (!axis_names_.empty()) return;
  for (const AxisInfo& axis : f.catalog.axes) axis_names_.push_back(axis.name);
  tool_names_.push_back("always on");
  for (const OutputInfo& output : f.catalog.outputs) tool_names_.push_back(output.name);
}

void ToolPath::draw(Frame& f) {
  make(f);
  work_out(f);
  follow_caret(f);
  if (f.ui.keyboard.pressed(Command::simulate)) f.tab.desk().rehearse(f.now, f.bench);
  draw_toolbar(f);
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float height = (f.ui.px(f.area.bottom()) - top.y) / f.ui.scale;
  const bool side = f.area.width >= 620;
  const float width = f.area.width - (side ? legend_width : 0);
  const int slot = f.tab.desk().texts.chosen();
  const bool busy = f.tab.desk().rehearsals.under_way(slot);
  const PathSubject subject{path_,
                            busy ? "The path is being worked out."
                                 : "Simulate shows where the program goes. What moves leaves a trace.",
                            axis_at(right_), axis_at(up_), lit_line(f)};
  canvas_.draw(f, "path/view", subject, width, height - hit_height);
  if (canvas_.clicked() || canvas_.passed()) say_hit(f);
  if (canvas_.measures()) say_measure(f);
  draw_hit(f, width);
  if (side) {
    ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + width), top.y));
    draw_legend(f, height);
  }
  if (const auto file = save_.draw(f.ui)) save(f, *file);
}

// ---- what is shown

void ToolPath::work_out(Frame& f) {
  Desk& desk = f.tab.desk();
  const int slot = desk.texts.chosen();
  const Rehearsals::Outcome* outcome = desk.rehearsals.of(slot);
  const auto scale = [&](int axis) {
    return TrackAxes::Axis{axis, from_steps(Steps(1), f.tab.unit(axis_at(axis)))};
  };
  Made wanted;
  wanted.slot = slot;
  if (outcome && outcome->result) wanted.rehearsal = outcome->number;
  wanted.axes = {scale(right_), scale(up_), tool_ - 1};
  if (wanted == made_) return;
  made_ = wanted;
  path_ = nullptr;
  hit_.clear(), hit_line_ = -1;
  canvas_.measure(canvas_.measures());  // its ends were in the axes and units of before
  canvas_.fit();
  if (wanted.rehearsal == 0) return;
  line_of_command_ = lines_of_commands(desk.language()->analyse(outcome->text, slot), slot);
  time_ = fmt::format("{}", format_duration(outcome->result->duration_s).view());
  Rehearsal way;
  way.track = outcome->result->track, way.events = outcome->result->events;
  desk.worker().run(
      [way = std::move(way), axes = wanted.axes, slot, lines = line_of_command_] {
        return std::make_shared<const drawing::ToolPath>(track_path(way, axes, slot, lines));
      },
      [this, wanted, right = f.tab.unit(axis_at(right_)),
       up = f.tab.unit(axis_at(up_))](std::shared_ptr<const drawing::ToolPath> path) {
        if (wanted == made_) take(std::move(path), right, up);
      },
      alive_);
  f.ui.wake_in(0);
}

void ToolPath::take(std::shared_ptr<const drawing::ToolPath> path, const DisplayUnit& right,
                    const DisplayUnit& up) {
  way_on_ = length_text(path->way_on, right, up), way_off_ = length_text(path->way_off, right, up);
  const drawing::Box& box = path->bounds;
  const auto span = [](double units, const DisplayUnit& unit) {
    return format_number(units, std::min(unit.decimals, 3));
  };
  size_ = box.empty ? "nothing moves"
                    : fmt::format("{}{}{} \u00d7 {} {}", span(box.high.x - box.low.x, right).view(),
                                  right.name == up.name ? "" : " ", right.name == up.name ? "" : right.name,
                                  span(box.high.y - box.low.y, up).view(), up.name);
  path_ = box.empty ? nullptr : std::move(path);
}

/// Of the program that runs, where it is that which was rehearsed.
int ToolPath::lit_line(const Frame& f) const {
  Desk& desk = f.tab.desk();
  const RunFollower::Place at = desk.follower.place();
  const Rehearsals::Outcome* outcome = desk.rehearsals.of(made_.slot);
  if (!path_ || !outcome || !f.connected() || at.slot != made_.slot || at.command < 0) return hit_line_;
  if (desk.texts.held(at.slot).text != outcome->text || ix(at.command) >= line_of_command_.size())
    return hit_line_;
  return line_of_command_[ix(at.command)];
}

std::string ToolPath::place_text(const Frame& f, drawing::Point p) const {
  const DisplayUnit &right = f.tab.unit(axis_at(right_)), &up = f.tab.unit(axis_at(up_));
  return fmt::format("{} {}, {} {}", axis_names_[ix(right_)],
                     format_with_unit(to_steps(p.x, right), right).view(), axis_names_[ix(up_)],
                     format_with_unit(to_steps(p.y, up), up).view());
}

/// The line that draws it, the place, and when the axes were really there.
void ToolPath::say_hit(Frame& f) {
  const auto& hit = canvas_.clicked();
  const auto& passed = canvas_.passed();
  hit_line_ = hit ? path_->runs[hit->run].source : -1;
  hit_ = place_text(f, hit ? hit->at : passed->at);
  const Rehearsals::Outcome* outcome = f.tab.desk().rehearsals.of(made_.slot);
  if (hit_line_ >= 0)
    hit_ = fmt::format("Line {}: {} \u00b7 {}", hit_line_ + 1,
                       outcome ? line_of(outcome->text, hit_line_) : "", hit_);
  if (passed)
    hit_ += fmt::format(" \u00b7 was there {} ago",
                        format_duration(std::max(0.0, std::floor(seconds(f.clock - passed->when)))).view());
}

/// The way between two clicks, in its parts and straight.
void ToolPath::say_measure(const Frame& f) {
  const auto way = canvas_.measured();
  if (!way) return hit_.assign("Click where to measure from."), void();
  const DisplayUnit &right = f.tab.unit(axis_at(right_)), &up = f.tab.unit(axis_at(up_));
  hit_ = place_text(f, *way);
  if (right.name == up.name)
    hit_ += fmt::format(" \u00b7 {} straight \u00b7 {:.1f}\u00b0",
                        length_text(std::hypot(way->x, way->y), right, up),
                        std::atan2(way->y, way->x) * 180 / M_PI);
}

/// What the caret has come to in the editor since is lit here.
void ToolPath::follow_caret(const Frame& f) {
  Desk& desk = f.tab.desk();
  if (std::exchange(caret_line_, desk.caret_line) == desk.caret_line || !path_) return;
  const Rehearsals::Outcome* outcome = desk.rehearsals.of(made_.slot);
  if (!outcome || outcome->text != desk.texts.text(made_.slot)) return;
  hit_line_ = caret_line_;
  hit_ = fmt::format("Line {}: {}", hit_line_ + 1, line_of(outcome->text, hit_line_));
}

/// As its name ends: lines in the units of the axes, or pixels.
void ToolPath::save(Frame& f, const std::filesystem::path& file) {
  if (!path_) return;
  Desk& desk = f.tab.desk();
  PathLook look;
  look.tool_on = IM_COL32(0, 0, 0, 255), look.tool_off = IM_COL32(136, 136, 136, 255);
  look.dash = 5, look.dash_gap = 4;
  desk.worker().run(
      [path = path_, look, file, equal = f.tab.unit(axis_at(right_)).name == f.tab.unit(axis_at(up_)).name,
       unit = f.tab.unit(axis_at(right_)).name]() -> Result<> {
        if (file.extension() != ".png") return write_file(file, drawing::path_svg(*path, unit));
        constexpr int width = 1600, height = 1200;
        const drawing::PathView view(path->bounds, width, height, equal);
        Picture picture = path_picture(std::array{PathLayer{path.get(), look}}, view);
        for (std::uint32_t& p : picture.pixels) p = over_white(p);
        return write_png(file.string(), picture.pixels, width, height);
      },
      [&console = f.console, file](Result<> written) {
        if (!written) return console.toast(Mood::fault, written.error().sentence());
        console.toast(Mood::ok, fmt::format("Saved as {}.", file.string()));
      },
      desk.alive());
}

// ---- drawing

void ToolPath::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  Desk& desk = f.tab.desk();
  const ImVec2 top = begin_toolbar(f);
  const int slot = desk.texts.chosen();
  const std::string_view why = !desk.language()                  ? "This model has no rehearsal."
                               : desk.texts.text(slot).empty()   ? "The program is empty."
                               : desk.rehearsals.under_way(slot) ? "It is being worked out."
                                                                 : "";
  if (button(ui, "path/simulate", "Simulate",
             {.icon = Icon::play_outline,
              .keys = f.area.width >= 800 ? "F5" : "",
              .disabled = why,
              .tip = "Tries the program without moving anything, and draws its path.",
              .height = 40})
          .clicked)
    desk.rehearse(f.now, f.bench);
  draw_choices(f, top.y);
  const auto tool = [&](const char* id, const char* label, std::string_view tip) {
    ImGui::SameLine(0, 0);
    ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, top.y + ui.px(8)));
    return button(ui, id, label, {.style = ButtonStyle::quiet, .tip = tip, .height = 40}).clicked;
  };
  if (tool("path/fit", "Fit", "Shows all of it. On the picture: 0, or a double click.")) canvas_.fit();
  if (tool("path/nearer", "+", "Nearer. On the picture: +, or the wheel.")) canvas_.zoom(1.5);
  if (tool("path/further", "\u2212", "Further away. On the picture: -, or the wheel.")) canvas_.zoom(1 / 1.5);
  if (f.area.width >= 700 && tool("path/forget", "Forget trace", "Where the axes have been so far."))
    desk.trace.clear();
  ImGui::SameLine(0, 0);
  ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, top.y + ui.px(8)));
  if (button(ui, "path/save", "Save picture",
             {.style = ButtonStyle::quiet,
              .disabled = path_ ? "" : "There is no path yet.",
              .tip = "As SVG in the units of the axes, or as PNG.",
              .height = 40})
          .clicked)
    save_.ask_save("Save the path", save_.folder() / "path.svg", {".svg", ".png"});
  end_toolbar(f, top);
}

void ToolPath::draw_choices(Frame& f, float top) {
  Ui& ui = f.ui;
  const auto choose = [&](const char* id, const char* label, std::span<const std::string_view> names,
                          int& chosen, std::string_view tip) {
    ImGui::SameLine(0, ui.px(8));
    ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, top + ui.px(12)));
    if (const int picked = dropdown(ui, id, label, names, chosen, {.tip = tip}); picked >= 0) chosen = picked;
  };
  choose("path/right", "To the right", axis_names_, right_, "Which axis goes to the right.");
  choose("path/up", "Upwards", axis_names_, up_, "Which axis goes upwards.");
  if (tool_names_.size() > 1)
    choose("path/tool", "Tool", tool_names_, tool_, "The output that switches pen or laser.");
}

void ToolPath::draw_legend(Frame& f, float height) {
  Ui& ui = f.ui;
  draw_line_down(f);
  begin_part(ui, "path/legend", 0, ui.px(height), Tone::panel, 16);
  section_title(ui, "Legend");
  const auto entry = [&](Tone tone, float width, bool dashed, std::string_view words) {
    const ImVec2 p = ImGui::GetCursorScreenPos();
    const float y = std::floor(p.y + ui.px(12));
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (float x = 0; x < 28; x += dashed ? 9 : 28)
      list->AddRectFilled(ImVec2(p.x + ui.px(x), y),
                          ImVec2(p.x + ui.px(dashed ? std::min(x + 5, 28.0f) : 28), y + width * ui.hair()),
                          ui[tone]);
    draw_text_line(ui, p.x + ui.px(40), ui.px(f.area.right() - 16), p.y + ui.px(12), Face::body,
                   ui[Tone::ink2], words);
    ImGui::SetCursorScreenPos(ImVec2(p.x, p.y + ui.px(24)));
  };
  entry(Tone::ink, 2, false, "rehearsed, tool on");
  entry(Tone::ink3, 1, true, "rehearsed, tool off");
  entry(Tone::motion, 1, false, "has been there");
  entry(Tone::motion, 3, false, "line at work, or clicked");
  if (f.bench.present) entry(Tone::warn, 1, false, "limit switch on the bench");
  group_line(ui);
  section_title(ui, "This path", f.tab.desk().rehearsals.under_way(made_.slot) ? "working it out" : "");
  if (made_.rehearsal == 0) {
    wrapped(ui, Face::body, Tone::ink2, "Nothing has been rehearsed yet.");
  } else if (path_) {
    key_value(ui, "path/size", "Size", size_);
    key_value(ui, "path/way_on", "Tool on", way_on_);
    if (tool_ > 0) key_value(ui, "path/way_off", "Tool off", way_off_);
    key_value(ui, "path/time", "Time", time_);
    if (f.tab.desk().rehearsals.older_than_line(made_.slot, f.tab.desk().texts.text(made_.slot)) >= 0) {
      gap(ui, 8);
      wrapped(ui, Face::body, Tone::warn, "The text has been changed since. Simulate draws it anew.");
    }
  } else {
    wrapped(ui, Face::body, Tone::ink2, "These two axes do not move in it.");
  }
  end_part();
}

void ToolPath::draw_hit(Frame& f, float width) {
  Ui& ui = f.ui;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Rect row{corner, ImVec2(corner.x + ui.px(width), corner.y + ui.px(hit_height))};
  ImGui::GetWindowDrawList()->AddRectFilled(row.min, ImVec2(row.max.x, row.min.y + ui.hair()),
                                            ui[Tone::line]);
  const float middle = std::floor(row.centre().y);
  float right = row.max.x - ui.px(16);
  const std::string_view measure = canvas_.measures() ? "End measuring" : "Measure";
  right -= std::ceil(text_width(ui, Face::small, measure));
  ImGui::SetCursorScreenPos(ImVec2(right, std::floor(middle - ui.line(Face::small) / 2)));
  if (link(ui, "path/measure", measure)) canvas_.measure(!canvas_.measures()), hit_.clear(), hit_line_ = -1;
  right -= ui.px(12);
  if (hit_line_ >= 0 && made_.slot >= 0 && !canvas_.measures()) {
    Desk& desk = f.tab.desk();
    const bool old = desk.rehearsals.older_than_line(made_.slot, desk.texts.text(made_.slot)) >= 0;
    right -= std::ceil(text_width(ui, Face::small, "Show line"));
    ImGui::SetCursorScreenPos(ImVec2(right, std::floor(middle - ui.line(Face::small) / 2)));
    if (link(ui, "path/show_line", "Show line",
             old ? "The text has been changed since. Simulate draws it anew." : "")) {
      desk.wanted_line = hit_line_;
      f.show_panel("program");
    }
    right -= ui.px(12);
  }
  const std::string_view said =
      hit_.empty() ? std::string_view("Click the path: this line tells what draws it.") : hit_;
  draw_text_line(ui, row.min.x + ui.px(16), right, middle, Face::body,
                 ui[hit_.empty() ? Tone::ink3 : Tone::ink], said);
  show(ui, {"path/hit", Kind::text, "Clicked", hit_}, {row.min, ImVec2(right, row.max.y)});
  ImGui::SetCursorScreenPos(ImVec2(corner.x, row.max.y));
}

}  // namespace hw::panels
