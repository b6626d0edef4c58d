// What the assistant reads from a control and writes to it, by name, and the states it tells.
//
// The handshake: the control writes D, L, v_c and its range, then a request other than 0 and other than the last one.
// They stay as they are until the request is answered. The assistant reads them, computes, and reads them again; sets
// the state to 0; writes N_cor, and reads them once more; then writes the state; then `answered` = the request. All
// that is written is read back. N_cor holds for the control only where its request is not 0, `answered` equals it, and
// the state is 1. A control with one bit sets the request to 1 and, after the answer, to 0: the assistant then sets
// `answered` to 0. One that gives up waiting keeps 0 until the heartbeat has changed twice, for the answer may be under
// way.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/text.h"

namespace lathelier::link {

/// Values by name, as a control states them: in the units of the names.
using ControlValues = std::map<std::string, double>;

// read
inline constexpr const char* requestName = "request";            ///< 0: none; else the number of the request
inline constexpr const char* runningName = "running";            ///< not 0: the machine moves or its spindle turns
inline constexpr const char* diameterName = "diameter_mm";       ///< D
inline constexpr const char* lengthName = "length_mm";           ///< L: overhang
inline constexpr const char* speedName = "cutting_speed_m_min";  ///< v_c selected
inline constexpr const char* lowestName = "lowest_m_min";        ///< least v_c of the insert
inline constexpr const char* highestName = "highest_m_min";      ///< greatest v_c of the insert
inline constexpr const char* depthName = "depth_mm";             ///< depth of cut, where the control states one
// written
inline constexpr const char* correctedName = "n_cor_rpm";  ///< N_cor
inline constexpr const char* stateName = "state";          ///< State
inline constexpr const char* answeredName = "answered";    ///< the request that N_cor and state belong to
inline constexpr const char* heartbeatName = "heartbeat";  ///< another number every period while the assistant lives

/// Names of what is read and of what is written, in the order above.
const std::vector<std::string>& readNames();
const std::vector<std::string>& writtenNames();

/// Whole numbers of a register of 16 bits with sign: requests and heartbeats go from 1 to this and begin anew.
inline constexpr std::int64_t mostCount = 32000;

/// What the control's screen shows. Only with `Ok` N_cor was written.
enum class State {
    Idle = 0,               ///< no request stands
    Ok = 1,                 ///< N_cor holds
    NoStableSpeed = 2,      ///< no stable speed in the range
    OutOfRange = 10,        ///< a value is outside of what is allowed, or the range runs backwards
    NotUnderstood = 11,     ///< a value is no number, or the request none of a request
    Running = 12,           ///< the machine runs
    Changed = 13,           ///< the values or the program changed while they were answered
    AboveSpeedLimit = 14,   ///< N_cor is above the machine's highest speed
    NotComputed = 15,       ///< the response at the tool cannot be computed with these values
    NotWritten = 16,        ///< N_cor read back is another one than was written
    ProgramNotUsable = 17,  ///< D or L is to come from the loaded program, which does not give them
    NotModelled = 18,       ///< something that could change N_cor was not understood or is not modelled
};

/// "ok", "no_stable_speed", … as the log and JSON have it.
const char* nameOf(State state);
std::optional<State> stateOfNumber(std::int64_t number);

/// "no stable speed in the range", as a screen shows it.
Text textOf(State state);

}  // namespace lathelier::link
