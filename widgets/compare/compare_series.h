// The further copies of a comparison, judged one after the other by the parameters of the first.
#pragma once

#include <map>
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

/// What is known of copies that were compared already. Safe from any thread.
class KnownCopies {
public:
    /// The summary of the copy on screen, then those of the further ones. A copy that cannot be read or compared says
    /// why and stops no other. Scans are not kept. Throws Cancelled.
    std::vector<registration::CopySummary> find(const project::PanelState& state, const ComparePicture& shown,
                                                const Progress& progress);

private:
    std::mutex mutex_;
    std::map<std::string, registration::CopySummary> known_;  ///< by reference, copy and parameters
};

}  // namespace lathelier::compare_panel
