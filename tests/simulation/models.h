#pragma once
// What the search has to know about each model that its catalog does not tell: texts that stop it, programs
// that move it, text that means nothing.
#include <string>
#include <string_view>
#include <vector>

namespace hw::simulation {

struct StopText {
  std::string text;
  int axis = -1;         ///< -1: all
  bool at_once = false;  ///< without a ramp
};

struct ModelFacts {
  std::string_view model;
  std::vector<std::string> options;       ///< of the address; one is drawn
  std::vector<std::string> bus;           ///< the same with several devices on the line
  std::vector<std::string> quirks;        ///< that some units have: options too
  std::vector<std::string> strict;        ///< the same, where a wire that is good is needed to live with it
  char prompt = 0;                        ///< what it says at the end of what it was told; 0: nothing
  std::string_view wire;                  ///< options of the emulated wire: its byte times
  bool needs_power = false;               ///< motors have none from the factory
  bool typed_stop_ends_programs = false;  ///< by what the maker says
  bool restart_always_shows = false;      ///< whatever its counters stood at
  bool axis_stop_ends_programs = false;   ///< a Stop of one axis, by what the console promises
  std::vector<StopText> stops;
  std::vector<std::string> programs;       ///< that move something; the first for ever
  std::vector<std::string> tool_programs;  ///< the same with a tool, which some leave on at their end
  int tool_output;                         ///< its place in the catalog
  std::vector<std::string> harmless;       ///< typed texts that move nothing, wrong ones among them
  std::string_view question, answer;       ///< one of those, and a word that is in its answer and in no other
  std::vector<std::string> speeds;         ///< parameters of speed or ramp that may be set
  /// Of its set-up and programs, as the controller receives them; {} stands for the address.
  std::vector<std::string> questions;
  std::vector<std::string> newer;  ///< commands that a firmware may have yet to learn
  std::vector<std::string>
      others;                 ///< of another program on the line: their answers look like none of numbers
  std::string_view kill;      ///< text that stops at once, as the controller receives it
  int axes_seen_at_work = 8;  ///< of more than those nobody can tell whether they turn while a program runs
};

const ModelFacts* find_model(std::string_view model);
std::vector<std::string_view> model_names();

}  // namespace hw::simulation
