#include "panels/drawing/drawing_tab.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/pieces_together.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"
#include "gui/widgets/area.h"
#include "gui/widgets/button.h"
#include "gui/widgets/message.h"
#include "gui/widgets/text.h"
#include "panels/drawing/drawn_together.h"
#include "panels/lines.h"
#include "panels/measures.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr float drawing_side = 288, both_width = 620, both_height = 480, chains_height = 216,
                bar_and_picture = 240, why_outline_height = 56;

}  // namespace

static std::optional<Catalog> catalog_of(const Bus& bus) {
  std::vector<const Catalog*> all;
  for (const Tab* member : bus.members) all.push_back(&member->catalog());
  return catalog_together(all);
}

void DrawingTab::draw(Frame& own) {
  if (own.tab.bus && !together_) together_ = catalog_of(*own.tab.bus);
  Frame f{own, own.tab, together_ ? *together_ : own.catalog, own.now, own.bench};
  draw_all(f);
}

void DrawingTab::draw_all(Frame& f) {
  options_.begin(f);
  take_dropped(f);
  if (std::exchange(opened_, job_.opened()) != job_.opened()) options_.forget_file();
  options_.settle(f, job_.drawing());
  job_.follow(f, options_.wanted(), options_.version(), scale_of(f));
  facts_.follow(job_, options_.wanted());
  draw_toolbar(f);
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float height = (f.ui.px(f.area.bottom()) - top.y) / f.ui.scale;
  const bool side = f.area.width >= both_width;
  const float width = f.area.width - (side ? drawing_side : 0);
  settings_ = settings_ && !side;
  if (!settings_) draw_picture(f, width, height);
  if (side || settings_) {
    ImGui::SetCursorScreenPos(ImVec2(f.ui.px(f.area.x + (side ? width : 0)), top.y));
    draw_side(f, height);
  }
  draw_dialogs(f);
}

/// Takes dropped files; on a bus those of all its controllers.
void DrawingTab::take_dropped(Frame& f) {
  const auto take = [&](Tab& tab) {
    for (const auto& path : tab.desk().take_dropped("drawing")) open(f, path);
  };
  if (!f.tab.bus) return take(f.tab);
  for (Tab* member : f.tab.bus->members) take(*member);
}

/// Units of the axes per mm. Several controllers draw in mm.
drawing::Point DrawingTab::scale_of(const Frame& f) const {
  const ConversionOptions& wanted = options_.wanted();
  const auto units = [&](std::size_t direction) {
    if (draws_together(f) || direction >= wanted.axes.size()) return 1.0;
    const AxisId axis{static_cast<std::uint8_t>(options_.axes()[direction])};
    return wanted.axes[direction].per_unit * from_steps(Steps(1), f.tab.settings.unit(axis));
  };
  return {units(0), units(1)};
}

PathSubject DrawingTab::subject_of(const Frame& f) {
  const DrawingJob::Made* made = job_.made();
  PathSubject subject;
  if (made) subject.path = made->path, subject.commanded = made->meant;
  if (const auto outline = job_.outline()) subject.path = {outline, &outline->path};
  subject.none = job_.busy()      ? "Calculating."
                 : job_.drawing() ? "Nothing in it can be drawn with these settings."
                                  : "Open a DXF file, or drop one on the window.";
  const auto axis = [&](std::size_t direction) {
    return AxisId{static_cast<std::uint8_t>(options_.axes()[direction])};
  };
  if (f.catalog.axes.size() > 1) subject.axes = {axis(0), axis(1)};
  const ConversionOptions& wanted = options_.wanted();
  if (const auto& limits = wanted.table) {
    const drawing::Point scale = job_.scale();
    subject.table.add(drawing::Point3(limits->low.x * scale.x, limits->low.y * scale.y));
    subject.table.add(drawing::Point3(limits->high.x * scale.x, limits->high.y * scale.y));
  }
  if (!draws_together(f) || wanted.axes.size() < 2) return subject;
  subject.own = OwnPlane{"mm", {}, {}};
  std::array<double, 2> here{};
  for (const std::size_t d : {0, 1}) {
    const Tab& owner = owner_of(f, options_.axes()[d]);
    const AxisState& state = owner.now().axes[0];
    if (!owner.now().link.connected() || !state.position_known) return subject;
    here[d] = static_cast<double>(state.position.value) / wanted.axes[d].per_unit;
  }
  here_ = fmt::format("{:.3f}, {:.3f} mm", here[0], here[1]);
  subject.own->here = drawing::Point3(here[0], here[1]), subject.own->here_words = here_;
  return subject;
}

/// Draws the missing options below the outline of a drawing that cannot be made yet.
void DrawingTab::draw_why_outline(Frame& f, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect in{ImVec2(at.x + f.ui.px(16), at.y + f.ui.px(6)),
                ImVec2(at.x + f.ui.px(width - 16), at.y + f.ui.px(why_outline_height))};
  draw_text_in_lines(f.ui, in, Face::small, f.ui[Tone::warn], job_.fault(), 3);
  show(f.ui, {"drawing/outline", Kind::text, "Outline", job_.fault()}, in);
}

/// The chains are below the picture if both fit, or at least the buttons of the chosen chain.
void DrawingTab::draw_picture(Frame& f, float width, float height) {
  const DrawingJob::Made* made = job_.made();
  const float chains = job_.outline()              ? why_outline_height
                       : !made                     ? 0
                       : height >= both_height     ? chains_height
                       : height >= bar_and_picture ? DrawingChains::bar_height
                                                   : 0;
  PathSubject subject = subject_of(f);
  if (made && chains > 0) subject.lit = chains_table_.chosen();
  if (const int chain = run_.chain_at_work(f, made); chain >= 0) {
    TrackAxes tool;
    take_tool_of(made->conversion.sequence, f.catalog, tool);
    subject.lit = chain, subject.at_work = true;
    subject.tool_on = tool_on_now(f, tool, made->conversion.sequence);
  }
  const ImVec2 top = ImGui::GetCursorScreenPos();
  canvas_.draw(f, "drawing/view", subject, width, height - chains);
  draw_pointer(f, {top, ImVec2(top.x + f.ui.px(width), top.y + f.ui.px(height - chains))});
  take_click();
  if (chains == 0) return;
  ImGui::SetCursorScreenPos(ImVec2(top.x, top.y + f.ui.px(height - chains)));
  if (!made) return draw_why_outline(f, width);
  const DrawingChains::Shown shown{*job_.drawing(), made->conversion, made->chain_seconds, job_.busy(),
                                   options_.draws_all()};
  const int out = chains_table_.may_be_left_out(made->conversion);
  const auto request = chains_table_.draw(f, shown, width, chains);
  if (request == DrawingChains::Request::nothing) return;
  chains_table_.choose(-1);
  if (request == DrawingChains::Request::leave_out)
    options_.leave_out(made->conversion.chains[ix(out)].paths);
  else
    options_.draw_all();
}

/// The pointer's position on the table, in mm.
void DrawingTab::draw_pointer(Frame& f, const Rect& view) const {
  const auto& at = canvas_.measured().pointer;
  const drawing::Point scale = job_.scale();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool over =
      mouse.x >= view.min.x && mouse.x < view.max.x && mouse.y >= view.min.y && mouse.y < view.max.y;
  if (!job_.drawing() || !at || !over || scale.x == 0 || scale.y == 0) return;
  const Path words("{:.2f}, {:.2f} mm", at->x / scale.x, at->y / scale.y);
  const ImVec2 right(view.max.x - f.ui.px(16), view.min.y + f.ui.px(10));
  draw_text_right(f.ui, right, Face::small, f.ui[Tone::ink2], words);
  show(f.ui, {"drawing/pointer", Kind::text, "Pointer", words},
       {ImVec2(right.x - f.ui.px(120), right.y), ImVec2(right.x, right.y + f.ui.px(16))});
}

void DrawingTab::open(Frame& f, const std::filesystem::path& path) {
  ConversionOptions wanted = options_.wanted();
  wanted.drawing_unit.clear();  // the unit belonged to another file
  job_.open(f, path, wanted);
}

std::string_view DrawingTab::why_not() const {
  if (!job_.drawing()) return "No drawing has been opened.";
  if (job_.busy()) return "Calculating.";
  if (!options_.wrong().empty()) return options_.wrong();
  if (!job_.made()) return job_.fault();
  return {};
}

std::string_view DrawingTab::why_no_use(const Frame& f, Use use) const {
  if (job_.drawing() && job_.busy()) return {};
  if (const auto why = why_not(); !why.empty()) return why;
  if (use == Use::frame) return run_.why_no_trace(f, job_.made());
  if (together_) return "Several controllers draw it together, so there is no single text.";
  return use == Use::program ? std::string_view(job_.made()->problem) : std::string_view();
}

void DrawingTab::draw_use(Frame& f, Use use, std::string_view id, std::string_view label, float gap,
                          ButtonOptions look) {
  look.disabled = why_no_use(f, use);
  next_in_toolbar(f, gap, button_width(f.ui, label, look));
  look.on = wanted_ == use;
  if (button(f.ui, id, label, look).clicked) wanted_ = use;
}

void DrawingTab::use(Frame& f, Use use) {
  if (!why_no_use(f, use).empty()) return;
  if (use == Use::program) return ask_or_put(f, job_.made()->written.text);
  if (use == Use::frame) return run_.trace_frame(f, job_.shared_made());
  asking_blocks_ = f.tab.desk().blocks.edited();
  if (!asking_blocks_) to_blocks(f);
}

void DrawingTab::to_blocks(Frame& f) {
  f.tab.desk().blocks.became(job_.made()->conversion.sequence);
  f.show_panel("blocks");
}

/// Makes the clicked point 0, 0, or chooses the clicked chain.
void DrawingTab::take_click() {
  const DrawingJob::Made* made = job_.made();
  const auto outline = job_.outline();
  if ((!made && !outline) || job_.busy()) return;
  if (const auto& hit = canvas_.clicked(); hit && made && !options_.wants_origin())
    chains_table_.choose(made->path->runs[hit->run].source);
  const auto& place = canvas_.clicked_place();
  if (!place || !options_.wants_origin()) return;
  const drawing::Point scale = job_.scale();
  const drawing::Affine& placed = made ? made->conversion.placed : outline->placed;
  options_.set_origin(placed.undone({place->x / scale.x, place->y / scale.y}));
}

void DrawingTab::ask_or_put(Frame& f, std::string text) {
  to_put_ = std::move(text);
  asking_program_ = f.tab.desk().programs.texts.edited(f.tab.desk().programs.texts.chosen());
  if (!asking_program_) put(f);
}

void DrawingTab::put(Frame& f) {
  ProgramTexts& texts = f.tab.desk().programs.texts;
  const DrawingJob::Made* made = job_.made();
  if (made && made->written.text == to_put_)
    f.tab.desk().programs.source.put(
        {std::make_shared<const sequence::Sequence>(made->conversion.sequence), made->written});
  texts.set_text(texts.chosen(), std::exchange(to_put_, {}));
  f.show_panel("program");
}

// ---- drawing

void DrawingTab::draw_toolbar(Frame& f) {
  Ui& ui = f.ui;
  if (wanted_ != Use::nothing && !job_.busy()) use(f, std::exchange(wanted_, Use::nothing));
  const ImVec2 top = begin_toolbar(f);
  ButtonOptions look;
  look.height = 40;
  if (button(ui, "drawing/open", "Open DXF", look).clicked)
    open_.ask_open("Open a drawing", open_.folder(), {".dxf"});
  draw_use(f, Use::blocks, "drawing/to_blocks", "To the blocks", 8, look);
  draw_use(f, Use::program, "drawing/to_program", "To the program", 8, look);
  look.style = ButtonStyle::quiet, look.tip = "Goes once around it with the tool off.", look.moving = true;
  draw_use(f, Use::frame, "drawing/frame", "Frame", 8, look);
  look.tip = {}, look.moving = false;
  next_in_toolbar(f, 0, button_width(ui, "Fit", look));
  if (button(ui, "drawing/fit", "Fit", look).clicked) canvas_.fit();
  if (f.area.width < both_width) {
    const std::string_view other = settings_ ? "Drawing" : "Settings";
    next_in_toolbar(f, 0, button_width(ui, other, look));
    if (button(ui, "drawing/settings", other, look).clicked) settings_ = !settings_;
  }
  const std::string name = job_.file().filename().string();
  const ImVec2 end = ImGui::GetItemRectMax();
  draw_text_line(ui, end.x + ui.px(16), ui.px(f.area.right() - 16), end.y - ui.px(20), Face::body_bold,
                 ui[Tone::ink], name);
  end_toolbar(f, top);
}

/// The run controls stay in place while the rest is scrolled.
void DrawingTab::draw_side(Frame& f, float height) {
  constexpr float most_of_it = 0.6f;
  Ui& ui = f.ui;
  draw_line_down(f);
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float run = std::min(run_height_, height * most_of_it);
  begin_part(ui, "drawing/run", 0, ui.px(run), Tone::panel, 16);
  gap(ui, 12);
  draw_run(f);
  run_height_ = ImGui::GetCursorPosY() / ui.scale;
  end_part();
  ImGui::SetCursorScreenPos(ImVec2(top.x, top.y + ui.px(run)));
  begin_part(ui, "drawing/side", 0, ui.px(height - run), Tone::panel, 16);
  facts_.draw(f, job_);
  options_.draw(f, job_.drawing());
  facts_.draw_left_out(f);
  gap(ui, 16);
  end_part();
}

void DrawingTab::draw_run(Frame& f) {
  const bool nothing = job_.busy() || !options_.wrong().empty();
  DrawingRun::Wanted wanted{nothing ? nullptr : job_.shared_made(), why_not(), facts_.time(), facts_.moves(),
                            job_.drawing() && job_.busy()};
  if (wanted.made && wanted.made->parts.empty()) wanted.why_not = wanted.made->no_pieces;
  run_.draw(f, wanted);
  group_line(f.ui);
}

void DrawingTab::draw_dialogs(Frame& f) {
  if (asking_blocks_) {
    const Dialog what{.title = "Replace the blocks?",
                      .sentences = "The blocks have unsaved changes.",
                      .yes = "Replace",
                      .no = "Keep them"};
    if (dialog(f.ui, "drawing/replace_blocks", asking_blocks_, what) == Answer::yes && why_not().empty())
      to_blocks(f);
  }
  if (asking_program_) {
    const Dialog what{.title = "Replace the text?",
                      .sentences = "The program has unsaved changes. The drawing would replace it.",
                      .yes = "Replace",
                      .no = "Keep the text"};
    if (dialog(f.ui, "drawing/replace_text", asking_program_, what) == Answer::yes) put(f);
  }
  run_.draw_dialog(f);
  if (const auto path = open_.draw(f.ui)) open(f, *path);
}

}  // namespace hw::panels
