#include "panels/path/path_export.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/drawing/path_svg.h"
#include "core/session/user_files.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/surface/offscreen.h"
#include "gui/surface/path_picture.h"
#include "gui/widgets/button.h"
#include "panels/path/path_sheet.h"

namespace hw::panels {

using namespace gui;
namespace {

struct Layer {
  std::string_view name;
  std::shared_ptr<const drawing::ToolPath> path;
  unsigned rgb = 0;
  float width = 1;
  bool directed = false;  ///< has direction arrows
};
/// The data for a worker.
struct Shown {
  std::vector<Layer> layers;  ///< the bottom layer first
  drawing::Projection projection;
  bool equal = true;
  std::string unit, about;
};

/// "X in mm to the right, Y in mm upwards"
std::string about_axes(const Directions& all) {
  static constexpr std::string_view ways[] = {" to the right", " upwards"};
  std::string about;
  for (std::size_t n = 0; n < all.count; ++n)
    about += fmt::format("{}{} in {}{}", n == 0 ? "" : ", ", all.all[n].name, all.all[n].unit().name,
                         all.count > 2 ? "" : ways[n]);
  return all.count > 2 ? about + ", in perspective" : about;
}

Shown shown_by(const Frame& f, const PathSubject& s, const PathCanvas& canvas) {
  const auto shared = [](drawing::ToolPath path) {
    return path.runs.empty() ? nullptr : std::make_shared<const drawing::ToolPath>(std::move(path));
  };
  const KnownLimits limits = limits_of(f, s);
  const bool flat = canvas.projection().flat();
  const auto ends = [&](const std::array<KnownEnds, 3>& known) {
    return shared(lines_of(known, canvas.box(), flat));
  };
  drawing::ToolPath home;  // each axis separately, because the home positions of two axes form no frame
  for (std::size_t n = 0; n < 3; ++n) {
    std::array<KnownEnds, 3> one;
    one[n] = limits.home[n];
    const drawing::ToolPath lines = lines_of(one, canvas.box(), flat);
    for (const drawing::ToolPath::Run& run : lines.runs)
      for (std::size_t i = run.first + 1; i < run.first + run.size; ++i)
        home.go(lines.points[i - 1], lines.points[i], true, -1);
  }
  const Directions all = directions_of(f, s.axes);
  const bool equal = one_unit(f, s);
  return {{{"switches", ends(limits.switches), 0x805200, 1},
           {"travel", ends(limits.travel), 0x805200, 1},
           {"home", shared(std::move(home)), 0x176B3C, 1},
           {"commanded", s.commanded, 0x9B2463, 1},
           {"rehearsed", s.path, 0, 2, true},
           {"trace", shared(canvas.trace()), 0x00647C, 1}},
          canvas.projection(),
          equal || !flat,
          flat && equal ? all.all[0].unit().name : "",
          about_axes(all)};
}

/// The lines as SVG, in the unit of the axes if seen in plan.
std::string svg_of(const Shown& shown) {
  std::vector<drawing::ToolPath> flat(shown.layers.size());
  std::vector<std::string> colours(shown.layers.size());
  std::vector<drawing::SvgLayer> layers;
  for (std::size_t n = 0; n < shown.layers.size(); ++n) {
    const Layer& layer = shown.layers[n];
    if (!layer.path) continue;
    flat[n] = flattened(*layer.path, shown.projection);
    colours[n] = fmt::format("#{:06x}", layer.rgb);
    layers.push_back({layer.name, &flat[n], colours[n], static_cast<double>(layer.width), layer.directed});
  }
  return drawing::path_svg(layers, {shown.unit, shown.about});
}

drawing::Box3 box_of(const Shown& shown) {
  drawing::Box3 box;
  for (const Layer& layer : shown.layers)
    if (layer.path) box.add(layer.path->bounds);
  return box;
}

Result<> write_pixels(const Shown& shown, const PathSheet& sheet, const std::filesystem::path& file) {
  std::vector<PathLayer> layers;
  for (const Layer& layer : shown.layers) {
    if (!layer.path) continue;
    PathLook look;
    look.tool_on = rgb(layer.rgb), look.tool_off = rgb(0x888888);
    look.on_width = layer.width, look.dash = 5, look.dash_gap = 4;
    if (layer.directed) look.arrow_every = 220, look.arrow = 14;
    layers.push_back({layer.path.get(), look});
  }
  const Picture picture = sheet.with(path_picture(layers, sheet.view()));
  return write_png(file.string(), picture.pixels, picture.width, picture.height);
}

/// Writes the file: pixels on `sheet`, or lines if it is null. Slow.
Result<> write_picture(const Shown& shown, const PathSheet* sheet, const std::filesystem::path& file) {
  return sheet ? write_pixels(shown, *sheet, file) : write_file(file, svg_of(shown));
}

}  // namespace

void PathExport::draw_button(Frame& f, std::string_view label, bool wordless, bool can) {
  ButtonOptions look{.style = ButtonStyle::quiet,
                     .disabled = can ? "" : "There is no path yet.",
                     .tip = "Saves the picture as SVG in the units of the axes, or as PNG.",
                     .height = 40};
  if (wordless) look.icon = Icon::save, look.wordless = true, look.width = 36;
  if (button(f.ui, "path/save", label, look).clicked)
    dialog_.ask_save("Save the path", dialog_.folder() / "path.svg", {".svg", ".png"});
}

void PathExport::draw_dialog(Frame& f, const PathSubject& subject, const PathCanvas& canvas) {
  const auto file = dialog_.draw(f.ui);
  if (!file) return;
  Desk& desk = f.tab.desk();
  f.withdraw(&dialog_);  // the message why the picture was not saved
  Shown shown = shown_by(f, subject, canvas);
  std::shared_ptr<const PathSheet> sheet;
  if (file->extension() == ".png")
    sheet = std::make_shared<PathSheet>(f, subject, box_of(shown), shown.projection, shown.equal);
  desk.work.worker().run(
      [shown = std::move(shown), sheet, file = *file] { return write_picture(shown, sheet.get(), file); },
      [&console = f.console, file = *file, attempt = &dialog_](Result<> written) {
        if (!written) return console.toast(Severity::fault, written.error().sentence(), attempt);
        console.toast(Severity::ok, fmt::format("Saved as {}.", file.string()));
      },
      desk.work.alive());
}

}  // namespace hw::panels
