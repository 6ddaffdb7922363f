// Every form of the manual's command summary with one line of help, for completion and for the hint on the
// effect of Enter.
#include "core/devices/vxm/catalog.h"

namespace hw::vxm {
namespace {

enum Kind { asks, sets, stores, moves, acts };

struct Row {
  const char *form, *example, *help;
  Kind kind;
  const char* manual;
};

// clang-format off
constexpr Row rows[] = {
    // Motion, stored in the selected program until R runs it.
    {"ImMx", "I1M1200", "move motor m by x steps, 1 to 16777215, positive direction", stores, "p.16"},
    {"ImM-x", "I2M-600", "move motor m by x steps, 1 to 16777215, negative direction", stores, "p.16"},
    {"IAmMx", "IA1M1200", "move motor m to position x, 1 to 8388607", stores, "p.16"},
    {"IAmM-x", "IA1M-400", "move motor m to position -x, 1 to 8388608", stores, "p.16"},
    {"IAmM0", "IA1M0", "move motor m to its zero", stores, "p.17"},
    {"IAmM-0", "IA1M-0", "set the position of motor m to zero", stores, "p.17"},
    {"ImM0", "I1M0", "run motor m to its + limit switch (NF90 mode: to zero)", stores, "p.17"},
    {"ImM-0", "I1M-0", "run motor m to its - limit switch", stores, "p.17"},
    {"SmMx", "S1M500", "speed of motor m, 1 to 6000 steps/s, 70 % power", stores, "p.17"},
    {"SAmMx", "SA2M3000", "speed of motor m, 1 to 6000 steps/s, 100 % power", stores, "p.18"},
    {"SmM-x", "S1M-12", "speed of motor m from the analog input, range x, 70 % power", stores, "App. I p.52"},
    {"SAmM-x", "SA1M-12", "speed of motor m from the analog input, range x, 100 % power", stores, "App. I p.53"},
    {"AmMx", "A1M3", "acceleration of motor m, 1 to 127", stores, "p.18"},
    {"Ix", "I400", "move the last addressed motor by x steps, + direction", stores, "p.18"},
    {"I-x", "I-200", "move the last addressed motor by x steps, - direction", stores, "p.18"},
    {"IAx", "IA400", "move the last addressed motor to position x", stores, "p.18"},
    {"IA-x", "IA-400", "move the last addressed motor to position -x", stores, "p.18"},
    {"IA0", "IA0", "move the last addressed motor to its zero", stores, "p.18"},
    {"IA-0", "IA-0", "set the position of the last addressed motor to zero", stores, "p.18"},
    {"I0", "I0", "run the last addressed motor to its + limit switch", stores, "p.18"},
    {"I-0", "I-0", "run the last addressed motor to its - limit switch", stores, "p.18"},
    {"Sx", "S4000", "speed of the last addressed motor, 70 % power", stores, "p.18"},
    {"SAx", "SA3000", "speed of the last addressed motor, 100 % power", stores, "p.18"},
    {"S-x", "S-12", "speed of the last addressed motor from the analog input, 70 % power", stores, "p.18"},
    {"SA-x", "SA-12", "speed of the last addressed motor from the analog input, 100 % power", stores, "p.18"},
    {"Ax", "A2", "acceleration of the last addressed motor, 1 to 127", stores, "p.18"},
    // Programs.
    {"PMx", "PM1", "select program x, 0 to 4", acts, "p.19"},
    {"PM-x", "PM-0", "select program x and empty it", acts, "p.19"},
    {"PM", "PM", "ask which program is selected", asks, "p.19"},
    {"PMAx", "PMA1", "let the Slave run its program x with the Master's program x", acts, "App. G p.48"},
    {"PMA-x", "PMA-0", "couple all programs of Master and Slave but program x", acts, "App. G p.48"},
    {"PMA255", "PMA255", "end the coupling of programs of Master and Slave", acts, "App. G p.48"},
    {"PMA", "PMA", "ask which programs of Master and Slave are coupled", asks, "p.14"},
    // Loops and jumps.
    {"L0", "L0", "loop for ever, from the marker or the beginning", stores, "p.20"},
    {"LM0", "LM0", "set the loop marker here", stores, "p.20"},
    {"LM-0", "LM-0", "set the loop marker to the beginning", stores, "p.20"},
    {"Lx", "L10", "run the commands above x times, the last of them once less", stores, "p.20"},
    {"L-x", "L-4", "loop x times, motor 1 reverses each pass", stores, "p.20"},
    {"LAx", "LA100", "run all commands above x times", stores, "p.20"},
    {"LA-x", "LA-100", "run all commands above x times, motor 1 reverses each pass", stores, "p.20"},
    {"LM-2", "LM-2", "repeat once with motor 2 reversed", stores, "p.21"},
    {"LM-3", "LM-3", "repeat once with motors 1 and 2 reversed", stores, "p.21"},
    {"L-0", "L-0", "NF90 mode only: set the loop marker here", stores, "App. P p.74"},
    {"Jx", "J1", "go on with program x, without returning", stores, "p.21"},
    {"JMx", "JM3", "run program x and return", stores, "p.21"},
    {"JM-x", "JM-1", "run program x, return and undo its absolute moves (pick and place)", stores, "App. S p.79"},
    // Pauses.
    {"Px", "P10", "wait x tenths of a second, 0 to 65535", stores, "p.22"},
    {"P-x", "P-500", "wait x tenths of a millisecond, 1 to 65535", stores, "p.22"},
    {"PAx", "PA150", "output 1 on for x tenths of a second", stores, "p.22"},
    {"PA0", "PA0", "output 1 on for 10 microseconds", stores, "p.22"},
    {"PA-x", "PA-150", "output 1 on for x tenths of a millisecond", stores, "p.22"},
    // Inputs and outputs.
    {"U0", "U0", "wait until input 1 is low", stores, "p.22"},
    {"U1", "U1", "wait until input 1 is low, output 1 on meanwhile", stores, "p.22"},
    {"U2", "U2", "allow jogging by hand during waits (NF90 mode: output 1 off in pauses)", stores, "App. H p.51"},
    {"U3", "U3", "no jogging by hand during waits (NF90 mode: output 1 on in pauses)", stores, "App. H p.51"},
    {"U4", "U4", "output 1 off", stores, "p.23"},
    {"U5", "U5", "output 1 on", stores, "p.23"},
    {"U6", "U6", "send W to the computer and wait for G", stores, "App. B p.34"},
    {"U7", "U7", "begin nonstop indexing, pulse on output 2 at each index end", stores, "App. D p.39"},
    {"U77", "U77", "begin nonstop indexing without a signal", stores, "App. G p.47"},
    {"U8", "U8", "begin nonstop indexing, @ to the computer at each index end", stores, "App. D p.40"},
    {"U9", "U9", "end nonstop indexing with a ramp", stores, "App. D p.40"},
    {"U91", "U91", "end nonstop indexing, write the ramp as an index into the program", stores, "App. D p.40"},
    {"U92", "U92", "end nonstop indexing, the next index is the ramp", stores, "App. D p.40"},
    {"U99", "U99", "end nonstop indexing at once, below 800 steps/s", stores, "App. G p.47"},
    {"U11", "U11", "leave out the next command if input 1 is high", stores, "App. T p.86"},
    {"U12", "U12", "leave out the next command if input 2 is high", stores, "App. T p.86"},
    {"U21", "U21", "leave out the next command if input 1 is low", stores, "App. T p.86"},
    {"U22", "U22", "leave out the next command if input 2 is low", stores, "App. T p.86"},
    {"U13", "U13", "wait for a button: 1- jumps to program 1, 1+ to program 2, Run goes on", stores, "App. B p.34"},
    {"U23", "U23", "wait for a button: 1- runs program 1, 1+ program 2, both return; Run goes on", stores, "App. B p.34"},
    {"U14", "U14", "output 2 off", stores, "App. B p.36"},
    {"U15", "U15", "output 2 on", stores, "App. B p.36"},
    {"U16", "U16", "output 3 (option) off", stores, "App. B p.36"},
    {"U17", "U17", "output 3 (option) on", stores, "App. B p.36"},
    {"U18", "U18", "output 4 (option) off", stores, "App. B p.36"},
    {"U19", "U19", "output 4 (option) on", stores, "App. B p.36"},
    {"U30", "U30", "wait until input 1 goes from low to high", stores, "App. B p.34"},
    {"U31", "U31", "wait until input 1 goes from low to high, output 1 on meanwhile", stores, "App. B p.34"},
    {"U32", "U32", "wait for the jog 1- button", stores, "App. B p.35"},
    {"U33", "U33", "wait for the jog 1+ button", stores, "App. B p.35"},
    {"U50", "U50", "wait for press and release of a button on input 1", stores, "App. B p.35"},
    {"U51", "U51", "wait for press and release of a button on input 1, output 1 on meanwhile", stores, "App. B p.35"},
    {"U90", "U90", "wait for press and release of the Run button", stores, "App. B p.35"},
    // Immediate commands.
    {"R", "R", "run the selected program", moves, "p.23"},
    {"D", "D", "ramp the moving motor down, the program goes on; in Local mode: ask for all positions", acts, "p.23"},
    {"K", "K", "stop everything at once, outputs off, errors cleared", acts, "p.23"},
    {"N", "N", "set all positions to zero", acts, "p.23"},
    {"C", "C", "empty the selected program", acts, "p.23"},
    {"E", "E", "go on-line with echo", acts, "p.24"},
    {"F", "F", "go on-line without echo", acts, "p.24"},
    {"G", "G", "go on after a hold or a wait; idle: go on-line with CR after prompts", moves, "App. O p.69"},
    {"Q", "Q", "leave on-line mode, the jog buttons act again", acts, "p.23"},
    {"H", "H", "hold before each command, or end that", moves, "App. A p.32"},
    {"!", "!", "capture the positions of motors 1 and 2", acts, "App. E p.43"},
    {"rsm", "rsm", "store set-up and programs permanently (100000 times at most)", acts, "p.24"},
    {"res", "res", "restart as after power-up", acts, "App. A p.32"},
    {"del", "del", "delete the last command of the selected program", acts, "App. A p.32"},
    // Questions.
    {"V", "V", "ask for the state: R ready, B busy, J or b jog mode", asks, "p.24"},
    {"X", "X", "ask where motor 1 is", asks, "p.24"},
    {"Y", "Y", "ask where motor 2 is", asks, "p.24"},
    {"Z", "Z", "ask where motor 3 is, at rest only", asks, "p.24"},
    {"T", "T", "ask where motor 4 is, at rest only", asks, "p.25"},
    {"x", "x", "ask for the four captured positions of motor 1", asks, "App. E p.44"},
    {"y", "y", "ask for the four captured positions of motor 2", asks, "App. E p.44"},
    {"*", "*", "ask where the last ramp down began", asks, "App. E p.43"},
    {"M", "M", "ask for free memory of the selected program", asks, "p.25"},
    {"lst", "lst", "list the selected program", asks, "p.25"},
    {"#", "#", "ask which motor was addressed last", asks, "App. A p.32"},
    {"?", "?", "ask for the limit switches (one byte)", asks, "App. A p.33"},
    {"~", "~", "ask for the inputs (one byte)", asks, "App. A p.32"},
    {"$", "$", "ask for the outputs (one byte)", asks, "App. A p.33"},
    {"@", "@", "ask for the analog input, 0 to 1024", asks, "App. I p.52"},
    {"B", "B", "ask for the backlash compensation", asks, "App. F p.46"},
    {"O", "O", "ask what a limit switch does to the program", asks, "App. F p.46"},
    {"getDM", "getDM", "ask for the controller mode", asks, "App. O p.68"},
    {"getD0", "getD0", "ask for the firmware version", asks, "App. O p.68"},
    {"getD1", "getD1", "ask for the firmware date", asks, "App. O p.68"},
    {"getD2", "getD2", "ask for the number of motors, 2 or 4", asks, "App. O p.68"},
    {"getDA", "getDA", "ask for the joystick dead band", asks, "App. J p.54"},
    {"getjmM", "getj1M", "ask for the first jog speed of motor m", asks, "App. H p.49"},
    {"getJmM", "getJ1M", "ask for the second jog speed of motor m", asks, "App. H p.49"},
    {"getjAmM", "getjA1M", "ask for the first joystick range of motor m", asks, "App. J p.54"},
    {"getJAmM", "getJA1M", "ask for the second joystick range of motor m", asks, "App. J p.54"},
    {"getLmM", "getL1M", "ask for the limit switch mode of motor m", asks, "App. N p.66"},
    {"getMmM", "getM1M", "ask for the type of motor m", asks, "p.25"},
    {"getPmM", "getP1M", "ask for the pulse distance of motor m", asks, "App. D p.42"},
    {"getPA", "getPA", "ask for the pulse width", asks, "App. D p.42"},
    {"getI", "getI", "ask what the inputs do", asks, "App. C p.38"},
    // Set-up.
    {"setMmMx", "setM1M3", "type of motor m, 0 to 6; a wrong type does damage", sets, "p.25"},
    {"setMAmMx", "setMA1M3", "type of motor m, full power when jogging; a wrong type does damage", sets, "App. M p.64"},
    {"setBx", "setB38", "baud rate: 9, 19 or 38 for 9600, 19200, 38400", sets, "p.25"},
    {"setDMx", "setDM3", "controller mode, 0 to 255", sets, "App. O p.68"},
    {"setDM9", "setDM9", "behave like the older NF90", sets, "App. O p.68"},
    {"setD0", "setD0", "erase all programs and settings: factory state", sets, "App. O p.68"},
    {"setDAx", "setDA40", "joystick dead band, 20 to 100", sets, "App. J p.54"},
    {"setjmMx", "setj1M1000", "first jog speed of motor m, 1 to 6000 steps/s", sets, "App. H p.49"},
    {"setjmM0", "setj1M0", "switch the jog buttons of motor m off", sets, "App. H p.49"},
    {"setJmMx", "setJ1M1000", "second jog speed of motor m, 40 to 6000 steps/s", sets, "App. H p.49"},
    {"setjAmMx", "setjA1M1", "first joystick range of motor m, 1 to 24", sets, "App. J p.54"},
    {"setjAmM0", "setjA1M0", "switch the joystick of motor m off", sets, "App. J p.54"},
    {"setJAmMx", "setJA1M10", "second joystick range of motor m, 0 to 24", sets, "App. J p.54"},
    {"setLmMx", "setL1M-2", "limit switches of motor m, -2 to 2", sets, "App. N p.66"},
    {"setPmMx", "setP1M4", "pulse on output 2 every x steps of motor m", sets, "App. D p.41"},
    {"setPmM0", "setP1M0", "no pulses for motor m", sets, "App. D p.41"},
    {"setPAx", "setPA4", "pulse width, 1 to 255 times 10 microseconds", sets, "App. D p.42"},
    {"setIx", "setI67", "what the inputs do, 0 to 255", sets, "App. C p.38"},
    {"Bx", "B20", "backlash compensation, 0 to 255 steps; 1 means 20", sets, "App. F p.45"},
    {"Ox", "O3", "a limit hit is reported (1), ends the program (2), or both (3)", sets, "App. F p.46"},
};

constexpr Row bus_rows[] = {
    {"(ImMx,ImMx,)", "(I3M800,I1M400,)", "move motor 3 or 4 and motor 1 or 2 together, the Slave's first", stores, "App. G p.47"},
    {"[c1,c2]", "[I1M400,]", "send commands to the Slave", acts, "App. G p.48"},
    {"U100", "U100", "wait until input 1 of the Slave is low", stores, "App. B p.37"},
    {"U101", "U101", "wait until input 1 of the Slave is low, its output 1 on meanwhile", stores, "App. B p.37"},
    {"U102", "U102", "allow jogging at the Slave during waits", stores, "App. B p.37"},
    {"U103", "U103", "no jogging at the Slave during waits", stores, "App. B p.37"},
    {"U104", "U104", "output 1 of the Slave off", stores, "App. B p.37"},
    {"U105", "U105", "output 1 of the Slave on", stores, "App. B p.37"},
    {"U113", "U113", "U13 with the buttons of the Slave", stores, "App. B p.37"},
    {"U114", "U114", "output 2 of the Slave off", stores, "App. B p.37"},
    {"U115", "U115", "output 2 of the Slave on", stores, "App. B p.37"},
    {"U116", "U116", "output 3 (option) of the Slave off", stores, "App. B p.37"},
    {"U117", "U117", "output 3 (option) of the Slave on", stores, "App. B p.37"},
    {"U118", "U118", "output 4 (option) of the Slave off", stores, "App. B p.37"},
    {"U119", "U119", "output 4 (option) of the Slave on", stores, "App. B p.37"},
    {"U123", "U123", "U23 with the buttons of the Slave", stores, "App. B p.37"},
    {"U130", "U130", "wait until input 1 of the Slave goes from low to high", stores, "App. B p.37"},
    {"U131", "U131", "wait until input 1 of the Slave goes high, its output 1 on meanwhile", stores, "App. B p.37"},
    {"U132", "U132", "wait for the jog 1- button of the Slave", stores, "App. B p.37"},
    {"U133", "U133", "wait for the jog 1+ button of the Slave", stores, "App. B p.37"},
    {"U150", "U150", "wait for press and release of a button on input 1 of the Slave", stores, "App. B p.37"},
    {"U151", "U151", "wait for press and release on input 1 of the Slave, its output 1 on meanwhile", stores, "App. B p.37"},
    {"U190", "U190", "wait for press and release of the Run button of the Slave", stores, "App. B p.37"},
};
// clang-format on

CommandInfo info_of(const Row& r) {
  CommandInfo c;
  c.form = r.form;
  c.example = r.example;
  c.help = r.help;
  c.moves = r.kind == moves;
  c.stored = r.kind == stores;
  c.manual = r.manual;
  return c;
}

}  // namespace

std::string_view help_of(std::string_view form) {
  for (const Row& r : rows)
    if (r.form == form) return r.help;
  return {};
}

std::vector<CommandInfo> commands(int motors) {
  std::vector<CommandInfo> all;
  for (const Row& r : rows) all.push_back(info_of(r));
  if (motors > 2)
    for (const Row& r : bus_rows) all.push_back(info_of(r));
  return all;
}

}  // namespace hw::vxm
