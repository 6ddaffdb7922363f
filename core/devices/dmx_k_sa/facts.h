#pragma once
// The DMX-K-SA as its manual describes it. Shared by driver and emulator; facts only.
#include <array>
#include <cstdint>

#include "core/devices/arcus/facts.h"

namespace hw::dmx_k_sa {

using arcus::Notation;
using arcus::Setting;
using arcus::SettingFact;
using arcus::SpeedRow;

inline constexpr int axes = 1, inputs = 6, outputs = 3, enables = 1, programs = 2;
inline constexpr int broadcast = 0;
inline constexpr int counts_per_turn = 4000, pulses_per_turn = 3200;
inline constexpr int latch_input = 2, sync_output = 2;
inline constexpr int in_position_output = 1, alarm_output = 3;

/// Table A.0.
inline constexpr std::array<SpeedRow, 9> speed_rows{{
    {16'000, 1, 10, 2, 500},
    {30'000, 2, 10, 1, 1'000},
    {80'000, 3, 15, 1, 2'000},
    {160'000, 4, 25, 1, 4'000},
    {300'000, 5, 50, 1, 8'000},
    {800'000, 6, 100, 1, 18'000},
    {1'600'000, 7, 200, 1, 39'000},
    {3'000'000, 8, 400, 1, 68'000},
    {6'000'000, 9, 500, 1, 135'000},
}};

inline constexpr std::int64_t any_ms = 999'999'999'999;  ///< too long a ramp is adjusted, not refused

/// Factory values of table 7.12; where the table has none: decisions AMB-031, AMB-034, AMB-097.
inline constexpr std::array<SettingFact, 35> settings{{
    {Setting::device_name, "DN", 1, 1, 99, 1, true, false, Notation::name},
    {Setting::baud_code, "DB", 1, 1, 5, 1, true},
    {Setting::high_speed, "HSPD", 1, 1, arcus::max_speed, 1000, false},
    {Setting::low_speed, "LSPD", 1, 1, arcus::max_speed, 100, false},
    {Setting::accel, "ACC", 1, 0, any_ms, 300, false},
    {Setting::decel, "DEC", 1, 0, any_ms, 300, false},
    {Setting::separate_decel, "EDEC", 1, 0, 1, 0, true},
    {Setting::s_curve, "SCV", 1, 0, 1, 0, false},
    {Setting::speed_window, "SSPDM", 1, 0, 9, 0, false},
    {Setting::polarity, "POL", 1, 0, 8191, 0, true},
    {Setting::boot_outputs, "DOBOOT", 1, 0, 7, 7, true},
    {Setting::boot_enables, "EOBOOT", 1, 0, 1, 0, true},
    {Setting::ignore_errors, "IERR", 1, 0, 1, 0, true},
    {Setting::sync_condition, "SYNC", 1, 1, 3, 1, false},
    {Setting::sync_position, "SYNP", 1, arcus::position_min, arcus::position_max, 0, false},
    {Setting::loop_ratio, "SLR", 1, 1, 999'999, 800, true, false, Notation::thousandths},
    {Setting::loop_tolerance, "SLT", 1, 0, arcus::position_max, 20, true},
    {Setting::loop_range, "SLE", 1, 0, arcus::position_max, 1000, true},
    {Setting::loop_attempts, "SLA", 1, 0, arcus::position_max, 10, true},
    {Setting::loop_idle_tolerance, "SLM", 1, 0, arcus::position_max, 5, true},
    {Setting::loop, "SL", 1, 0, 1, 1, true},
    {Setting::comm_timeout, "TOC", 1, 0, arcus::max_number, 0, true},
    {Setting::boot_programs, "SLOAD", 1, 0, 3, 0, true},
    {Setting::auto_response, "AR", 1, 0, 1, 0, true},
    {Setting::line_type, "CM", 1, 0, 1, 0, true},
    {Setting::idle_current, "CURI", 1, arcus::min_current, arcus::max_current, 1000, true, true},
    {Setting::run_current, "CURR", 1, arcus::min_current, arcus::max_current, 1600, true},
    {Setting::idle_time, "CURT", 1, 10, 1000, 500, true},
    {Setting::modbus_number, "DNM", 1, 1, 127, 1, true},
    {Setting::modbus, "RSM", 1, 0, 1, 0, true},
    {Setting::status_outputs, "EDO", 1, 0, 1, 1, true},
    {Setting::home_correction, "HCA", 1, 0, arcus::position_max, 1000, true},
    {Setting::limit_correction, "LCA", 1, 0, arcus::position_max, 1000, true},
    {Setting::response_type, "RT", 1, 0, 1, 0, true},
    {Setting::return_to_zero, "RZ", 1, 0, 1, 0, true},
}};

inline constexpr arcus::Model model{
    .name = "dmx-k-sa",
    .title = "DMX-K-SA",
    .axis_letters = "X",
    .name_prefix = "DMK",
    .product = arcus::dmx_product,
    .version = "V340BL",
    .reply_end = '\0',
    .broadcast = broadcast,
    .inputs = inputs,
    .outputs = outputs,
    .enables = enables,
    .analog_inputs = 0,
    .programs = programs,
    .latch_inputs = {latch_input},
    .sync_outputs = {sync_output},
    .counts_denominator = pulses_per_turn,
    .counts_numerator = counts_per_turn,
    .index_every = pulses_per_turn,
    .status = {.accelerating = 1,  // table 7.3
               .decelerating = 2,
               .constant = 0,
               .alarm = arcus::no_bit,
               .plus_limit = 5,
               .minus_limit = 4,
               .home = 3,
               .plus_error = 7,
               .minus_error = 6,
               .alarm_error = arcus::no_bit,
               .latch = 8,
               .index = 9,
               .timed_out = 10},
    .polarity = {.home = {5, true},  // table 7.2, decision AMB-090
                 .alarm = arcus::no_polarity,
                 .limit = {4, true},
                 .direction = {1, true},
                 .latch = {6, true},
                 .in_position = {7, true},
                 .alarm_output = {8, true},
                 .outputs = {9, true},
                 .inputs = {10, true},
                 .jump = {11, true},
                 .enable = {12, true}},
    .speeds = speed_rows,
    .settings = settings,
    .refusals = {"OK", "", "?Index out of Range", "?State Error", "?State Error", "?State Error", "?Moving",
                 "", "?Motor is not moving", "?Sub not Initialized", "", "", "?Bad SSPD Command", "?SCV ON",
                 "?Speed out of range", "?Enable RS-485 Mode"},
    .in_position_output = in_position_output,
    .alarm_output = alarm_output,
    .positions_may_be_written_in_loop = true,
};

}  // namespace hw::dmx_k_sa
