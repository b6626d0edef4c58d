// ASSIST.json, the configuration of an assistant beside a control:
//   {"schema": "lathelier-assist", "schema_version": 1,
//    "inputs": {"spindle": {"path": "spindle.json", "reading": {…}}},      of the task speed
//    "parameters": {"relation": "published", "peak_shift": 0.7, …},        likewise, less what the control states
//    "limits": {"highest_rpm": 4000, "lowest_diameter_mm": 5, …},
//    "program": {"clearance_mm": 20},                                      D and L of the program, where it is there
//    "loop": {"poll_ms": 10, "heartbeat_ms": 500, "reconnect_ms": 500, "timeout_ms": 500},
//    "loopback": {"host": "127.0.0.1", "port": 7660},
//    "linuxcnc": {"component": "lathelier", "program_port": 5007, "program_password": "EMC"},
//    "focas": {"library": "libfwlib32.so", "host": "192.168.1.10", "port": 8193,
//              "registers": {"diameter_mm": {"address": 1000, "bytes": 4, "scale": 0.001}, …}}}
// Paths are relative to the file. A member that is not known is refused by its place: what was meant to hold would not.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/input_file.h"
#include "engine/core/progress.h"
#include "engine/link/assistant.h"
#include "engine/link/link_loop.h"
#include "engine/link/registers.h"

namespace lathelier::link {

inline constexpr const char* assistSchema = "lathelier-assist";
inline constexpr int assistVersion = 1;

/// Of the loop, with the time-out of the transports.
struct LoopFields {
    double poll_ms = 10;        ///< LoopSettings
    double heartbeat_ms = 500;  ///< likewise
    double reconnect_ms = 500;  ///< likewise
    double timeout_ms = 500;    ///< of one answer of the control
};

/// A simulated control.
struct LoopbackSettings {
    std::string host = "127.0.0.1";  ///< where it listens
    int port = 7660;                 ///< likewise
};

/// A component of LinuxCNC's hardware abstraction layer (HAL).
struct LinuxCncSettings {
    std::string component = "lathelier";   ///< name of the component, before that of each pin
    int program_port = 0;                  ///< of linuxcncrsh, which names the loaded program; 0: none
    std::string program_password = "EMC";  ///< that linuxcncrsh asks for on this port; no secret
};

struct FocasSettings {
    std::string library = "libfwlib32.so";  ///< the vendor's, as the user has it; a path where it has a slash
    std::string host;                       ///< of the control
    int port = 8193;                        ///< likewise
    Registers registers;                    ///< by name, see control_values.h
};

struct LinkConfig {
    project::PanelState question;              ///< inputs and parameters of the task speed
    Limits limits;                             ///< of what may be asked
    std::optional<OfProgram> program;          ///< none: D and L have to be stated
    LoopFields loop;                           ///< periods and time-out
    std::optional<LoopbackSettings> loopback;  ///< none: not configured
    std::optional<LinuxCncSettings> linuxcnc;  ///< likewise
    std::optional<FocasSettings> focas;        ///< likewise
    InputFile file;                            ///< it was read from
};

const std::vector<Field<Limits>>& fieldsOf(const Limits*);
const std::vector<Field<OfProgram>>& fieldsOf(const OfProgram*);
const std::vector<Field<LoopFields>>& fieldsOf(const LoopFields*);
const std::vector<Field<LoopbackSettings>>& fieldsOf(const LoopbackSettings*);
const std::vector<Field<LinuxCncSettings>>& fieldsOf(const LinuxCncSettings*);
const std::vector<Field<Register>>& fieldsOf(const Register*);
const std::vector<Field<FocasSettings>>& fieldsOf(const FocasSettings*);

LoopSettings loopSettings(const LinkConfig& config, bool is_once);

/// A configuration whose file stands in `folder`. Errors, with line and column: malformed, keyMissing, keyOutOfRange,
/// linkMemberUnknown. The files of its inputs are not opened: Assistant::prepare().
LinkConfig readConfig(const std::string& text, const std::string& folder);

/// The same of a file. Errors of FileBytes besides, all with the path. Throws Cancelled.
LinkConfig loadConfig(const std::string& path, const Progress& progress = {});

/// The text of a configuration whose file will stand in `folder`.
std::string textOf(const LinkConfig& config, const std::string& folder);

}  // namespace lathelier::link
