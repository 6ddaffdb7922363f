#include "panels/drawing/drawing_options.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "gui/model/bus.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/widgets/area.h"
#include "gui/widgets/lamp.h"
#include "gui/widgets/text.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

/// The profile key; on a bus that of its first controller, whichever is in front.
static const std::string& key_of(const Frame& f) {
  return f.tab.bus ? f.tab.bus->members.front()->settings.key : f.tab.settings.key;
}

void DrawingOptions::begin(const Frame& f) {
  if (std::exchange(begun_, true)) return;
  place_.begin(f);
  tool_.begin(f);
  auto kept = KeptOptionsOfDrawings(f.console.folders()).load(key_of(f));
  if (!kept) return f.toast(Severity::warn, kept.error().sentence());
  kept_ = std::move(*kept);
  place_.take(f, kept_);
  tool_.take(f, kept_);
  if (const double* keep_order = kept_.number("drawing/keep_order")) keep_order_ = *keep_order != 0;
}

void DrawingOptions::keep(const Frame& f) {
  KeptOptions now;
  place_.keep(f, now);
  tool_.keep(f, now);
  now.numbers["drawing/keep_order"] = keep_order_ ? 1 : 0;
  if (now == kept_) return;
  const bool first = kept_.numbers.empty();
  kept_ = std::move(now);
  if (first || !f.console.folders().enabled) return;  // the user has made no choice yet
  f.tab.desk().work.worker().run([store = KeptOptionsOfDrawings(f.console.folders()), key = key_of(f),
                                  kept = kept_] { return store.save(key, kept); },
                                 [&console = f.console](const Result<>& saved) {
                                   if (!saved) console.toast(Severity::warn, saved.error().sentence());
                                 },
                                 alive_);
}

bool DrawingOptions::is_drawn(const drawing::Layer& layer) const {
  const bool other = std::find(other_layers_.begin(), other_layers_.end(), layer.name) != other_layers_.end();
  return layer.shown != other;
}

void DrawingOptions::choose_layers(const drawing::Drawing& drawing, ConversionOptions& o) const {
  for (const drawing::Layer& layer : drawing.layers)
    if (is_drawn(layer)) o.layers.push_back(layer.name);
  if (!o.layers.empty())
    return;  // else draw none, because an empty list would mean all layers that the file shows
  o.without.resize(drawing.paths.size());
  std::iota(o.without.begin(), o.without.end(), 0);
}

void DrawingOptions::settle(const Frame& f, const drawing::Drawing* drawing) {
  changed_ |= place_.follow_units(f);
  changed_ |= tool_.follow_units(f);
  if (!std::exchange(changed_, false)) return;
  ConversionOptions o;
  place_.put(f, o);
  tool_.put(f, o);
  o.keep_order = keep_order_, o.without = without_;
  if (drawing && !other_layers_.empty()) choose_layers(*drawing, o);
  wrong_ = place_.wrong();
  if (wrong_.empty()) wrong_ = tool_.wrong();
  wanted_ = std::move(o);
  ++version_;
  keep(f);
}

void DrawingOptions::draw(Frame& f, const drawing::Drawing* drawing) {
  changed_ |= place_.draw(f, drawing);
  changed_ |= tool_.draw(f, axes(), place_.form());
  changed_ |= toggle_option(f, "drawing/keep_order", "Keep the order of the file", keep_order_);
  group_line(f.ui);
  if (drawing) draw_layers(f, *drawing);
}

void DrawingOptions::draw_layers(Frame& f, const drawing::Drawing& drawing) {
  if (std::exchange(counted_of_, &drawing) != &drawing) on_layer_ = drawing::entities_by_layer(drawing);
  section_title(f.ui, "Layers");
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    const drawing::Layer& layer = drawing.layers[i];
    if (on_layer_[i] == 0) continue;
    const bool drawn = is_drawn(layer);
    const std::string_view hidden = layer.frozen ? "frozen" : "off";
    const Path word("{}, {}", on_layer_[i], drawn ? "drawn" : layer.shown ? "left out" : hidden);
    const Path tip("Choose the layer to draw it: it is {} in the file, and left out otherwise.", hidden);
    ToggleOptions o;
    o.state = drawn ? ToggleState::on : ToggleState::off;
    o.word = word;
    if (!layer.shown) o.tip = tip;
    const Path id("drawing/layer/{}", layer.name);
    if (toggle_lamp(f.ui, id, layer.name.empty() ? std::string_view("without a name") : layer.name, o)
            .clicked) {
      const auto other = std::find(other_layers_.begin(), other_layers_.end(), layer.name);
      if (other == other_layers_.end())
        other_layers_.push_back(layer.name);
      else
        other_layers_.erase(other);
      changed_ = true;
    }
    gap(f.ui, 4);
  }
  group_line(f.ui);
}

}  // namespace hw::panels
