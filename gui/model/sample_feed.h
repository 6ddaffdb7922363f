#pragma once
// Ties the recorder of steps to its controller.
#include "gui/model/step_recorder.h"

namespace hw::gui {

class Tab;

/// The recorder's view of the controller in this frame, and its means to command it.
StepRecorder::View steps_view(Tab& tab);
/// Before a new recording: drops the samples of an earlier one that have not been taken yet.
void drop_samples(Tab& tab);

}  // namespace hw::gui
