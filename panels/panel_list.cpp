#include "panels/panel_list.h"

#include "panels/bench.h"
#include "panels/connect.h"
#include "panels/control.h"
#include "panels/goto_home.h"
#include "panels/help.h"
#include "panels/inputs_outputs.h"
#include "panels/jog.h"
#include "panels/limits.h"
#include "panels/moves.h"
#include "panels/position.h"
#include "panels/program.h"
#include "panels/setup.h"
#include "panels/terminal.h"
#include "panels/variables.h"

namespace hw::panels {
namespace {

using gui::Place;

template <class T>
std::unique_ptr<gui::Panel> make() {
  return std::make_unique<T>();
}
template <class T>
std::unique_ptr<gui::Page> make_page() {
  return std::make_unique<T>();
}

bool has_signals(const Catalog& c, bool) {
  return !c.inputs.empty() || !c.outputs.empty() || !c.analog.empty();
}
bool has_programs(const Catalog& c, bool) { return c.program.slots > 0; }
bool has_parameters(const Catalog& c, bool) { return !c.params.empty(); }
bool controls(const Catalog& c, bool) { return has_control(c); }
bool has_variables(const Catalog& c, bool) { return c.variables.count > 0; }
bool has_move_list(const Catalog& c, bool) { return !c.move_list.columns.empty(); }
bool has_bench(const Catalog&, bool emulated) { return emulated; }

constexpr gui::PanelEntry panels[] = {
    {"position", "Position", Place::top_left, make<Position>, nullptr},
    {"jog", "Jog", Place::left, make<Jog>, nullptr},
    {"goto_home", "Go to, home", Place::left, make<GotoHome>, nullptr},
    {"program", "Program", Place::centre, make<Program>, has_programs},
    {"control", "Control", Place::centre, make<Control>, controls},
    {"variables", "Variables", Place::centre, make<Variables>, has_variables},
    {"list", "Moves", Place::centre, make<Moves>, has_move_list},
    {"setup", "Setup", Place::centre, make<Setup>, has_parameters},
    {"terminal", "Terminal", Place::below, make<Terminal>, nullptr},
    {"limits", "Limits", Place::right, make<Limits>, nullptr},
    {"inputs_outputs", "Inputs and outputs", Place::right, make<InputsOutputs>, has_signals},
    {"bench", "Bench", Place::right, make<Bench>, has_bench},
};
constexpr gui::PageEntry pages[] = {
    {"connect", "Connect", make_page<Connect>},
    {"help", "Keyboard map", make_page<Help>},
};

}  // namespace

gui::PanelList panel_list() { return {panels, pages}; }

}  // namespace hw::panels
