#include "gui/surface/theme.h"

#include <algorithm>
#include <cmath>

namespace hw::gui {
namespace {

struct Row {
  Tone tone;
  std::uint32_t dark, light;
};

constexpr Row rows[] = {
    {Tone::ground, 0x0D0F11, 0xE6E9EB},    {Tone::panel, 0x15181B, 0xF8F9FA},
    {Tone::raised, 0x22272C, 0xE9ECEE},    {Tone::hover, 0x2C3238, 0xDDE2E5},
    {Tone::well, 0x0A0C0D, 0xFFFFFF},      {Tone::sel, 0x2A3036, 0xDFE4E7},
    {Tone::line, 0x282D32, 0xD2D7DB},      {Tone::edge, 0x6D767F, 0x7D868E},
    {Tone::ink, 0xEEF1F3, 0x14181B},       {Tone::ink2, 0xB3BBC2, 0x42494F},
    {Tone::ink3, 0x959EA6, 0x5C646B},      {Tone::motion, 0x54C6E0, 0x00647C},
    {Tone::ok, 0x6BCB8E, 0x176B3C},        {Tone::warn, 0xF0B441, 0x805200},
    {Tone::fault, 0xFF7A72, 0xB3201F},     {Tone::stop, 0xC3272B, 0xC3272B},
    {Tone::emu, 0xBBA6F5, 0x5E3BB0},       {Tone::flow, 0xD8C38C, 0x6B5300},
    {Tone::trace, 0xF29BC1, 0x9B2463},     {Tone::lamp_ok, 0x6BCB8E, 0x2FA866},
    {Tone::lamp_warn, 0xF0B441, 0xE59A00}, {Tone::motion_t, 0x12323B, 0xD5EDF3},
    {Tone::ok_t, 0x16301F, 0xDCF0E3},      {Tone::warn_t, 0x352A12, 0xFBEBCB},
    {Tone::fault_t, 0x3A1A1B, 0xFADEDC},   {Tone::emu_t, 0x262038, 0xE8E1F8},
    {Tone::on_motion, 0x0D0F11, 0xFFFFFF}, {Tone::on_stop, 0xFFFFFF, 0xFFFFFF},
};

constexpr Theme make(bool dark) {
  Theme theme{dark, {}};
  for (const Row& row : rows)
    theme.tones[static_cast<std::size_t>(row.tone)] = rgb(dark ? row.dark : row.light);
  return theme;
}
static_assert(std::size(rows) == static_cast<std::size_t>(Tone::count));

}  // namespace

constinit const Theme dark_theme = make(true);
constinit const Theme light_theme = make(false);

void apply(const Theme& theme, float scale, ImGuiStyle& style) {
  style = ImGuiStyle();
  style.WindowRounding = style.ChildRounding = 0;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = 3;
  style.ScrollbarRounding = 2;
  style.WindowPadding = ImVec2(16, 0);
  style.FramePadding = ImVec2(8, 6);
  style.ItemSpacing = ImVec2(8, 4);
  style.ItemInnerSpacing = ImVec2(4, 4);
  style.CellPadding = ImVec2(4, 4);
  style.ScrollbarSize = 12;
  style.ScaleAllSizes(scale);
  style.WindowMinSize = ImVec2(1, 1);  // not scaled: ImGui needs one pixel
  style.FrameBorderSize = style.PopupBorderSize = std::max(1.0f, std::floor(scale));
  style.WindowBorderSize = style.ChildBorderSize = 0;
  style.DisabledAlpha = 1;  // disabled widgets have tokens of their own
  const auto set = [&](ImGuiCol which, Tone tone) {
    style.Colors[which] = ImGui::ColorConvertU32ToFloat4(theme[tone]);
  };
  set(ImGuiCol_Text, Tone::ink);
  set(ImGuiCol_TextDisabled, Tone::ink3);
  set(ImGuiCol_WindowBg, Tone::panel);
  set(ImGuiCol_ChildBg, Tone::panel);
  style.Colors[ImGuiCol_ChildBg].w = 0;
  set(ImGuiCol_PopupBg, Tone::panel);
  set(ImGuiCol_FrameBg, Tone::well);
  set(ImGuiCol_FrameBgHovered, Tone::well);
  set(ImGuiCol_FrameBgActive, Tone::well);
  set(ImGuiCol_Border, Tone::edge);
  set(ImGuiCol_Button, Tone::raised);
  set(ImGuiCol_ButtonHovered, Tone::hover);
  set(ImGuiCol_ButtonActive, Tone::sel);
  set(ImGuiCol_Header, Tone::sel);
  set(ImGuiCol_HeaderHovered, Tone::hover);
  set(ImGuiCol_HeaderActive, Tone::sel);
  set(ImGuiCol_NavHighlight, Tone::ink);
  set(ImGuiCol_Separator, Tone::line);
  set(ImGuiCol_TextSelectedBg, Tone::sel);
  if (theme.dark) style.Colors[ImGuiCol_TextSelectedBg] = ImGui::ColorConvertU32ToFloat4(rgb(0x3A434B));
  set(ImGuiCol_ScrollbarBg, Tone::panel);
  style.Colors[ImGuiCol_ScrollbarBg].w = 0;
  set(ImGuiCol_ScrollbarGrab, Tone::line);
  set(ImGuiCol_ScrollbarGrabHovered, Tone::edge);
  set(ImGuiCol_ScrollbarGrabActive, Tone::edge);
  set(ImGuiCol_TableBorderLight, Tone::line);
  set(ImGuiCol_TableBorderStrong, Tone::line);
  style.Colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0);  // begin_modal() dims all but STOP ALL
}

}  // namespace hw::gui
