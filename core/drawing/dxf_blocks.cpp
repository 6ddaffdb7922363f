#include "core/drawing/dxf_blocks.h"

#include <algorithm>
#include <cmath>
#include <istream>
#include <numbers>
#include <optional>
#include <streambuf>

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/core.h>

#include "core/drawing/fit_spline.h"

namespace hw::drawing {
namespace {

/// Reads a text in place.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // a get area is only read
    setg(begin, begin, begin + text.size());
  }
};

Point at_angle(double degrees) {
  const double angle = degrees / 180 * std::numbers::pi;
  return {std::cos(angle), std::sin(angle)};
}

/// Receives the parser's callbacks, entity by entity.
class Collector : public DL_CreationAdapter {
 public:
  Collector(DxfFile& file, const std::vector<ScannedEntity>& scanned) : file_(file), scanned_(scanned) {}

  // ---- tables and blocks
  void addLayer(const DL_LayerData& layer) override {
    const bool frozen = (layer.flags & 1) != 0;
    const bool off = layer.off || getAttributes().getColor() < 0;
    if (frozen) file_.frozen.insert(layer.name);
    file_.layers.push_back({layer.name, !frozen && !off, frozen});
  }
  void addBlock(const DL_BlockData& block) override {
    end_of_pieces();
    name_ = "BLOCK", left_out_ = false, taken_ = nullptr;
    if (find_scanned(name_) && scanned_[current_].no_number != 0) {  // its position is unknown
      leave_out(no_number(scanned_[current_]));
      into_ = &without_place_;
      return;
    }
    into_ = &file_.blocks[block.name];
    into_->base = {block.bpx, block.bpy};
  }
  void endBlock() override {
    end_of_pieces();
    into_ = &file_.model;
  }
  void setVariableInt(const std::string& key, int value, int) override {
    if (key == "$INSUNITS") file_.unit = value;
  }
  void setVariableString(const std::string& key, const std::string& value, int) override {
    if (key == "$ACADVER") file_.version = value;
  }

  // ---- entities
  void addPoint(const DL_PointData& p) override {
    begin("POINT");
    put(Line{{p.x, p.y}, {p.x, p.y}});
  }
  void addLine(const DL_LineData& l) override {
    begin("LINE");
    if (l.z1 != l.z2) return leave_out("it is not flat");
    put(Line{{l.x1, l.y1}, {l.x2, l.y2}});
  }
  void addArc(const DL_ArcData& a) override {
    begin("ARC");
    if (!(a.radius > 0)) return leave_out("its radius is not above 0");
    put_in_plane(arc_of({a.cx, a.cy}, a.radius, a.angle1, a.angle2));
  }
  void addCircle(const DL_CircleData& c) override {
    begin("CIRCLE");
    if (!(c.radius > 0)) return leave_out("its radius is not above 0");
    put_in_plane(arc_of({c.cx, c.cy}, c.radius, 0, 360));
  }
  void addEllipse(const DL_EllipseData& e) override {
    begin("ELLIPSE");
    const double size = std::hypot(e.mx, e.my);
    if (e.mz != 0) return leave_out("it is not flat");
    if (!(size > 0) || !(e.ratio > 0)) return leave_out("it has no size");
    const std::optional<bool> mirrored = is_mirrored();
    if (!mirrored) return leave_out("it does not lie in the plane of the drawing");
    const double side = *mirrored ? -e.ratio : e.ratio;
    constexpr double turn = 2 * std::numbers::pi;
    double sweep = std::fmod(e.angle2 - e.angle1, turn);
    if (sweep <= 1e-9) sweep += turn;
    put(Ellipse{{e.cx, e.cy}, {e.mx, e.my}, {-e.my * side, e.mx * side}, e.angle1, e.angle1 + sweep});
  }

  void addPolyline(const DL_PolylineData& p) override {
    begin(next_polyline());
    constexpr int closed = 1, smoothed = 4, in_space = 8, mesh = 16, faces = 64;
    polyline_ = Polyline{(p.flags & closed) != 0, (p.flags & in_space) != 0, is_mirrored(), {}};
    if ((p.flags & (mesh | faces)) != 0) leave_out("it is a mesh");
    if ((p.flags & smoothed) != 0)
      leave_out("it is smoothed by a spline that only the program that made it knows");
    if (!polyline_->mirrored && !polyline_->in_space)
      leave_out("it does not lie in the plane of the drawing");
  }
  void addVertex(const DL_VertexData& v) override {
    if (polyline_) polyline_->vertices.push_back(v);
  }

  void addSpline(const DL_SplineData& s) override {
    begin("SPLINE");
    spline_ = Spline{static_cast<int>(s.degree), {}, {}, {}};
    constexpr int closed = 1;
    fit_ = FitPoints{
        {}, (s.flags & closed) != 0, {s.tangentStartX, s.tangentStartY}, {s.tangentEndX, s.tangentEndY}};
  }
  void addKnot(const DL_KnotData& k) override {
    if (spline_) spline_->knots.push_back(k.k);
  }
  void addControlPoint(const DL_ControlPointData& p) override {
    if (!spline_) return;
    spline_->points.push_back({p.x, p.y});
    spline_->weights.push_back(p.w);
    if (spline_->points.size() == 1) spline_height_ = p.z;
    if (p.z != spline_height_) leave_out("it is not flat");
  }
  void addFitPoint(const DL_FitPointData& p) override {
    if (!spline_) return;
    fit_.points.push_back({p.x, p.y});
    if (fit_.points.size() == 1) fit_height_ = p.z;
    fit_is_flat_ = (fit_is_flat_ || fit_.points.size() == 1) && p.z == fit_height_;
  }

  void addInsert(const DL_InsertData& i) override {
    begin("INSERT");
    const std::optional<bool> mirrored = is_mirrored();
    if (!mirrored) return leave_out("it does not lie in the plane of the drawing");
    if (i.sx == 0 || i.sy == 0) return leave_out("its scale is 0");
    if (left_out_) return;
    const Point along = at_angle(i.angle);
    const Affine turned{along.x * i.sx, along.y * i.sx, -along.y * i.sy, along.x * i.sy, i.ipx, i.ipy};
    DxfInsert insert;
    insert.block = i.name;
    const Affine plane = *mirrored ? Affine::mirror_x() : Affine();
    insert.place = plane.after(turned);
    insert.columns = std::max(i.cols, 1), insert.rows = std::max(i.rows, 1);
    insert.column = plane.turned({along.x * i.colSp, along.y * i.colSp});
    insert.row = plane.turned({-along.y * i.rowSp, along.x * i.rowSp});
    entity().inserts.push_back(std::move(insert));
  }

  // Polylines and splines come in pieces.
  void endEntity() override { end_of_pieces(); }
  void endSequence() override { end_of_pieces(); }

  // ---- what two axes do not draw
  void addXLine(const DL_XLineData&) override { not_drawn("XLINE", "it has no end"); }
  void addRay(const DL_RayData&) override { not_drawn("RAY", "it has no end"); }
  void addTrace(const DL_TraceData&) override { not_drawn("TRACE", "it is a filled area"); }
  void addSolid(const DL_SolidData&) override { not_drawn("SOLID", "it is a filled area"); }
  void add3dFace(const DL_3dFaceData&) override { not_drawn("3DFACE", "it is not flat"); }
  void addMText(const DL_MTextData&) override { not_drawn("MTEXT", text); }
  void addText(const DL_TextData&) override { not_drawn("TEXT", text); }
  void addHatch(const DL_HatchData&) override { not_drawn("HATCH", "it is a filled area"); }
  void addImage(const DL_ImageData&) override { not_drawn("IMAGE", "it is a picture"); }
  void addLeader(const DL_LeaderData&) override { not_drawn("LEADER", dimension); }

  /// After the last entity: the parser has ignored the rest of the scan.
  void end() {
    end_of_pieces();
    pass_over(scanned_.size());
  }

 private:
  static constexpr std::string_view text = "it is a text", dimension = "it belongs to a dimension";

  struct Polyline {
    bool closed = false, in_space = false;
    std::optional<bool> mirrored;
    std::vector<DL_VertexData> vertices;
  };

  /// The parser does not distinguish the old kind from the new.
  [[nodiscard]] std::string_view next_polyline() const {
    for (std::size_t i = next_; i < scanned_.size(); ++i)
      if (scanned_[i].name.ends_with("POLYLINE")) return scanned_[i].name;
    return "POLYLINE";
  }
  /// Part of another entity, or not an entity.
  static bool is_part(std::string_view name) {
    return name == "VERTEX" || name == "SEQEND" || name == "BLOCK" || name == "ENDBLK" || name == "VIEWPORT";
  }
  void pass_over(std::size_t until) {
    for (; next_ < until; ++next_) {
      const ScannedEntity& e = scanned_[next_];
      if (is_part(e.name)) continue;
      std::string what(e.name.empty() ? "an entity without a name" : e.name);
      file_.left_out.push_back(
          {std::move(what), why_passed_over(e.name), static_cast<int>(next_) + 1, e.line});
    }
  }
  static std::string why_passed_over(std::string_view name) {
    if (name == "ATTRIB" || name == "ATTDEF") return std::string(text);
    if (name == "DIMENSION") return std::string(dimension);
    return "it is not drawn with lines and arcs";
  }
  /// Finds the next entity of that name in the scan; the parser has ignored those before it.
  bool find_scanned(std::string_view name) {
    std::size_t at = next_;
    while (at < scanned_.size() && scanned_[at].name != name) ++at;
    if (at == scanned_.size()) return false;
    pass_over(at);
    current_ = next_++;
    return true;
  }

  void begin(std::string_view name) {
    end_of_pieces();
    taken_ = nullptr;
    find_scanned(name);
    name_ = name;
    layer_ = getAttributes().getLayer();  // its points may have another layer
    left_out_ = false;
    if (current_ >= scanned_.size()) return;
    const ScannedEntity& e = scanned_[current_];
    if (e.on_sheet) leave_out("it is in paper space, not in model space");
    if (e.hidden) leave_out("it is hidden in the file");
    if (e.no_number != 0) leave_out(no_number(e));
    if (e.miscounted) leave_out("its number of parts differs from the number it declares");
  }
  static std::string no_number(const ScannedEntity& e) {
    return fmt::format("line {} holds no number", e.no_number);
  }
  void not_drawn(std::string_view name, std::string_view why) {
    begin(name);
    leave_out(why);
  }
  void leave_out(std::string_view why) {
    if (!std::exchange(left_out_, true))
      file_.left_out.push_back({std::string(name_), std::string(why), number(), line()});
    if (taken_) taken_->shapes.clear(), taken_->inserts.clear();
  }
  [[nodiscard]] int number() const { return static_cast<int>(current_) + 1; }
  [[nodiscard]] int line() const { return current_ < scanned_.size() ? scanned_[current_].line : 0; }

  DxfEntity& entity() {
    if (!taken_) {
      into_->entities.push_back({{}, {}, layer_, name_, number(), line()});
      taken_ = &into_->entities.back();
    }
    return *taken_;
  }
  void put(Shape shape) {
    if (!left_out_) entity().shapes.push_back(std::move(shape));
  }
  /// Adds a shape given in the entity's own plane.
  void put_in_plane(const Shape& shape) {
    const std::optional<bool> mirrored = is_mirrored();
    if (!mirrored) return leave_out("it does not lie in the plane of the drawing");
    put(*mirrored ? moved(shape, Affine::mirror_x()) : shape);
  }
  /// Whether the entity is seen from below; none: it lies askew.
  std::optional<bool> is_mirrored() {
    double direction[3] = {0, 0, 1};
    getExtrusion()->getDirection(direction);
    constexpr double upright = 1e-9;
    if (std::fabs(direction[0]) > upright || std::fabs(direction[1]) > upright) return std::nullopt;
    return direction[2] < 0;
  }

  void end_of_pieces() {
    if (auto polyline = std::exchange(polyline_, std::nullopt); polyline && !left_out_)
      put_polyline(*polyline);
    if (auto spline = std::exchange(spline_, std::nullopt); spline && !left_out_)
      put_spline(std::move(*spline));
  }
  void put_polyline(const Polyline& p) {
    if (p.vertices.empty()) return leave_out("it has no points");
    for (const DL_VertexData& v : p.vertices)
      if (p.in_space && v.z != p.vertices[0].z) return leave_out("it is not flat");
    const std::size_t ways = p.vertices.size() - (p.closed ? 0 : 1);
    const Affine plane = p.mirrored.value_or(false) && !p.in_space ? Affine::mirror_x() : Affine();
    const Point first{p.vertices[0].x, p.vertices[0].y};
    if (ways == 0) return put(moved(Line{first, first}, plane));
    for (std::size_t i = 0; i < ways; ++i) {
      const DL_VertexData &from = p.vertices[i], &to = p.vertices[(i + 1) % p.vertices.size()];
      put(moved(bulged({from.x, from.y}, {to.x, to.y}, p.in_space ? 0 : from.bulge), plane));
    }
  }
  void put_spline(Spline spline) {
    if (spline.points.empty() && !fit_.points.empty()) return put_through();
    if (const std::string_view flaw = flaw_of(spline); !flaw.empty()) return leave_out(flaw);
    put(std::move(spline));
  }

  /// A spline with fit points only, without control points.
  void put_through() {
    if (!fit_is_flat_) return leave_out("it is not flat");
    auto shape = through(std::exchange(fit_, {}));
    if (!shape) return leave_out("it has no length");
    const Spline* spline = std::get_if<Spline>(&*shape);
    const auto is_finite = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    if (spline && !std::all_of(spline->points.begin(), spline->points.end(), is_finite))
      return leave_out("its points lie too far apart or too close together");
    put(std::move(*shape));
    file_.understood.push_back({std::string(name_),
                                "it has fit points and no control points, so it is drawn as a smooth curve "
                                "through them: other programs may draw it slightly differently",
                                number(), line()});
  }

  DxfFile& file_;
  const std::vector<ScannedEntity>& scanned_;
  DxfBlock without_place_;
  DxfBlock* into_ = &file_.model;
  DxfEntity* taken_ = nullptr;  ///< the part taken of the current entity; null: nothing yet
  std::size_t next_ = 0, current_ = 0;
  std::string_view name_;
  std::string layer_;
  bool left_out_ = false;
  std::optional<Polyline> polyline_;
  std::optional<Spline> spline_;
  double spline_height_ = 0, fit_height_ = 0;
  bool fit_is_flat_ = false;
  FitPoints fit_;
};

}  // namespace

bool LessName::operator()(std::string_view a, std::string_view b) const {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [&](char x, char y) { return small(x) < small(y); });
}

Result<DxfFile> read_blocks(std::string_view text, const std::vector<ScannedEntity>& scanned,
                            const std::string& name) {
  DxfFile file;
  Collector collector(file, scanned);
  TextBuffer buffer(text);
  std::istream in(&buffer);
  try {
    DL_Dxf parser;
    if (!parser.in(in, &collector))
      return fail(FaultKind::text, fmt::format("{} cannot be read as a DXF file.", name),
                  "Nothing was loaded from it.");
  } catch (const std::exception& e) {
    return fail(FaultKind::text, fmt::format("{} cannot be read as a DXF file: {}.", name, e.what()),
                "Nothing was loaded from it.");
  }
  collector.end();
  return file;
}

}  // namespace hw::drawing
