// Numbers of the result of a step that are recorded in the dossier, with their positions.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/json.h"

namespace lathelier::chain {

/// A number with its position in a file. Keys carry the unit.
struct TracedNumber {
    std::string step;                   ///< id of the step that computed it
    std::string key;                    ///< last part of its pointer: "start_diameter_mm"
    double value = 0;                   ///< as written
    std::string file;                   ///< result of the step
    std::string pointer;                ///< RFC 6901: "/segments/0/start_diameter_mm"
    std::optional<double> uncertainty;  ///< none: not stated
    std::int64_t coverage_factor = 2;   ///< k of the uncertainty; 1: a standard uncertainty
    std::string uncertainty_pointer;    ///< pointer of the uncertainty; its last part has the unit
};

/// The recorded numbers of the result of a step. `file` is its path.
std::vector<TracedNumber> numbersOf(const std::string& step, const Json& result, const std::string& file);

}  // namespace lathelier::chain
