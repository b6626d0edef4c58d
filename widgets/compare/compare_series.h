// Sequential comparison of further copies with the parameters of the first.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/project/project.h"
#include "engine/registration/copies.h"
#include "widgets/compare/compare_outcome.h"

namespace lathelier::compare_panel {

/// Key of their input.
inline constexpr const char* copiesRole = "copies";

/// The sources of the further copies, in order.
std::vector<project::Source> furtherCopies(const project::PanelState& state);

/// Cached comparisons of the further copies. A change of the limits alone only repeats the decision, in milliseconds.
/// Thread-safe.
class KnownCopies {
public:
    /// The summary of the copy on screen, then those of the further ones. A copy that cannot be read or compared gets
    /// its error and does not stop the others. Scans are not kept. Throws Cancelled.
    std::vector<registration::CopySummary> find(const project::PanelState& state, const CompareOutcome& shown,
                                                const Progress& progress);

private:
    struct Known {
        std::string stamp;      ///< fileStamp() of the copy when it was read
        std::string reference;  ///< SHA-256 of the reference that it was compared with
        InputFile file;         ///< file of the copy
        std::shared_ptr<const registration::CompareResult> result;
    };
    void forgetOthers(const std::vector<project::Source>& sources);
    Known compared(const project::Source& source, const CompareOutcome& shown,
                   const registration::CompareParameters& parameters, const Progress& progress);

    std::mutex mutex_;
    std::map<std::string, Known> known_;  ///< results by path and import options of the copy
};

}  // namespace lathelier::compare_panel
