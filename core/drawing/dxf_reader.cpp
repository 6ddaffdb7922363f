#include "core/drawing/dxf_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/drawing/dxf_blocks.h"
#include "core/drawing/dxf_places.h"

namespace hw::drawing {
namespace {

constexpr std::size_t most_curves = 5'000'000;
constexpr int deepest_insert = 16;

/// AutoCAD's numbers; 0: no unit. The last four are US survey units.
std::string unit_of(int insunits) {
  static constexpr std::array<const char*, 25> units{
      "",   "in", "ft",  "mi", "mm", "cm", "m",  "km", "uin",   "mil",   "yd",    "angstrom", "nm",
      "um", "dm", "dam", "hm", "Gm", "au", "ly", "pc", "us-ft", "us-in", "us-yd", "us-mi"};
  return insunits > 0 && ix(insunits) < units.size() ? units[ix(insunits)] : "";
}

bool is_finite(const std::vector<Curve>& curves) {
  return std::all_of(curves.begin(), curves.end(), [](const Curve& c) {
    return std::isfinite(c.from.x) && std::isfinite(c.from.y) && std::isfinite(c.to.x) &&
           std::isfinite(c.to.y) && std::isfinite(c.centre.x) && std::isfinite(c.centre.y) &&
           std::isfinite(c.degrees);
  });
}

/// Places the blocks at their inserts.
class InsertPlacing {
 public:
  InsertPlacing(DxfFile& file, const Tolerance& tolerance, Drawing& drawing)
      : file_(file), tolerance_(tolerance), drawing_(drawing) {
    for (std::size_t i = 0; i < file.layers.size(); ++i)
      layers_.emplace(file.layers[i].name, static_cast<int>(i));
  }

  Result<> run(const std::string& name) {
    place(file_.model, Affine(), "0", nullptr, 0);
    if (curves_ <= most_curves) return {};
    return fail(FaultKind::text, fmt::format("{} draws more than {} lines and arcs.", name, most_curves),
                "Nothing was loaded from it.",
                "Blocks that are inserted many times in other blocks can cause this.");
  }

 private:
  /// `outermost`: the model's insert that contains the block; null: the model itself.
  void place(const DxfBlock& block, const Affine& affine, const std::string& layer,
             const DxfEntity* outermost, int depth) {
    const bool frozen = outermost && file_.frozen.contains(layer);
    for (const DxfEntity& entity : block.entities) {
      if (curves_ > most_curves) return;
      // Entities on layer 0 take the layer of their insert, and so do all within a frozen one.
      const std::string& own = entity.layer == "0" || frozen ? layer : entity.layer;
      const DxfEntity& named = outermost ? *outermost : entity;
      if (!entity.shapes.empty()) draw_path(entity, affine, own, named);
      for (const DxfInsert& insert : entity.inserts) place_insert(insert, affine, own, named, depth);
    }
  }

  void draw_path(const DxfEntity& entity, const Affine& affine, const std::string& layer,
                 const DxfEntity& named) {
    Path path;
    path.entity = named.number, path.line = named.line;
    for (const Shape& shape : entity.shapes) draw(moved(shape, affine), tolerance_, path.curves);
    for (std::size_t i = 1; i < path.curves.size(); ++i) path.curves[i].from = path.curves[i - 1].to;
    double length = 0;
    for (const Curve& curve : path.curves) length += curve.length();
    if (!std::isfinite(length) || !is_finite(path.curves)) return leave_out(named, "it is too large");
    if (length == 0 && entity.name != "POINT") return leave_out(named, "it has no length");
    close(path, length);
    path.layer = layer_of(layer);
    curves_ += path.curves.size();
    drawing_.paths.push_back(std::move(path));
  }
  /// Joins ends that differ only by rounding.
  static void close(Path& path, double length) {
    constexpr double rounding = 1e-9;
    const Point begin = path.curves.front().from;
    Point& end = path.curves.back().to;
    if (std::hypot(end.x - begin.x, end.y - begin.y) <= rounding * length) end = begin;
  }

  void place_insert(const DxfInsert& insert, const Affine& affine, const std::string& layer,
                    const DxfEntity& named, int depth) {
    const auto block = file_.blocks.find(insert.block);
    if (block == file_.blocks.end())
      return leave_out(named, fmt::format("there is no block {}", insert.block));
    const bool inside_itself = std::find(open_.begin(), open_.end(), &block->second) != open_.end();
    if (inside_itself) return leave_out(named, fmt::format("block {} contains itself", insert.block));
    if (depth >= deepest_insert) return leave_out(named, fmt::format("blocks are nested {} deep", depth));
    open_.push_back(&block->second);
    const Affine to_base{1, 0, 0, 1, -block->second.base.x, -block->second.base.y};
    const std::size_t before = curves_;
    bool draws = true;  // if one copy draws nothing, none does
    for (int r = 0; r < insert.rows && draws; ++r)
      for (int c = 0; c < insert.columns && draws; ++c) {
        Affine copy = insert.place;
        copy.e += c * insert.column.x + r * insert.row.x;
        copy.f += c * insert.column.y + r * insert.row.y;
        place(block->second, affine.after(copy).after(to_base), layer, &named, depth + 1);
        draws = curves_ > before && curves_ <= most_curves;
      }
    open_.pop_back();
  }

  int layer_of(const std::string& name) {
    const auto [at, is_new] = layers_.emplace(name, static_cast<int>(drawing_.layers.size()));
    if (is_new) drawing_.layers.push_back({name, true});
    return at->second;
  }
  void leave_out(const DxfEntity& entity, std::string why) {
    const auto& named = drawing_.left_out;
    if (!named.empty() && named.back().entity == entity.number && named.back().why == why) return;
    drawing_.left_out.push_back({std::string(entity.name), std::move(why), entity.number, entity.line});
  }

  DxfFile& file_;
  const Tolerance& tolerance_;
  Drawing& drawing_;
  std::map<std::string, int, LessName> layers_;
  std::vector<const DxfBlock*> open_;  ///< from the model to here
  std::size_t curves_ = 0;
};

}  // namespace

/// The parser loops for ever on a line longer than its buffer. Numbers and names are shorter, so only texts
/// are cut. The parser does not recognise a name with blanks around it either.
static constexpr std::size_t longest_parsed_line = 1000;

static std::string with_plain_lines(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, std::min(end, longest_parsed_line));
    const std::size_t first = std::min(line.find_first_not_of(" \t\r"), line.size());
    line = line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
    out.append(line) += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

Result<Drawing> read_dxf(std::string_view text, const std::string& name, const Tolerance& tolerance) {
  auto scanned = scan_dxf(text, name);
  if (!scanned) return fail(scanned.error());
  std::string plain;
  if (scanned->longest_line > longest_parsed_line || scanned->padded_names)
    scanned->text = plain = with_plain_lines(scanned->text);
  auto file = read_blocks(scanned->text, scanned->entities, name);
  if (!file) return fail(file.error());
  Drawing drawing;
  drawing.layers = file->layers;
  drawing.left_out = std::move(file->left_out);
  drawing.understood = std::move(file->understood);
  drawing.unit = unit_of(file->unit);
  drawing.version = std::move(file->version);
  auto placed = InsertPlacing(*file, tolerance, drawing).run(name);
  if (!placed) return fail(placed.error());
  find_places(text, drawing.left_out);
  return drawing;
}

}  // namespace hw::drawing
