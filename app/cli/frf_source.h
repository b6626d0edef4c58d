// Source of the frequency response for lobes and speeds: a file, modes, or a shaft on its spindle.
#pragma once

#include "app/cli/verb.h"
#include "engine/core/frf.h"
#include "engine/core/used_value.h"
#include "engine/stability/modes.h"

namespace lathelier::cli {

/// Result of reading a source.
struct FrfSource {
    Frf frf;          ///< a receptance, mm/N
    UsedValues used;  ///< assumed values
};

/// Options of a source.
struct SourceParameters {
    std::vector<stability::Mode> mode;  ///< given by hand
    std::string shaft;                  ///< path of a shaft that is computed; empty: none
};

const std::vector<Field<SourceParameters>>& fieldsOf(const SourceParameters*);

/// Error valueNotUnderstood unless the request names one source: a file, modes, or a shaft.
void checkOneSource(const Request& request, const SourceParameters& source);

/// The options --mode and --shaft, and those of the verb `frf` that say how a shaft is computed.
std::vector<Option> frfSourceOptions();

/// Reads or computes it. `highest_speed_rpm`: that the lobes have to reach. Errors: valueNotUnderstood when the request
/// names no source or more than one; those of readers and of the computation. Throws Cancelled.
FrfSource frfSource(const Request& request, double highest_speed_rpm, io::InputFiles& inputs, const Progress& progress,
                    Answer& answer);

}  // namespace lathelier::cli
