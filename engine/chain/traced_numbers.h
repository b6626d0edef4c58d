// Which numbers of a step's result belong in the dossier, and where in the result they stand.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/json.h"

namespace lathelier::chain {

/// A number with the place where it is written. Keys carry the unit, as everywhere in results.
struct TracedNumber {
    std::string step;                   ///< id of the step that computed it
    std::string key;                    ///< last part of its place: "start_diameter_mm"
    double value = 0;                   ///< as written
    std::string file;                   ///< result of the step
    std::string pointer;                ///< RFC 6901: "/segments/0/start_diameter_mm"
    std::optional<double> uncertainty;  ///< none: not stated
    std::int64_t coverage_factor = 2;   ///< k of the uncertainty; 1: a standard uncertainty
    std::string uncertainty_pointer;    ///< where that is written; its last part has its unit
};

/// The numbers of a step's result that are there. `file` is its path.
std::vector<TracedNumber> numbersOf(const std::string& step, const Json& result, const std::string& file);

}  // namespace lathelier::chain
