// Question of the panel Spindle: source of the receptance of the chuck face.
#pragma once

#include <optional>
#include <string>

#include "engine/receptance/eirc/identify_spindle.h"
#include "widgets/chatter_common/libraries.h"

namespace lathelier::machine_panel {

/// Measured: identified from tap tests. Springs: typed. The others are those of the library, in its order.
enum class MachineSource { Measured, Springs, Papers, Stiff, Soft };

/// Of the library; Stated for the first two.
chatter_common::MachineChoice ofLibrary(MachineSource source);

struct MachineQuestion {
    MachineSource source = MachineSource::Measured;       ///< source of the receptance
    receptance::SpindleSprings springs;                   ///< of MachineSource::Springs
    receptance::IdentificationParameters identification;  ///< of MachineSource::Measured
    std::optional<double> limit_percent;                  ///< largest residual that is accepted; none: no verdict
};

const std::vector<Field<MachineQuestion>>& fieldsOf(const MachineQuestion*);

inline constexpr const char* sourceKey = "source";  ///< key of the choice

}  // namespace lathelier::machine_panel
