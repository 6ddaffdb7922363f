#pragma once
// Every component in every state, as the look's sixth picture shows them: to be looked at, and a scene for
// tests.
#include "gui/surface/ui.h"

namespace hw::gui {
void draw_gallery(Ui& ui);
}
