#pragma once
// One case for each command form of vxm.tsv (a table of every form in the manual, with the page it stands
// on): text in vxm.forms, see form_session.h, which registers a test for each id. Before the case runs, what
// the table says of the form is checked in each state of the controller: the bytes of program memory that it
// takes, whether anything is answered, and that it is dropped where it is not accepted (decisions V12, V13).
// The case asserts reply bytes and one effect.
#include <functional>
#include <string>
#include <vector>

#include "tests/core/devices/vxm/rig.h"

namespace hw::vxm::proof {

struct Form {
  std::string id, form, example, kind, when, args, fallback, reply, memory, effect, manual;

  [[nodiscard]] bool is(std::string_view some_kind) const { return kind == some_kind; }
  /// `state`: local, online or running.
  [[nodiscard]] bool accepted_when(std::string_view state) const;
  /// Bytes that the example takes in program memory.
  [[nodiscard]] int bytes() const;
};

/// All rows of vxm.tsv.
const std::vector<Form>& form_table();

using FormBody = std::function<void(const Form&)>;
bool register_form(const std::string& id, FormBody body, const char* file, int line);
bool has_case(std::string_view id);
/// Ids that have a case but no row.
std::vector<std::string> cases_without_row();

/// A Rig on which the form can work: with a Slave or in NF90 mode where it needs them.
Rig rig_for(const Form& form);

/// A parameter: default before, `after` once the form's example was sent on-line; untouched by it in local
/// mode and during a run.
void expect_setting(const Form& form, const std::string& query, const std::string& before,
                    const std::string& after);
/// Out of range or without a number: what `query` answers stays (V09, V10).
void expect_kept(Rig& rig, const std::string& query, const std::vector<std::string>& commands);
/// Alone on the bus it is entered without a complaint, the error comes when it is run (V95).
void expect_bus_error(const Form& form);
/// Dropped at its ender: no reply, nothing stored, nothing changed.
void expect_dropped(Rig& rig, const std::string& command);

}  // namespace hw::vxm::proof
