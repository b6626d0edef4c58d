// Probe records as the input of a task: read and evaluated once for all tasks that ask, and one section chosen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/io/probe/probe_input.h"
#include "engine/report/document.h"
#include "engine/task/task.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

inline constexpr const char* recordRole = "record";
inline constexpr const char* sectionKey = "section";  ///< number of the chosen section; none: the worst one

using RecordPtr = std::shared_ptr<const Loaded<io::ProbeFile>>;

/// The input: one record of all sections, or one for each.
task::Input recordInput(const char* option);

/// TakenRecords as read, in the order of the inputs.
struct TakenRecords {
    std::vector<RecordPtr> files;  ///< never null
    std::string key;               ///< content and how it was read
};

/// Errors: those of readProbeRecord(), with the path. Throws Cancelled.
TakenRecords takeRecords(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress);

/// What the evaluation of these records depends on, to the last bit.
std::string keyOf(const TakenRecords& records, const TrajectoryParameters& parameters);

/// Never null. Errors: those of trajectory(). Throws Cancelled.
std::shared_ptr<const TrajectoryResult> evaluate(const TakenRecords& records, const TrajectoryParameters& parameters,
                                                 Stores& stores, const Progress& progress);

/// Index of the section with this number; without a number, or where there is none of it, that of the worst one.
std::optional<std::size_t> sectionIndex(const TrajectoryResult& result, std::optional<int> number);

/// "Section 7 of 20, 35 mm from the free end": which section of a record a report refers to.
report::Paragraph sectionSentence(const TrajectoryResult& result, const TrajectorySection& section);

/// Puts it below the headline, and what the evaluation has taken from the record into the headline.
void addSectionSentence(report::Document& document, const TrajectoryResult& result, const TrajectorySection& section);

}  // namespace lathelier::trajectory
