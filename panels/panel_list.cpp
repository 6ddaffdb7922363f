#include "panels/panel_list.h"

#include "gui/model/tab.h"
#include "panels/bench.h"
#include "panels/blocks/blocks.h"
#include "panels/connect/connect.h"
#include "panels/contour/contour.h"
#include "panels/control/control.h"
#include "panels/drawing/drawing_tab.h"
#include "panels/goto_home.h"
#include "panels/help/help.h"
#include "panels/inputs_outputs.h"
#include "panels/jog/jog.h"
#include "panels/limits.h"
#include "panels/memory_map.h"
#include "panels/moves.h"
#include "panels/path/tool_path.h"
#include "panels/position/bus_rows.h"
#include "panels/position/position.h"
#include "panels/program/program.h"
#include "panels/setup/setup.h"
#include "panels/terminal.h"
#include "panels/tuning/tuning.h"
#include "panels/variables.h"

namespace hw::panels {
namespace {

using gui::Place;
using gui::Tab;

template <class T>
std::unique_ptr<gui::Panel> make() {
  return std::make_unique<T>();
}
template <class T>
std::unique_ptr<gui::Page> make_page() {
  return std::make_unique<T>();
}

std::unique_ptr<gui::Sheet> make_help() { return std::make_unique<Help>(); }

bool has_signals(const Tab& t) {
  return !t.catalog().inputs.empty() || !t.catalog().outputs.empty() || !t.catalog().analog.empty();
}
bool has_programs(const Tab& t) { return t.catalog().program.slots > 0; }
bool goes_in_a_plane(const Tab& t) { return t.catalog().axes.size() > 1; }
bool cuts_drawings(const Tab& t) { return has_programs(t) && (goes_in_a_plane(t) || t.bus != nullptr); }
bool has_parameters(const Tab& t) { return !t.catalog().params.empty(); }
bool controls(const Tab& t) { return has_control(t.catalog()); }
bool has_variables(const Tab& t) { return t.catalog().variables.count > 0; }
bool has_move_list(const Tab& t) { return !t.catalog().move_list.columns.empty(); }
bool has_memory_map(const Tab& t) { return t.catalog().can.memory_map; }
bool has_contours(const Tab& t) { return t.catalog().can.contours; }
bool tunes(const Tab& t) { return can_tune(t.catalog()); }
bool has_bench(const Tab& t) { return t.bench().present; }
bool is_alone(const Tab& t) { return !t.bus; }
bool is_on_bus(const Tab& t) { return t.bus != nullptr; }

constexpr gui::PanelEntry panels[] = {
    {"position", "Position", Place::top_left, make<Position>, is_alone},
    {"bus", "Bus", Place::top_left, make<BusRows>, is_on_bus},
    {"jog", "Jog", Place::left, make<Jog>, nullptr},
    {"goto_home", "Go to, home", Place::left, make<GotoHome>, nullptr},
    {"program", "Program", Place::centre, make<Program>, has_programs, 240},
    {"blocks", "Blocks", Place::centre, make<Blocks>, has_programs, 240, ".toml", 560},
    {"drawing", "Drawing", Place::centre, make<DrawingTab>, cuts_drawings, 240, ".dxf", 560, true},
    {"path", "Path", Place::centre, make<ToolPath>, nullptr, 240, "", 560, true},
    {"control", "Control", Place::centre, make<Control>, controls, 0, "", 560},
    {"variables", "Variables", Place::centre, make<Variables>, has_variables},
    {"list", "Moves", Place::centre, make<Moves>, has_move_list, 360},
    {"setup", "Setup", Place::centre, make<Setup>, has_parameters, 240, "", 560},
    {"tuning", "Tuning", Place::centre, make<Tuning>, tunes, 420, "", 616},
    {"contour", "Contour", Place::centre, make<Contour>, has_contours, 300, "", 560},
    {"memory", "Memory", Place::centre, make<MemoryMap>, has_memory_map, 0, "", 560},
    {"terminal", "Terminal", Place::below, make<Terminal>, nullptr},
    {"limits", "Limits", Place::right, make<Limits>, nullptr},
    {"inputs_outputs", "Inputs and outputs", Place::right, make<InputsOutputs>, has_signals},
    {"bench", "Bench", Place::lower_right, make<Bench>, has_bench},
};
constexpr gui::PageEntry pages[] = {
    {"connect", "Connect", make_page<Connect>},
};

}  // namespace

gui::PanelList panel_list() { return {panels, pages, make_help}; }

}  // namespace hw::panels
