#include "gui/surface/raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hw::gui {
namespace {

unsigned divide_255(unsigned v) { return (v + 128 + ((v + 128) >> 8)) >> 8; }
unsigned channel(ImU32 colour, int shift) { return (colour >> shift) & 255u; }

/// Blends with straight alpha over an opaque ground, as glBlendFunc(SRC_ALPHA, ONE_MINUS_SRC_ALPHA) does.
void blend(std::uint32_t& ground, ImU32 colour, unsigned alpha) {
  if (alpha == 0) return;
  if (alpha == 255) {
    ground = colour | IM_COL32_A_MASK;
    return;
  }
  std::uint32_t out = IM_COL32_A_MASK;
  for (int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT})
    out |= divide_255(channel(colour, shift) * alpha + channel(ground, shift) * (255 - alpha)) << shift;
  ground = out;
}

/// Blends the pixel of the picture at that place, sampled as GL does (gui/surface/gl_textures.cpp).
void blend_sample(std::uint32_t& ground, const Picture& picture, float u, float v) {
  const int x = std::clamp(static_cast<int>(u * static_cast<float>(picture.width)), 0, picture.width - 1);
  const int y = std::clamp(static_cast<int>(v * static_cast<float>(picture.height)), 0, picture.height - 1);
  const ImU32 there = picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                     static_cast<std::size_t>(x)];
  blend(ground, there, channel(there, IM_COL32_A_SHIFT));
}

/// The first pixel whose centre is at or right of (below) `v`. Triangles that share an edge get the same
/// pixel, so they leave no gap and draw no pixel twice.
int first_pixel(float v) { return static_cast<int>(std::ceil(v - 0.5f)); }

bool same_uv(const ImDrawVert& a, const ImDrawVert& b) { return a.uv.x == b.uv.x && a.uv.y == b.uv.y; }

/// A value that is linear over a triangle.
struct Plane {
  float at_origin = 0, per_x = 0, per_y = 0;
  Plane() = default;
  Plane(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, float va, float vb, float vc) {
    const float x1 = b.pos.x - a.pos.x, y1 = b.pos.y - a.pos.y, x2 = c.pos.x - a.pos.x,
                y2 = c.pos.y - a.pos.y;
    const float area = x1 * y2 - x2 * y1;
    if (area == 0) return;
    per_x = ((vb - va) * y2 - (vc - va) * y1) / area;
    per_y = ((vc - va) * x1 - (vb - va) * x2) / area;
    at_origin = va - per_x * a.pos.x - per_y * a.pos.y;
  }
  [[nodiscard]] float at(float x, float y) const { return at_origin + per_x * x + per_y * y; }
};

unsigned clamped_byte(float v) { return static_cast<unsigned>(std::clamp(v + 0.5f, 0.0f, 255.0f)); }

}  // namespace

void Raster::clear(int width, int height, ImU32 colour) {
  width_ = width;
  height_ = height;
  pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                 colour | IM_COL32_A_MASK);
}

void Raster::draw(const ImDrawData& data, const AlphaTexture& texture, const Pictures& pictures) {
  texture_ = texture;
  for (int n = 0; n < data.CmdListsCount; ++n) {
    const ImDrawList& list = *data.CmdLists[n];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback) continue;
      const ImVec4& r = command.ClipRect;
      const Clip clip{std::max(0, static_cast<int>(r.x)), std::max(0, static_cast<int>(r.y)),
                      std::min(width_, static_cast<int>(r.z)), std::min(height_, static_cast<int>(r.w))};
      if (clip.x0 >= clip.x1 || clip.y0 >= clip.y1) continue;
      if (const Picture* picture = pictures.find(command.TextureId))
        draw_picture(*picture, list, command, clip);
      else
        draw_command(list, command, clip);
    }
  }
}

void Raster::draw_command(const ImDrawList& list, const ImDrawCmd& command, const Clip& clip) {
  const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
  const ImDrawVert* vertex = list.VtxBuffer.Data + command.VtxOffset;
  for (unsigned i = 0; i + 2 < command.ElemCount;) {
    const ImDrawVert &a = vertex[index[i]], &b = vertex[index[i + 1]], &c = vertex[index[i + 2]];
    // ImGui writes a rectangle as (0 1 2) (0 2 3). Most of a frame are rectangles.
    const bool quad = i + 5 < command.ElemCount && index[i + 3] == index[i] && index[i + 4] == index[i + 2];
    if (quad && draw_as_rect(&a, &b, &c, &vertex[index[i + 5]], clip)) {
      i += 6;
      continue;
    }
    triangle(a, b, c, clip);
    i += 3;
  }
}

/// A picture is never rotated; ImDrawList::AddImage writes it as (0 1 2) (0 2 3).
void Raster::draw_picture(const Picture& picture, const ImDrawList& list, const ImDrawCmd& command,
                          const Clip& clip) {
  const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
  const ImDrawVert* vertex = list.VtxBuffer.Data + command.VtxOffset;
  for (unsigned i = 0; i + 5 < command.ElemCount; i += 6) {
    const ImDrawVert &min = vertex[index[i]], &max = vertex[index[i + 2]];
    const float w = max.pos.x - min.pos.x, h = max.pos.y - min.pos.y;
    if (w <= 0 || h <= 0) continue;
    const Clip r{std::max(clip.x0, first_pixel(min.pos.x)), std::max(clip.y0, first_pixel(min.pos.y)),
                 std::min(clip.x1, first_pixel(max.pos.x)), std::min(clip.y1, first_pixel(max.pos.y))};
    const float du = (max.uv.x - min.uv.x) / w, dv = (max.uv.y - min.uv.y) / h;
    for (int y = r.y0; y < r.y1; ++y) {
      const float v = min.uv.y + (static_cast<float>(y) + 0.5f - min.pos.y) * dv;
      std::uint32_t* line = row(y);
      for (int x = r.x0; x < r.x1; ++x)
        blend_sample(line[x], picture, min.uv.x + (static_cast<float>(x) + 0.5f - min.pos.x) * du, v);
    }
  }
}

bool Raster::draw_as_rect(const ImDrawVert* a, const ImDrawVert* b, const ImDrawVert* c, const ImDrawVert* d,
                          const Clip& clip) {
  const bool upright =
      a->pos.y == b->pos.y && b->pos.x == c->pos.x && c->pos.y == d->pos.y && d->pos.x == a->pos.x;
  if (!upright || a->col != b->col || a->col != c->col || a->col != d->col) return false;
  if (a->pos.x > c->pos.x || a->pos.y > c->pos.y) return false;
  const Clip r{std::max(clip.x0, first_pixel(a->pos.x)), std::max(clip.y0, first_pixel(a->pos.y)),
               std::min(clip.x1, first_pixel(c->pos.x)), std::min(clip.y1, first_pixel(c->pos.y))};
  if (same_uv(*a, *c) && same_uv(*a, *b)) {
    fill_rect(r, a->col);
    return true;
  }
  if (a->uv.y != b->uv.y || b->uv.x != c->uv.x || c->uv.y != d->uv.y || d->uv.x != a->uv.x) return false;
  textured_rect(*a, *c, r);
  return true;
}

void Raster::fill_rect(const Clip& r, ImU32 colour) {
  const unsigned alpha = channel(colour, IM_COL32_A_SHIFT);
  for (int y = r.y0; y < r.y1; ++y) {
    std::uint32_t* line = row(y);
    if (alpha == 255)
      std::fill(line + r.x0, line + std::max(r.x0, r.x1), colour);
    else
      for (int x = r.x0; x < r.x1; ++x) blend(line[x], colour, alpha);
  }
}

unsigned Raster::sample(float u, float v) const {
  // Bilinear between texel centres, clamped at the border, with weights of 8 bits as in GPUs.
  const float x = u * static_cast<float>(texture_.width) - 0.5f,
              y = v * static_cast<float>(texture_.height) - 0.5f;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const auto fx = static_cast<unsigned>((x - static_cast<float>(x0)) * 256.0f);
  const auto fy = static_cast<unsigned>((y - static_cast<float>(y0)) * 256.0f);
  const auto texel = [&](int tx, int ty) -> unsigned {
    tx = std::clamp(tx, 0, texture_.width - 1);
    ty = std::clamp(ty, 0, texture_.height - 1);
    return texture_.alpha[static_cast<std::size_t>(ty) * static_cast<std::size_t>(texture_.width) +
                          static_cast<std::size_t>(tx)];
  };
  const unsigned top = texel(x0, y0) * (256 - fx) + texel(x0 + 1, y0) * fx;
  const unsigned bottom = texel(x0, y0 + 1) * (256 - fx) + texel(x0 + 1, y0 + 1) * fx;
  return (top * (256 - fy) + bottom * fy) >> 16;
}

void Raster::textured_rect(const ImDrawVert& min, const ImDrawVert& max, const Clip& r) {
  const float w = max.pos.x - min.pos.x, h = max.pos.y - min.pos.y;
  if (w <= 0 || h <= 0) return;
  const float du = (max.uv.x - min.uv.x) / w, dv = (max.uv.y - min.uv.y) / h;
  const unsigned alpha = channel(min.col, IM_COL32_A_SHIFT);
  for (int y = r.y0; y < r.y1; ++y) {
    const float v = min.uv.y + (static_cast<float>(y) + 0.5f - min.pos.y) * dv;
    std::uint32_t* line = row(y);
    for (int x = r.x0; x < r.x1; ++x) {
      const float u = min.uv.x + (static_cast<float>(x) + 0.5f - min.pos.x) * du;
      blend(line[x], min.col, divide_255(sample(u, v) * alpha));
    }
  }
}

template <class Shade>
void Raster::scan(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const Clip& clip,
                  Shade&& shade) {
  std::array<ImVec2, 3> p{a.pos, b.pos, c.pos};
  std::sort(p.begin(), p.end(), [](ImVec2 l, ImVec2 r) { return l.y != r.y ? l.y < r.y : l.x < r.x; });
  const int top = std::max(clip.y0, first_pixel(p[0].y)), end = std::min(clip.y1, first_pixel(p[2].y));
  const auto edge = [](ImVec2 from, ImVec2 to, float y) {
    return from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y));
  };
  for (int y = top; y < end; ++y) {
    const float middle = static_cast<float>(y) + 0.5f;
    const float x_long = edge(p[0], p[2], middle);
    const float x_short = middle < p[1].y ? edge(p[0], p[1], middle) : edge(p[1], p[2], middle);
    const int x0 = std::max(clip.x0, first_pixel(std::min(x_long, x_short)));
    const int x1 = std::min(clip.x1, first_pixel(std::max(x_long, x_short)));
    if (x0 < x1) shade(y, x0, x1);
  }
}

void Raster::triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const Clip& clip) {
  const bool flat_colour = a.col == b.col && b.col == c.col;
  const bool flat_texture = same_uv(a, b) && same_uv(b, c);
  if (flat_colour && flat_texture) {
    scan(a, b, c, clip, [&](int y, int x0, int x1) { fill_rect(Clip{x0, y, x1, y + 1}, a.col); });
    return;
  }
  std::array<Plane, 4> colour;
  const std::array shifts{IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT, IM_COL32_A_SHIFT};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto value = [&](const ImDrawVert& v) { return static_cast<float>(channel(v.col, shifts[i])); };
    colour[i] = Plane(a, b, c, value(a), value(b), value(c));
  }
  const Plane u(a, b, c, a.uv.x, b.uv.x, c.uv.x), v(a, b, c, a.uv.y, b.uv.y, c.uv.y);
  const unsigned flat_coverage = flat_texture ? sample(a.uv.x, a.uv.y) : 255;
  scan(a, b, c, clip, [&](int y, int x0, int x1) {
    const float middle = static_cast<float>(y) + 0.5f;
    std::uint32_t* line = row(y);
    for (int x = x0; x < x1; ++x) {
      const float at = static_cast<float>(x) + 0.5f;
      const unsigned coverage = flat_texture ? flat_coverage : sample(u.at(at, middle), v.at(at, middle));
      const unsigned alpha = clamped_byte(colour[3].at(at, middle));
      ImU32 shade = a.col;
      if (!flat_colour)
        shade = IM_COL32(clamped_byte(colour[0].at(at, middle)), clamped_byte(colour[1].at(at, middle)),
                         clamped_byte(colour[2].at(at, middle)), 255);
      blend(line[x], shade, divide_255(coverage * alpha));
    }
  });
}

}  // namespace hw::gui
