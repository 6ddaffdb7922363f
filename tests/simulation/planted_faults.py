"""Small faults, each an edit of one function or two: (folder under core/, its name, what is replaced, by what).
"{" as what is replaced: at the beginning of the function. The rows are those of the table that began the search."""

ALL = ("vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58")
NOTHING_DONE = "if (true) co_return Result<>();"


def fault(name, models, *edits):
    return {"name": name, "models": (models,) if isinstance(models, str) else models, "edits": edits}


FAULTS = [
    # ---- the pump: stops
    fault("a stop does not pre-empt", ALL,
          ("device", "Pump::post_stop(", "station_->preempt();", ";")),
    fault("a stop waits for the queue", ALL,
          ("device", "Pump::serve(", "StopOrder* stop = desk_.due()", "StopOrder* stop = jobs_.empty() ? desk_.due() : nullptr"),
          ("device", "Pump::serve(", "!desk_.any() && !jobs_.empty()", "!jobs_.empty()")),
    fault("the queue outlives a stop", ALL,
          ("device", "Pump::drop_waiting_jobs(", "refuse_queued(stopped_first);", ";")),
    fault("the first stop is at once", ALL,
          ("device", "StopDesk::ask(", "may_escalate && again", "may_escalate")),
    fault("a repeated stop becomes a kill", ALL,
          ("device", "Pump::look_at_stop(", "case StopProgress::Now::again:",
           "case StopProgress::Now::again: order.at_once = true;")),
    fault("a stop that is owed is forgotten", ALL,
          ("device", "Pump::keep_stops_at_loss(", "desk_.send_all_again();", "desk_.clear();")),
    fault("a held jog is not owed its stop at a loss", ALL,
          ("device", "Pump::keep_stops_at_loss(", "desk_.ask(std::move(lets_go));", ";")),
    fault("a stop is not looked after", ALL,
          ("device", "Pump::look_at_stop(", "driver_->stop_progress(order)", "StopProgress()")),
    fault("a stop that is not confirmed is not repeated", ("vme58", "pmx-4ex-sa"),
          ("device", "Pump::look_at_stop(", "order.sent = order.confirmed = false;", "return close_stop(order);")),
    fault("a stop is not written to a wire that is lost", ALL,
          ("device", "Pump::connect(", "StopOrder* stop = desk_.due()", "StopOrder* stop = nullptr")),
    fault("a stop typed in a closing tab is refused", "vme58",
          ("device", "Pump::post_text(", "if (meaning.is_stop()) {", "if (meaning.is_stop() && !leaves()) {")),
    # ---- the pump: jogs
    fault("the dead-man sleeps", ALL,
          ("device", "void begin(IntentId id, int axis", "if (guarded) dead_man_.arm(", "if (false) dead_man_.arm(")),
    fault("letting go is not heard", ALL,
          ("device", "Pump::post(", "{", "if (std::holds_alternative<intent::JogStop>(intent.body)) return;")),
    fault("a jog that may have begun goes on", ALL,
          ("device", "Pump::jog_failed(", "post_stop(std::move(lets_go));", "jog_not_begun(intent);")),
    # ---- the pump: what is asked
    fault("a motion is made again when it was not answered", ("pmx-4ex-sa", "dmx-k-sa"),
          ("device", "Pump::perform_guarding_tool(", 'auto performed = co_await guarded("command", driver_->perform(body));',
           'Result<> performed;'
           ' for (int n = 0; n < 2 && (n == 0 || (!performed && performed.error().kind == FaultKind::no_answer)); ++n)'
           ' performed = co_await guarded("command", driver_->perform(body));')),
    fault("a motion is made twice", ALL,
          ("device", "Pump::perform_guarding_tool(", 'auto performed = co_await guarded("command", driver_->perform(body));',
           'Result<> performed;'
           ' for (int n = 0; n < 2; ++n) performed = co_await guarded("command", driver_->perform(body));')),
    fault("the queue outlives a loss", ALL,
          ("device", "Pump::refuse_queued(", "{", "if (snapshot_.link.state == LinkState::lost) return;")),
    fault("an outcome is not told", ALL,
          ("device", "Pump::perform_next(", "set_outcome(job->intent.id, IntentState::done);",
           "if (!std::holds_alternative<intent::MoveBy>(job->intent.body)) set_outcome(job->intent.id, IntentState::done);")),
    fault("a question behind a stop is not answered", ALL,
          ("device", "Pump::refuse(", "job->waiting_procedure.resume(scheduler_.executor());", ";")),
    fault("a text is lost and told to be done", ALL,
          ("device", "Pump::perform_next(", "{",
           "if (desk_.epoch() % 8 == 7 && !jobs_.empty()) { auto job = jobs_.begin(); jobs_.end(); if (!job->is_query) {"
           " set_outcome(job->intent.id, IntentState::done); co_return; } jobs_.push(std::move(job)); }")),
    # ---- the pump: the connection
    fault("a round of before answers a wait", ALL,
          ("device", "std::uint64_t want(", "return begun_ + 1;", "return ended_;")),
    fault("a silent link is never lost", ("pmx-4ex-sa", "vxm"),
          ("device", "Pump::is_silent(", "{", "if (true) return false;")),
    fault("a lost wire is not tried again", ALL,
          ("device", "Pump::wait_for_retry(", "scheduler_.now() < snapshot_.link.next_attempt", "true")),
    # ---- the link
    fault("a dirty line is believed", ("vxm", "dmx-k-sa"),
          ("link", "Station::is_dirty(", "{", "if (true) return false;")),
    fault("what stopped waiting still waits", ALL,
          ("link", "Station::preempt(", "ended_.notify();", ";")),
    fault("a stop waits for a patient question", ("vxm", "pmx-4ex-sa"),
          ("link", "Link::shorten_for_stop(", "{", "if (true) return;")),
    fault("what waits outlives a stop", "dmx-k-sa --bus",  # alone on its wire a station waits for nobody
          ("link", "Station::preempt(", "link_->drop_waiting(*this, stop_came_first());", ";")),
    # ---- VXM
    fault("VXM: a stop of a program is not sent", "vxm",
          ("devices/vxm", "::stop_program(", "{", NOTHING_DONE)),
    fault("VXM: the ramp of a move is not sent", "vxm",
          ("devices/vxm", "::ramp_down(", "ramp_.expect();",
           "ramp_.expect(); if (console_.scheduler.now().time_since_epoch().count() % 5 == 0) co_return Result<>();")),
    fault("VXM: a program is killed at full speed (row 1)", "vxm",
          ("devices/vxm", "::stop_program(", "if (order.at_once)", "if (order.at_once || order.axis < 0)")),
    fault("VXM: a leg of the console's stays in the program", "vxm",
          ("devices/vxm", "Scratch::clear(", "{", NOTHING_DONE)),
    fault("VXM: later legs outlive a stop", "vxm",
          ("devices/vxm", "Job::note_stop(", "drop_rest();", "jog_ = false;"),
          ("devices/vxm", "Job::go_on(", "if (ended_by != EndedBy::target) legs_.clear();", ";")),
    fault("VXM: a jog goes on in its next leg", "vxm",
          ("devices/vxm", "Job::note_stop(", "drop_rest();", "if (legs_.size() > 1) legs_.resize(1);")),
    fault("VXM: a restart leaves positions trusted", "vxm",
          ("devices/vxm", "Restarts::stands_since(", "if (why != Doubt::none)", "if (false)")),
    fault("VXM: an unfinished line swallows a stop", "vxm",
          ("devices/vxm", "Stops::send(", "order.times_sent > 1", "false")),
    # ---- Arcus
    fault("Arcus: the second STOP is left out (row 19)", ("pmx-4ex-sa", "dmx-k-sa"),
          ("devices/arcus", "Stops::stop_all(", "auto sent = co_await conversation_.command(word, Priority::stop, patience);",
           "auto sent = Result<>();")),
    fault("Arcus: programs are not halted by a stop", ("pmx-4ex-sa", "dmx-k-sa"),
          ("devices/arcus", "::halt_thread(", "{", NOTHING_DONE)),
    fault("Arcus: a borrowed speed is not given back", ("pmx-4ex-sa", "dmx-k-sa"),
          ("devices/arcus", "::give_back(", "{", "borrowed_.reset();")),
    fault("Arcus: a restart is not noticed (row 10)", ("pmx-4ex-sa", "dmx-k-sa"),
          ("devices/arcus", "ArcusDriver::restarted(", "{", "if (true) return;")),
    fault("Arcus: a stop of all is a stop of X", ("pmx-4ex-sa",),
          ("devices/arcus", "::stop_line(", "{", NOTHING_DONE),
          ("devices/arcus", "Stops::stop_all(", "{", NOTHING_DONE)),
    # ---- VME58
    fault("VME58: a stop is not mailed", "vme58",
          ("devices/vme58", "Mailbox::mail(", "{", NOTHING_DONE)),
    fault("VME58: a stop of one axis is not put", "vme58",
          ("devices/vme58", "Stops::stop_axis(", "{", "if (true) co_return true;")),
    fault("VME58: a deaf mailbox is believed (row 5)", "vme58",
          ("devices/vme58", "AllStop::send(", "mailbox_ignores_mail_ || by_mail_alone_ || !any_moves()", "by_mail_alone_")),
    fault("VME58: a late reply is the next one's", "vme58",
          ("devices/vme58", "Conversation::wait_for_abandoned(", "{", NOTHING_DONE),
          ("devices/vme58", "Conversation::ask_several(", "converse(std::move(closed), count, priority, form, Millis(200), true)",
           "converse(std::string(text), count, priority, form, Millis(200), false)")),
    fault("VME58: what waits in the ring outlives a stop", "vme58",
          ("devices/vme58", "Conversation::withdraw_all(", "{", NOTHING_DONE),
          ("devices/vme58", "Mailbox::mail_past_ring(", "if (mailed) mailed = co_await mail(word);", ";")),
]
