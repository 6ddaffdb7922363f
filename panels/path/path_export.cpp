#include "panels/path/path_export.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/drawing/path_svg.h"
#include "core/session/user_files.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/surface/offscreen.h"
#include "gui/surface/path_picture.h"
#include "gui/widgets/button.h"

namespace hw::panels {

using namespace gui;
namespace {

std::uint32_t over_white(std::uint32_t pixel) {
  const unsigned alpha = pixel >> IM_COL32_A_SHIFT & 255u;
  std::uint32_t out = IM_COL32_A_MASK;
  for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT})
    out |= ((pixel >> shift & 255u) * alpha + 255u * (255u - alpha)) / 255u << shift;
  return out;
}

/// As its name ends: lines, in the unit of the axes where they are seen as they are, or pixels. Long.
Result<> write_picture(const PathExport::What& what, const std::filesystem::path& file) {
  if (file.extension() != ".png")
    return write_file(file, drawing::path_svg(flattened(*what.path, what.projection),
                                              what.projection.flat() ? what.unit : ""));
  constexpr int width = 1600, height = 1200;
  PathLook look;
  look.tool_on = IM_COL32(0, 0, 0, 255), look.tool_off = IM_COL32(136, 136, 136, 255);
  look.dash = 5, look.dash_gap = 4;
  const drawing::PathView view(what.path->bounds, what.projection, width, height,
                               what.equal || !what.projection.flat());
  Picture picture = path_picture(std::array{PathLayer{what.path.get(), look}}, view);
  for (std::uint32_t& p : picture.pixels) p = over_white(p);
  return write_png(file.string(), picture.pixels, width, height);
}

}  // namespace

void PathExport::draw_button(Frame& f, std::string_view label, bool can) {
  if (button(f.ui, "path/save", label,
             {.style = ButtonStyle::quiet,
              .disabled = can ? "" : "There is no path yet.",
              .tip = "As SVG in the units of the axes, or as PNG.",
              .height = 40})
          .clicked)
    dialog_.ask_save("Save the path", dialog_.folder() / "path.svg", {".svg", ".png"});
}

void PathExport::draw_dialog(Frame& f, const What& what) {
  const auto file = dialog_.draw(f.ui);
  if (!file || !what.path) return;
  Desk& desk = f.tab.desk();
  desk.worker().run([what, file = *file] { return write_picture(what, file); },
                    [&console = f.console, file = *file](Result<> written) {
                      if (!written) return console.toast(Mood::fault, written.error().sentence());
                      console.toast(Mood::ok, fmt::format("Saved as {}.", file.string()));
                    },
                    desk.alive());
}

}  // namespace hw::panels
