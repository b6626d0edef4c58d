// Question of the panel Spindle: source of the receptance of the chuck face.
#pragma once

#include <optional>
#include <string>

#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/library.h"

namespace lathelier::machine_panel {

/// Sources beside the machines of the library, which have their keys: identified from tap tests, or typed.
inline constexpr const char* measuredSource = "measured";
inline constexpr const char* springsSource = "springs";

struct MachineQuestion {
    std::string source = measuredSource;                  ///< source of the receptance
    receptance::SpindleSprings springs;                   ///< of springsSource
    receptance::IdentificationParameters identification;  ///< of measuredSource
    std::optional<double> limit_percent;                  ///< largest residual that is accepted; none: no verdict
};

const std::vector<Field<MachineQuestion>>& fieldsOf(const MachineQuestion*);

inline constexpr const char* sourceKey = "source";  ///< key of the choice

}  // namespace lathelier::machine_panel
