// Which channels of a record are the hammer and the sensor, and what their values are in N and mm.
#pragma once

#include <optional>
#include <string>

#include "engine/core/fields.h"
#include "engine/io/time_record/time_record.h"
#include "engine/receptance/tap/tap.h"

namespace lathelier::receptance {

struct TapChannels {
    std::string hammer;                  ///< name or number of the channel of the force; empty: by unit and name
    std::string response;                ///< of the motion
    std::string hammer_sensitivity;      ///< "2.25 mV/N", "500 N"; empty: the unit that the record states
    std::string response_sensitivity;    ///< "100 mV/g", "10 mV/(m/s^2)"
    std::optional<double> full_scale_V;  ///< of a WAV file
    std::optional<double> rate_hz;       ///< of a record without times
};

const std::vector<Field<TapChannels>>& fieldsOf(const TapChannels*);

struct TapMeasured {
    TapSignals both;
    FrfQuantity quantity = FrfQuantity::Accelerance;  ///< of the motion, per force
    int response_node = 0, response_direction = 0;    ///< of a universal file; 0: not stated
    int hammer_node = 0, hammer_direction = 0;        ///< likewise
};

/// A stated unit rules over a given sensitivity, stated times over a given rate; notes tapSensitivityNotUsed,
/// tapRateNotUsed. Errors valueNotUnderstood (a channel that is not there, a sensitivity), tapChannelUnclear,
/// tapUnitMissing, tapFullScaleMissing, tapRateMissing, tapSampleMissing, tapChannelsDiffer; all with `path`.
TapMeasured takeSignals(const io::TimeRecord& record, const std::string& path, const TapChannels& channels,
                        Notes& notes);

}  // namespace lathelier::receptance
