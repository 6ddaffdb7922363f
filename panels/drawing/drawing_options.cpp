#include "panels/drawing/drawing_options.h"

#include <algorithm>
#include <utility>

#include "gui/widgets/area.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

void DrawingOptions::begin(const Frame& f) {
  if (std::exchange(begun_, true)) return;
  place_.begin(f);
  tool_.begin(f);
}

void DrawingOptions::settle(const Frame& f, const drawing::Drawing* drawing) {
  if (!std::exchange(changed_, false)) return;
  ConversionOptions o;
  place_.put(f, o);
  tool_.put(f, o);
  o.keep_order = keep_order_, o.without = without_;
  if (drawing && !left_out_.empty())
    for (const drawing::Layer& layer : drawing->layers)
      if (layer.shown && std::find(left_out_.begin(), left_out_.end(), layer.name) == left_out_.end())
        o.layers.push_back(layer.name);
  wanted_ = std::move(o);
  ++version_;
}

void DrawingOptions::draw(Frame& f, const drawing::Drawing* drawing) {
  changed_ |= place_.draw(f, drawing);
  changed_ |= tool_.draw(f, axes());
  changed_ |= toggle_option(f, "drawing/keep_order", "Keep the order of the file", keep_order_);
  group_line(f.ui);
  if (drawing) draw_layers(f, *drawing);
}

void DrawingOptions::draw_layers(Frame& f, const drawing::Drawing& drawing) {
  section_title(f.ui, "Layers");
  for (const drawing::Layer& layer : drawing.layers) {
    const auto found = std::find(left_out_.begin(), left_out_.end(), layer.name);
    ToggleOptions o;
    o.state = layer.shown && found == left_out_.end() ? ToggleState::on : ToggleState::off;
    o.word = o.state == ToggleState::on ? "drawn" : "left out";
    if (!layer.shown) o.disabled = "It is frozen or off in the file.";
    const Path id("drawing/layer/{}", layer.name);
    if (toggle_lamp(f.ui, id, layer.name.empty() ? std::string_view("without a name") : layer.name, o)
            .clicked) {
      if (found == left_out_.end())
        left_out_.push_back(layer.name);
      else
        left_out_.erase(found);
      changed_ = true;
    }
    gap(f.ui, 4);
  }
  group_line(f.ui);
}

}  // namespace hw::panels
