#include "panels/panel_list.h"

#include "panels/bench.h"
#include "panels/connect.h"
#include "panels/goto_home.h"
#include "panels/help.h"
#include "panels/inputs_outputs.h"
#include "panels/jog.h"
#include "panels/limits.h"
#include "panels/position.h"

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
bool has_bench(const Catalog&, bool emulated) { return emulated; }

constexpr gui::PanelEntry panels[] = {
    {"position", "Position", Place::top_left, make<Position>, nullptr},
    {"jog", "Jog", Place::left, make<Jog>, nullptr},
    {"goto_home", "Go to, home", Place::left, make<GotoHome>, nullptr},
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
