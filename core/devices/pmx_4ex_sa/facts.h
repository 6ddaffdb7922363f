#pragma once
// The PMX-4EX-SA as its manual describes it. Shared by driver and emulator; facts only.
#include <array>
#include <cstdint>

#include "core/devices/arcus/facts.h"

namespace hw::pmx_4ex_sa {

using arcus::Notation;
using arcus::Setting;
using arcus::SettingFact;
using arcus::SpeedRow;

inline constexpr int axes = 4, inputs = 8, outputs = 8, enables = 4, analog_inputs = 8, programs = 4;
inline constexpr int buffer_places = 36, buffer_axes = 3;
inline constexpr int analog_max_mv = 5000;

/// Table A.0.
inline constexpr std::array<SpeedRow, 7> speed_rows{{
    {65'000, 1, 1, 2, 50},
    {130'000, 2, 2, 1, 100},
    {325'000, 3, 5, 1, 200},
    {650'000, 4, 10, 1, 800},
    {1'300'000, 5, 20, 1, 1500},
    {3'200'000, 6, 50, 1, 3800},
    {6'000'000, 7, 100, 1, 7500},
}};

inline constexpr std::int64_t any_ms = 999'999'999'999;  ///< too long a ramp is adjusted, not refused

/// Factory values that the manual does not give: decision AMB-034.
inline constexpr std::array<SettingFact, 37> settings{{
    {Setting::device_name, "DN", 1, 0, 99, 0, true, false, Notation::name},
    {Setting::baud_code, "DB", 1, 1, 5, 1, true},
    {Setting::high_speed, "HS", 1, 1, arcus::max_speed, 1000, false},
    {Setting::low_speed, "LS", 1, 1, arcus::max_speed, 100, false},
    {Setting::accel, "ACC", 1, 0, any_ms, 300, false},
    {Setting::decel, "DEC", 1, 0, any_ms, 300, false},
    {Setting::axis_high_speed, "HSa", 4, 0, arcus::max_speed, 0, false},
    {Setting::axis_low_speed, "LSa", 4, 0, arcus::max_speed, 0, false},
    {Setting::axis_accel, "ACCa", 4, 0, any_ms, 0, false},
    {Setting::axis_decel, "DECa", 4, 0, any_ms, 0, false},
    {Setting::separate_decel, "EDEC", 1, 0, 1, 0, true},
    {Setting::s_curve, "SCVa", 4, 0, 1, 0, true},
    {Setting::speed_window, "SSPDMa", 4, 0, 7, 0, false},
    {Setting::buffer_accel, "IACC", 1, 0, 1, 0, true},
    {Setting::polarity, "POa", 4, 0, 15, 7, true},
    {Setting::input_polarity, "DIP", 1, 0, 1, 0, true},
    {Setting::output_polarity, "DOP", 1, 0, 1, 0, true},
    {Setting::enable_polarity, "EOP", 1, 0, 1, 0, true},
    {Setting::boot_outputs, "DOBOOT", 1, 0, 255, 0, true},
    {Setting::boot_enables, "EOBOOT", 1, 0, 15, 0, true},
    {Setting::ignore_errors, "IERR", 1, 0, 1, 0, true},
    {Setting::sync_condition, "SYNaC", 4, 1, 3, 1, false},
    {Setting::sync_position, "SYNaP", 4, arcus::position_min, arcus::position_max, 0, false},
    {Setting::sync_width, "SYNaT", 4, 0, 10, 0, false},
    {Setting::joystick, "JE", 1, 0, 15, 0, true},
    {Setting::joystick_values, "JVn", 12, 0, arcus::max_number, 0, true},
    {Setting::joystick_limits, "JLn", 16, arcus::position_min, arcus::position_max, 0, true},
    {Setting::joystick_max, "JMAXa", 4, 0, analog_max_mv, analog_max_mv, true},
    {Setting::joystick_min, "JMINa", 4, 0, analog_max_mv, 0, true},
    {Setting::loop_ratio, "SLRa", 4, 1, 999'999, 1000, true, false, Notation::thousandths},
    {Setting::loop_tolerance, "SLTa", 4, 0, arcus::position_max, 20, true},
    {Setting::loop_range, "SLEa", 4, 0, arcus::position_max, 1000, true},
    {Setting::loop_attempts, "SLAa", 4, 0, arcus::position_max, 10, true},
    {Setting::loop, "SLa", 4, 0, 1, 0, true},
    {Setting::comm_timeout, "TOC", 1, 0, arcus::max_number, 0, true},
    {Setting::error_return, "SAP", 1, 0, 1, 0, true},
    {Setting::boot_programs, "SLOAD", 1, 0, 15, 0, true},
}};

inline constexpr arcus::Model model{
    .name = "pmx-4ex-sa",
    .title = "PMX-4EX-SA",
    .axis_letters = "XYZU",
    .name_prefix = "4EX",
    .product = arcus::pmx_product,
    .version = "V161BL",
    .reply_end = '\r',
    .broadcast = -1,
    .inputs = inputs,
    .outputs = outputs,
    .enables = enables,
    .analog_inputs = analog_inputs,
    .programs = programs,
    .latch_inputs = {4, 6, 5, 8},  // table 6.3
    .sync_outputs = {1, 2, 3, 4},  // table 6.8
    .counts_denominator = 1,
    .counts_numerator = 1,
    .index_every = 4000,
    .status = {.accelerating = 0,  // table 6.1
               .decelerating = 1,
               .constant = 2,
               .alarm = 3,
               .plus_limit = 4,
               .minus_limit = 5,
               .home = 6,
               .plus_error = 7,
               .minus_error = 8,
               .alarm_error = 9,
               .latch = arcus::no_bit,
               .index = arcus::no_bit,
               .timed_out = 11},
    .polarity = {.home = {0, false},  // table 6.2, decision AMB-089
                 .alarm = {1, false},
                 .limit = {2, false},
                 .direction = {3, true},
                 .latch = arcus::no_polarity,
                 .in_position = arcus::no_polarity,
                 .alarm_output = arcus::no_polarity,
                 .outputs = arcus::no_polarity,
                 .inputs = arcus::no_polarity,
                 .jump = arcus::no_polarity,
                 .enable = arcus::no_polarity},
    .speeds = speed_rows,
    .settings = settings,
    .refusals = {"OK", "", "?Index out of Range", "?LIMIT", "?ALARM", "?ERRORED", "?PULSING",
                 "?In Incremental mode", "", "?Sub not Initialized", "?Timer Running", "?BUFFER FULL",
                 "?SSPD Error", "?SSPD Error", "?SSPD Error", ""},
    .buffer_places = buffer_places,
};

}  // namespace hw::pmx_4ex_sa
