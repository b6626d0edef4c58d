// The task tap: from the records of an impact test, hammer and sensor over time, to a frequency response. The verb tap
// and the panel Tap test.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/io/frf/measured_frf.h"
#include "engine/receptance/tap/tap_channels.h"
#include "engine/receptance/tap/tap_study.h"
#include "engine/task/task.h"

namespace lathelier::receptance {

struct TapQuestion {
    TapChannels channels;
    TapParameters evaluation;
    std::string nodes;  ///< "12/5", "12x/5x": of response and force, for UFF; empty: those of the record
};

const std::vector<Field<TapQuestion>>& fieldsOf(const TapQuestion*);

inline constexpr const char* tapRecordRole = "record";

struct TapOutcome : task::Answered {
    TapQuestion question;
    TapStudy study;
    io::MeasuredFrf response;  ///< receptance over the usable lines, with nodes
};

/// All records have one rate and quantity, else error tapChannelsDiffer. Errors: those of the readers, takeSignals(),
/// evaluateTaps(). Throws Cancelled.
TapOutcome answerTap(const project::PanelState& state, Stores& stores, task::Sources& sources,
                     const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const TapOutcome>& outcome);

const task::Task& tapTask();

}  // namespace lathelier::receptance
