#include "panels/contour/contour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sequence/places_before.h"
#include "core/sequence/speed_stairs.h"
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

tl::unexpected<Fault> no_number(std::string what) {
  return fail(FaultKind::text, what + " is not a number.", "Nothing was sent.");
}

/// Rewords messages about the steps of a sequence for the rows of this list.
std::string in_rows(std::string_view what) {
  constexpr std::string_view of_step = "Step 1.", of_all = "Step 1 (";
  if (what.starts_with(of_step)) return fmt::format("Piece {}", what.substr(of_step.size()));
  const std::size_t kind = what.starts_with(of_all) ? what.find("): ") : what.npos;
  std::string rest(kind == what.npos ? what : what.substr(kind + 3));
  if (!rest.empty()) rest[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(rest[0])));
  return rest;
}

}  // namespace

void Contour::make(const Frame& f) {
  if (std::exchange(made_, true)) return;
  language_ = f.tab.desk().language();
  for (const AxisInfo& a : f.catalog.axes) axis_names_.push_back(a.name);
  second_ = f.catalog.axes.size() > 1 ? 1 : 0;
  for (std::size_t i = 0; i < f.catalog.outputs.size(); ++i)
    if (f.catalog.outputs[i].on_the_way) {
      outputs_.push_back(f.catalog.output_number(i));
      output_names_.push_back(f.catalog.outputs[i].name);
    }
  unit_.name = stairs_unit_.name = f.catalog.step_word;
  speed_.set(1000, 0);
  for (NumberField* n : {&x_, &y_}) n->set(0, 0);
  lead_in_.set(0, 0);
  stop_at_.set(10'000, 0);
}

/// Converts typed numbers when the unit changes.
void Contour::follow_units(const Frame& f) {
  ContourUnit before = std::exchange(unit_, contour_unit(f, first_, second_));
  const auto place = [&](NumberField& field, const ContourUnit& unit) {
    if (const auto steps = before.steps(field)) unit.put(field, *steps);
  };
  const auto length = [&](NumberField& field, const ContourUnit& unit) {
    if (const auto steps = before.steps_long(field)) unit.put_long(field, *steps);
  };
  if (before != unit_) {
    for (NumberField* n : {&x_, &y_}) place(*n, unit_);
    for (NumberField* n : {&speed_, &lead_in_}) length(*n, unit_);
    for (Piece& p : pieces_)
      if (p.kind != PieceKind::output) place(p.x, unit_), place(p.y, unit_);
    changed_ = true;
  }
  before = std::exchange(stairs_unit_, contour_unit(f, stair_axis_));
  if (before == stairs_unit_) return;
  place(stop_at_, stairs_unit_);
  for (Stair& s : stairs_) place(s.until, stairs_unit_), length(s.speed, stairs_unit_);
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

// ---- contents of the fields

Result<sequence::Sequence> Contour::contour() const {
  const auto speed = unit_.steps_long(speed_), lead = unit_.steps_long(lead_in_);
  const auto x = unit_.steps(x_), y = unit_.steps(y_);
  if (!speed || *speed < 1) return no_number("The speed");
  if (!x || !y) return no_number("The begin");
  if (!lead || *lead < 0) return no_number("The lead-in");
  if (first_ == second_)
    return fail(FaultKind::text, "A contour needs two different axes.", "Nothing was sent.");
  sequence::Contour c;
  c.x = *x, c.y = *y;
  c.lead_in = *lead, c.ends_ramped = ramp_;
  c.own = sequence::Speeds{*speed};
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& p = pieces_[i];
    if (p.kind == PieceKind::output) {
      if (outputs_.empty()) return no_number("An output");
      c.steps.push_back({sequence::Output{outputs_[static_cast<std::size_t>(p.output)], p.on}});
      continue;
    }
    const auto px = unit_.steps(p.x), py = unit_.steps(p.y);
    if (!px || !py) return no_number(fmt::format("A position of piece {}", i + 1));
    if (p.kind == PieceKind::arc) {
      const auto degrees = p.degrees.value();
      if (!degrees) return no_number(fmt::format("The angle of piece {}", i + 1));
      c.steps.push_back({sequence::Arc{*px, *py, *degrees, {}}});
    } else {
      sequence::Move line;
      line.to[0] = *px, line.to[1] = *py;
      c.steps.push_back({line});
    }
  }
  sequence::Sequence s;
  for (const int axis : {first_, second_})
    s.axes.push_back({std::string(axis_names_[static_cast<std::size_t>(axis)])});
  s.steps = {{std::move(c)}};
  return s;
}

Result<sequence::Sequence> Contour::staircase() const {
  sequence::SpeedStairs stairs;
  const auto stop = stairs_unit_.steps(stop_at_);
  if (!stop) return no_number("The place where it stops");
  stairs.stop_at = *stop;
  for (std::size_t i = 0; i < stairs_.size(); ++i) {
    const auto until = stairs_unit_.steps(stairs_[i].until);
    const auto speed = stairs_unit_.steps_long(stairs_[i].speed);
    if (!until || !speed) return no_number(fmt::format("A number of stair {}", i + 1));
    stairs.stairs.push_back({*until, *speed});
  }
  sequence::Sequence s;
  s.axes = {{std::string(axis_names_[static_cast<std::size_t>(stair_axis_)])}};
  s.steps = {{std::move(stairs)}};
  return s;
}

/// Runs only on a change: a panel at rest computes and allocates nothing.
void Contour::work_out(Frame& f) {
  const Steps stands = f.now.axes[static_cast<std::size_t>(stair_axis_)].commanded();
  if (stairs_shown_ && stands != worked_out_from_ && !f.now.any_axis_moving()) changed_ = true;
  const auto shown = [&](int axis) {
    return from_steps(Steps(1), f.tab.unit(AxisId{static_cast<std::uint8_t>(axis)}));
  };
  const drawing::Point scale{shown(first_), shown(second_)};
  if (std::exchange(scale_, scale) != scale) changed_ = true;
  if (!std::exchange(changed_, false)) return;
  worked_out_from_ = stands;
  problem_.clear(), text_.clear(), facts_.clear(), stair_x_.clear(), stair_y_.clear(), places_.clear();
  path_ = nullptr;
  if (!language_) return problem_.assign("The language of this controller cannot write contours."), void();
  const auto plan = stairs_shown_ ? staircase() : contour();
  const auto written = plan.and_then([&](const sequence::Sequence& of) {
    return draw_step(of.steps.front()).and_then([&] { return write(of, f.catalog); });
  });
  if (!written) return problem_.assign(in_rows(written.error().what)), void();
  add_places(*plan, f.catalog);
  text_ = written->text;
  const ProgramReport report = language_->analyse(text_, 0);
  for (const Problem& p : report.problems)
    if (p.error) return problem_.assign(fmt::format("Line {}: {}", p.line + 1, p.sentence)), void();
}

/// Refusals use the unit that was typed.
Result<SequenceText> Contour::write(const sequence::Sequence& plan, const Catalog& catalog) const {
  auto written = language_->write(plan, catalog);
  const double per_step = (stairs_shown_ ? stairs_unit_ : unit_).per_step;
  if (written || per_step <= 0 || per_step == 1) return written;
  const auto shown = shown_list();
  auto refused = shown ? language_->write(*shown, catalog) : std::move(written);
  return refused ? std::move(written) : std::move(refused);
}

Result<> Contour::draw_step(const sequence::Step& step) {
  if (const auto* stairs = std::get_if<sequence::SpeedStairs>(&step.body)) {
    const auto from = static_cast<double>(worked_out_from_.value);
    draw_staircase_line(*stairs, from);
    sequence::SpeedStairs shown = *stairs;
    for (sequence::SpeedStairs::Stair& stair : shown.stairs) stair.until = stairs_unit_.typed(stair.until);
    shown.stop_at = stairs_unit_.typed(shown.stop_at);
    const std::string why = why_no_way(shown, stairs_unit_.typed(from));
    return why.empty() ? Result<>() : fail(FaultKind::text, "Step 1 (speed_stairs): " + why);
  }
  const auto& drawn = std::get<sequence::Contour>(step.body);
  const drawing::ToolPath in_steps = drawing::contour_path(drawn, {1, 1});
  if (in_steps.runs.empty()) return {};
  double length = in_steps.way_on + in_steps.way_off;
  if (in_steps.runs.front().source < 0) length -= drawn.lead_in;
  facts_ = fmt::format("{:.{}f} {} long, {:.1f} s at this speed", unit_.shown_length(length), unit_.decimals,
                       unit_.name, length / drawn.own->high);
  path_ = std::make_shared<const drawing::ToolPath>(drawing::contour_path(drawn, scale_));
  return {};
}

/// As far as the plan reaches in each of its axes.
void Contour::add_places(const sequence::Sequence& plan, const Catalog& catalog) {
  const sequence::Reach reach = reaches_between(plan, {0, 1}).front();
  for (std::size_t a = 0; a < plan.axes.size(); ++a)
    for (const auto& place : {reach.least[a], reach.greatest[a]})
      if (place)
        places_.push_back({AxisId{static_cast<std::uint8_t>(catalog.find_axis(plan.axes[a].name))},
                           Steps(std::llround(*place))});
}

/// Speeds over positions, as a staircase.
void Contour::draw_staircase_line(const sequence::SpeedStairs& stairs, double from) {
  const auto put = [&](double x, double y) {
    stair_x_.push_back(static_cast<float>(stairs_unit_.shown(x)));
    stair_y_.push_back(static_cast<float>(stairs_unit_.shown_length(y)));
  };
  double at = from;
  put(at, 0);
  for (const auto& [until, speed] : stairs.stairs) put(at, speed), put(at = until, speed);
  if (!stairs.stairs.empty()) put(stairs.stop_at, stairs.stairs.back().speed);
  put(stairs.stop_at, 0);
  if (stair_x_.back() < stair_x_.front()) {
    std::reverse(stair_x_.begin(), stair_x_.end());
    std::reverse(stair_y_.begin(), stair_y_.end());
  }
}

// ---- running it

std::string_view Contour::why_not_run(const Frame& f) const {
  if (!f.connected()) return "There is no link. The list stays here.";
  if (!f.tab.why_not_move().empty()) return f.tab.why_not_move();
  if (!problem_.empty()) return problem_;
  if (text_.empty()) return "There is nothing to run yet.";
  if (loading_ || starting_) return "It is on its way.";
  if (f.now.any_axis_moving()) return "An axis is moving. Wait until it rests.";
  return {};
}

void Contour::run(Frame& f) {
  loading_ = f.send_and_watch(intent::LoadProgram(0, text_));
  go_ahead_ = f.tab.desk().until_stopped();
}

/// From then on its text is kept with the others.
void Contour::put_into_program(Frame& f) {
  f.tab.desk().texts.set_text(0, text_);
  (stairs_shown_ ? stairs_unkept_ : contour_unkept_) = false;
  f.show_panel("program");
}

std::string_view Contour::unkept() const {
  if (contour_unkept_ && !pieces_.empty()) return "The contour is in no file and not in the program.";
  if (stairs_unkept_ && !stairs_.empty()) return "The staircase is in no file and not in the program.";
  return {};
}

void Contour::follow(Frame& f) {
  const auto ended = [&](IntentId& id) {
    if (f.now.forgotten(id)) id = 0;
    const IntentOutcome* outcome = f.now.outcome_of(id);
    if (!outcome || outcome->state == IntentState::pending) return false;
    id = 0;
    if (outcome->state == IntentState::done) return true;
    if (&id != &starting_ || !doubt_.take_refusal(f, *outcome))
      f.toast(Severity::fault, std::string(outcome->sentence.view()));
    return false;
  };
  // After a stop, or with another panel in front, the loaded program is not started.
  const int frame = ImGui::GetFrameCount();
  const bool was_away = frame - std::exchange(drawn_frame_, frame) > 1;
  if (was_away && loading_ != 0 && !go_ahead_.expired())
    f.toast(Severity::warn,
            "The list was loaded and is not started: another panel came to the front meanwhile.");
  if (was_away || f.ui.cancelled() || go_ahead_.expired()) loading_ = starting_ = 0;
  if (loading_ && ended(loading_)) starting_ = doubt_.send(f, intent::RunProgram(0, places_));
  if (starting_) ended(starting_);
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
    if (const IntentId sent = doubt_.draw(f, "contour", "Run", begun.rect)) starting_ = sent;
  ImGui::SetCursorScreenPos(ImVec2(begun.rect.max.x + ui.px(8), begun.rect.min.y));
  ButtonOptions put;
  put.height = 40;
  if (!problem_.empty())
    put.disabled = problem_;
  else if (text_.empty())
    put.disabled = "There is no text yet.";
  put.tip = "Puts the text into the program editor.";
  if (button(ui, "contour/to_program", "To the program", put).clicked) {
    asking_ = !f.tab.desk().texts.text(0).empty();
    if (!asking_) put_into_program(f);
  }
  const float after = ImGui::GetItemRectMax().x + ui.px(16);
  ImGui::SetCursorScreenPos(ImVec2(after, at.y + ui.px(12)));
  if (const int kind = segment(ui, "contour/kind", kinds, stairs_shown_ ? 1 : 0, {.cell_width = 84});
      kind >= 0) {
    stairs_shown_ = kind == 1;
    changed_ = true;
  }
  const bool empty = stairs_shown_ ? stairs_.empty() : pieces_.empty();
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
    subject.path = path_;
    subject.none = problem_.empty() ? "Nothing to draw yet." : std::string_view();  // it stands below
    subject.axes = {AxisId{static_cast<std::uint8_t>(first_)}, AxisId{static_cast<std::uint8_t>(second_)}};
    subject.words = facts_;
    return canvas_.draw(f, "contour/view", subject, width, height);
  }
  PlotOptions o;
  const Path title("speed, {}, over position", stairs_unit_.of_speed);
  o.title = title;
  o.x_unit = stairs_unit_.name;
  o.width = width, o.height = height;
  o.empty = "Add a step.";
  const PlotTrace trace{stair_x_, stair_y_, Tone::ink, 2, false, "speed", true};
  if (!stair_x_.empty()) o.x = {stair_x_.front(), stair_x_.back()};
  o.y = {0, 0};
  o.y.take(stair_y_);
  o.y.widen(0.08f);
  o.x.widen(0.03f);
  const Path words("{} steps", stairs_.size());
  o.words = words;
  plot(f.ui, "stairs/view", "Speeds over positions", {&trace, stairs_.empty() ? 0u : 1u}, o, cursor_);
}

void Contour::draw_text(Frame& f, float width) {
  Ui& ui = f.ui;
  gap(ui, 8);
  if (!problem_.empty()) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool begun = stairs_shown_ ? !stairs_.empty() : !pieces_.empty();  // empty input is no fault
    wrapped(ui, Face::body, begun ? Tone::fault : Tone::ink2, problem_, width);
    show(ui, {"contour/problem", Kind::text, "Problem", problem_},
         {at, ImVec2(at.x + ui.px(width), ImGui::GetCursorScreenPos().y)});
  } else if (!facts_.empty()) {
    named_text(ui, "contour/facts", Face::small, Tone::ink2, facts_);
  }
  gap(ui, 4);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  // The lines of the text, in as many columns as needed.
  std::string_view rest = text_;
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
  show(ui, {"contour/text", Kind::text, "What is sent", text_}, {at, ImVec2(at.x + ui.px(width), bottom)});
  ImGui::SetCursorScreenPos(ImVec2(at.x, deepest));
  gap(ui, 8);
}

void Contour::draw_dialogs(Frame& f) {
  if (const auto sequence = file_.draw_open(f)) opened(f, *sequence);
  if (const auto path = file_.draw_save(f)) {
    const auto list = shown_list();
    if (list)
      file_.save(f, *path, *list);
    else
      f.toast(Severity::fault, list.error().sentence());
  }
  if (file_.take_saved()) (stairs_shown_ ? stairs_unkept_ : contour_unkept_) = false;
  if (!asking_) return;
  const Dialog what{.title = "Replace the program text?",
                    .sentences = "The editor holds another text. Unsaved changes are lost.",
                    .yes = "Replace",
                    .no = "Keep the text"};
  if (dialog(f.ui, "contour/replace", asking_, what) == Answer::yes) put_into_program(f);
}

}  // namespace hw::panels
