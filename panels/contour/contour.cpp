#include "panels/contour/contour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/model/tab.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/choice.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float text_height = 148;

}  // namespace

void Contour::make(const Frame& f) {
  if (run_) return;
  run_ = f.tab.desk().list_run.get();
  language_ = f.tab.desk().programs.language();
  for (const AxisInfo& a : f.catalog.axes) names_.axes.push_back(a.name);
  contour_.second = f.catalog.axes.size() > 1 ? 1 : 0;
  for (std::size_t i = 0; i < f.catalog.outputs.size(); ++i)
    if (f.catalog.outputs[i].on_the_way) {
      names_.output_numbers.push_back(f.catalog.output_number(i));
      names_.outputs.push_back(f.catalog.outputs[i].name);
    }
  contour_.unit.name = stairs_.unit.name = f.catalog.step_word;
  contour_.speed.set(1000, 0);
  for (NumberField* n : {&contour_.x, &contour_.y}) n->set(0, 0);
  contour_.lead_in.set(0, 0);
  stairs_.stop_at.set(10'000, 0);
}

/// Converts typed numbers when the unit changes.
void Contour::follow_units(const Frame& f) {
  ContourUnit before = std::exchange(contour_.unit, contour_unit(f, contour_.first, contour_.second));
  const auto place = [&](NumberField& field, const ContourUnit& unit) {
    if (const auto steps = before.steps(field)) unit.put(field, *steps);
  };
  const auto length = [&](NumberField& field, const ContourUnit& unit) {
    if (const auto steps = before.steps_long(field)) unit.put_long(field, *steps);
  };
  if (before != contour_.unit) {
    for (NumberField* n : {&contour_.x, &contour_.y}) place(*n, contour_.unit);
    for (NumberField* n : {&contour_.speed, &contour_.lead_in}) length(*n, contour_.unit);
    for (Piece& p : contour_.pieces)
      if (p.kind != PieceKind::output) place(p.x, contour_.unit), place(p.y, contour_.unit);
    changed_ = true;
  }
  before = std::exchange(stairs_.unit, contour_unit(f, stairs_.axis));
  if (before == stairs_.unit) return;
  place(stairs_.stop_at, stairs_.unit);
  for (Stair& s : stairs_.rows) place(s.until, stairs_.unit), length(s.speed, stairs_.unit);
  changed_ = true;
}

void Contour::draw(Frame& f) {
  make(f);
  follow_units(f);
  follow(f);
  work_out(f);
  draw_toolbar(f);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = (f.ui.px(f.area.bottom()) - at.y) / f.ui.scale;
  const bool two = f.area.width >= 680;
  const float list = two ? std::clamp(std::floor(f.area.width * 0.46f), 384.0f, 420.0f) : f.area.width;
  ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x), at.y));
  begin_part(f.ui, "contour/list", f.ui.px(list), f.ui.px(height), Tone::panel, 16);
  const float inner = ImGui::GetContentRegionAvail().x / f.ui.scale;
  if (!two) draw_preview(f, inner, 200);
  if (stairs_shown_)
    draw_stairs_list(f, inner);
  else
    draw_contour_list(f, inner);
  if (!two) draw_text(f, inner);
  end_part();
  if (two) draw_work(f, list, height);
  draw_dialogs(f);
}

// ---- running the list

std::string_view Contour::why_not_run(const Frame& f) const {
  if (!f.connected()) return "There is no link. The list stays here.";
  if (!f.tab.why_not_move().empty()) return f.tab.why_not_move();
  if (!worked_.problem.empty()) return worked_.problem;
  if (worked_.text.empty()) return "There is nothing to run yet.";
  if (run_->busy()) return "The run is under way.";
  if (f.now.any_axis_moving()) return "An axis is moving. Wait until it rests.";
  return {};
}

void Contour::run(Frame& f) {
  doubt_.close();
  run_->begin(worked_.text, worked_.places,
              [&f](IntentBody body) { return f.send_and_watch(std::move(body)); });
}

/// The program editor keeps the text from then on.
void Contour::put_into_program(Frame& f) {
  f.tab.desk().programs.texts.set_text(0, worked_.text);
  (stairs_shown_ ? stairs_.unkept : contour_.unkept) = false;
  f.show_panel("program");
}

std::string_view Contour::unkept() const {
  if (contour_.unkept && !contour_.pieces.empty()) return "The contour is in no file and not in the program.";
  if (stairs_.unkept && !stairs_.rows.empty()) return "The staircase is in no file and not in the program.";
  return {};
}

void Contour::follow(Frame& f) {
  run_->looked_at();
  for (Report& report : run_->take_report()) f.toast(report.severity, std::move(report.sentence));
  const auto refused = run_->take_refusal();
  if (!refused || doubt_.take_refusal(f, *run_->start(), *refused)) return;
  refused_ = f.tab.messages.words_of(*refused);
  past_ = refused->past;
  refused_places_ = run_->start()->places;
  if (worked_.places != refused_places_) past_.reset();  // the list was edited since
  if (!past_) f.toast(Severity::fault, refused_);
}

// ---- drawing

void Contour::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  const ImVec2 at = begin_toolbar(f);
  static constexpr std::array<std::string_view, 2> kinds = {"Contour", "Staircase"};
  ButtonOptions go;
  go.icon = Icon::play;
  go.moving = true;
  go.height = 40;
  go.disabled = why_not_run(f);
  go.tip = "Sends this text to the controller and runs it. A stop ends it.";
  const Touch begun = button(ui, "contour/run", "Run", go);
  if (begun.clicked) run(f);
  if (doubt_.open())
    if (const IntentId sent = doubt_.draw(f, "contour", "Run", begun.rect)) run_->started_as(sent);
  draw_refused(f, begun.rect);
  ImGui::SetCursorScreenPos(ImVec2(begun.rect.max.x + ui.px(8), begun.rect.min.y));
  ButtonOptions put;
  put.height = 40;
  if (!worked_.problem.empty())
    put.disabled = worked_.problem;
  else if (worked_.text.empty())
    put.disabled = "There is no text yet.";
  put.tip = "Puts the text into the program editor.";
  if (button(ui, "contour/to_program", "To the program", put).clicked) {
    asking_ = !f.tab.desk().programs.texts.text(0).empty();
    if (!asking_) put_into_program(f);
  }
  const float after = ImGui::GetItemRectMax().x + ui.px(16);
  ImGui::SetCursorScreenPos(ImVec2(after, at.y + ui.px(12)));
  if (const int kind = segment(ui, "contour/kind", kinds, stairs_shown_ ? 1 : 0, {.cell_width = 84});
      kind >= 0) {
    stairs_shown_ = kind == 1;
    changed_ = true;
  }
  const bool empty = stairs_shown_ ? stairs_.rows.empty() : contour_.pieces.empty();
  file_.draw_buttons(f, empty ? "There is nothing to save yet." : "",
                     stairs_shown_ ? "staircase" : "contour");
  end_toolbar(f, at);
}

void Contour::draw_work(Frame& f, float left, float height) {
  Ui& ui = f.ui;
  const float x = ui.px(f.area.x + left), top = ui.px(f.area.bottom()) - ui.px(height);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(x, top), ImVec2(x + ui.hair(), ui.px(f.area.bottom())),
                                            ui[Tone::line]);
  ImGui::SetCursorScreenPos(ImVec2(x + ui.hair(), top));
  begin_part(ui, "contour/work", 0, ui.px(height), Tone::panel, 0);
  const float width = ImGui::GetContentRegionAvail().x / ui.scale;
  draw_preview(f, width, std::max(160.0f, height - text_height));
  ImGui::Indent(ui.px(16));
  draw_text(f, width - 32);
  ImGui::Unindent(ui.px(16));
  end_part();
}

void Contour::draw_preview(Frame& f, float width, float height) {
  if (!stairs_shown_) {
    PathSubject subject;
    subject.path = worked_.path;
    subject.none =
        worked_.problem.empty() ? "Nothing to draw yet." : std::string_view();  // the problem is shown below
    subject.axes = {AxisId{static_cast<std::uint8_t>(contour_.first)},
                    AxisId{static_cast<std::uint8_t>(contour_.second)}};
    subject.words = worked_.facts;
    return canvas_.draw(f, "contour/view", subject, width, height);
  }
  PlotOptions o;
  const Path title("speed, {}, over position", stairs_.unit.of_speed);
  o.title = title;
  o.x_unit = stairs_.unit.name;
  o.width = width, o.height = height;
  o.empty = "Add a step.";
  const PlotTrace trace{worked_.stair_x, worked_.stair_y, Tone::ink, 2, false, "speed", true};
  if (!worked_.stair_x.empty()) o.x = {worked_.stair_x.front(), worked_.stair_x.back()};
  o.y = {0, 0};
  o.y.take(worked_.stair_y);
  o.y.widen(0.08f);
  o.x.widen(0.03f);
  const Path words("{} steps", stairs_.rows.size());
  o.words = words;
  plot(f.ui, "stairs/view", "Speeds over positions", {&trace, stairs_.rows.empty() ? 0u : 1u}, o, cursor_);
}

void Contour::draw_text(Frame& f, float width) {
  Ui& ui = f.ui;
  gap(ui, 8);
  if (!worked_.problem.empty()) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool begun =
        stairs_shown_ ? !stairs_.rows.empty() : !contour_.pieces.empty();  // an empty list is not a fault
    wrapped(ui, Face::body, begun ? Tone::fault : Tone::ink2, worked_.problem, width);
    show(ui, {"contour/problem", Kind::text, "Problem", worked_.problem},
         {at, ImVec2(at.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
  } else if (!worked_.facts.empty()) {
    named_text(ui, "contour/facts", Face::small, Tone::ink2, worked_.facts);
  }
  gap(ui, 4);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // Draws the lines of the text, in as many columns as needed.
  std::string_view rest = worked_.text;
  float x = at.x, y = at.y, deepest = at.y, widest = 0;
  const float bottom = at.y + 5 * ui.line(Face::code_field);
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    draw_text_line(ui, x, at.x + ui.px(width), y + ui.line(Face::code_field) / 2, Face::code_field,
                   ui[Tone::ink2], line);
    widest = std::max(widest, text_width(ui, Face::code_field, line));
    y += ui.line(Face::code_field);
    deepest = std::max(deepest, y);
    if (y + ui.line(Face::code_field) > bottom) x += std::ceil(widest) + ui.px(20), y = at.y, widest = 0;
  }
  show(ui, {"contour/text", Kind::text, "Commands", worked_.text}, {at, ImVec2(at.x + ui.px(width), bottom)});
  ImGui::SetCursorScreenPos(ImVec2(at.x, deepest));
  gap(ui, 8);
}

void Contour::draw_dialogs(Frame& f) {
  if (const auto sequence = file_.draw_open(f)) opened(f, *sequence);
  if (const auto path = file_.draw_save(f)) {
    const auto list = list_for_file();
    if (list)
      file_.save(f, *path, *list);
    else
      f.toast(Severity::fault, list.error().sentence());
  }
  if (file_.take_saved()) (stairs_shown_ ? stairs_.unkept : contour_.unkept) = false;
  if (!asking_) return;
  const Dialog what{.title = "Replace the program text?",
                    .sentences = "The editor holds another text. Unsaved changes are lost.",
                    .yes = "Replace",
                    .no = "Keep the text"};
  if (dialog(f.ui, "contour/replace", asking_, what) == Answer::yes) put_into_program(f);
}

}  // namespace hw::panels
