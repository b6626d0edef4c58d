// Contribution of a room to the sample project: files with known truth and the panels that open them. A room describes
// its part; engine/sample collects them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/core/value.h"

namespace lathelier {

/// A panel as the sample project opens it.
struct SamplePanel {
    std::map<std::string, std::string> inputs;  ///< role to the name of one of the part's files
    Values parameters;                          ///< by key; all others have their defaults
    bool in_report = false;                     ///< is in the report of the project
};

/// The files and panels of a part.
struct SampleContent {
    std::vector<std::string> texts;             ///< content of each file, in the order of SamplePart::files
    std::shared_ptr<const Json> truth;          ///< an object: its members go into truth.json
    std::map<std::string, SamplePanel> panels;  ///< by panel id
};

/// The part of one room. All files state in themselves that they are synthetic.
struct SamplePart {
    std::string key;                 ///< of what is shown, "scans"
    std::vector<std::string> files;  ///< names of the files it makes
    /// The same seed gives the same bytes. Throws Cancelled.
    std::function<SampleContent(std::uint64_t seed, const Progress&)> make;
};

}  // namespace lathelier
