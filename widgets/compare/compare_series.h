// The further copies of a comparison, judged one after the other by the parameters of the first.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/project/project.h"
#include "engine/registration/copies.h"
#include "widgets/compare/compare_picture.h"

namespace lathelier::compare_panel {

/// Key of the input that holds them.
inline constexpr const char* copiesRole = "copies";

/// The sources of the further copies, in order.
std::vector<project::Source> furtherCopies(const project::PanelState& state);

/// The comparisons of the further copies. A change of the limits alone is judged anew from them, in milliseconds. Safe
/// from any thread.
class KnownCopies {
public:
    /// The summary of the copy on screen, then those of the further ones. A copy that cannot be read or compared says
    /// why and stops no other. Scans are not kept. Throws Cancelled.
    std::vector<registration::CopySummary> find(const project::PanelState& state, const ComparePicture& shown,
                                                const Progress& progress);

private:
    struct Known {
        std::string stamp;      ///< fileStamp() of the copy when it was read
        std::string reference;  ///< SHA-256 of the reference that it was compared with
        InputFile file;         ///< the copy
        std::shared_ptr<const registration::CompareResult> result;
    };
    void forgetOthers(const std::vector<project::Source>& sources);
    Known compared(const project::Source& source, const ComparePicture& shown,
                   const registration::CompareParameters& parameters, const Progress& progress);

    std::mutex mutex_;
    std::map<std::string, Known> known_;  ///< by the copy's path and import
};

}  // namespace lathelier::compare_panel
