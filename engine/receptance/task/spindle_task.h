// The task spindle: the receptance of the chuck face of a machine, identified from tap tests on rods (inverse
// coupling), or of two springs that are stated or of a machine of the library. The verb and the panel Spindle.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/eirc/spindle_check.h"
#include "engine/receptance/library.h"
#include "engine/receptance/spindle/spindle_kind.h"
#include "engine/task/task.h"

namespace lathelier::receptance {

inline constexpr const char* measurementsRole = "measurements";

/// Tap tests as an input.
struct MeasurementsInput {
    using File = TapTests;
    using Value = SpindleMeasurements;
    static constexpr const char* item = "";

    static File read(const io::FileToRead& file) { return loadTapTests(file); }
    static Value valueOf(const File& file) { return file.measurements; }
    static io::FileKinds kinds() { return {&measurementFiles()}; }
};

/// Sources beside the machines of the library, which have their keys: identified from tap tests, or stated.
inline constexpr const char* measuredSource = "measured";
inline constexpr const char* springsSource = "springs";

struct SpindleQuestion {
    std::string source = measuredSource;      ///< source of the receptance
    SpindleSprings springs;                   ///< of springsSource
    IdentificationParameters identification;  ///< of measuredSource
    std::optional<double> limit_percent;      ///< largest residual that is accepted; none: no verdict
};

const std::vector<Field<SpindleQuestion>>& fieldsOf(const SpindleQuestion*);

inline constexpr const char* sourceKey = "source";  ///< key of the choice

struct SpindleOutcome : task::Answered {
    SpindleQuestion question;                                 ///< the parameters as a value
    SpindleReceptance spindle;                                ///< receptance of the chuck face
    std::shared_ptr<const SpindleIdentification> identified;  ///< null: springs
    std::shared_ptr<const SpindleCheck> check;                ///< residuals of the identification; null: springs
    UsedValues used;                                          ///< springs or materials with their origin
};

/// Errors: those of loadTapTests() and identifySpindle(); oneNeeded without tap tests where they are the source. Throws
/// Cancelled.
SpindleOutcome answerSpindle(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress);

/// The residual against its limit, or the static compliance of the springs.
report::Answer answer(const SpindleOutcome& outcome, const Language& language = {});

task::Outcome outcomeOf(const std::shared_ptr<const SpindleOutcome>& outcome);

inline constexpr const char* spindleExport = "output";
inline constexpr const char* magnitudeExport = "csv";

const task::Task& spindleTask();

}  // namespace lathelier::receptance
