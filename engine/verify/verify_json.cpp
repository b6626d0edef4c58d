#include "engine/verify/verify_json.h"

#include <nlohmann/json.hpp>

namespace lathelier::verify {

Json toJson(const VerifyResult& result)
{
    Json json;
    json["kinds"] = Json::array();
    for (const VerifyKind& kind : result.kinds)
        json["kinds"].push_back({{"kind", kind.kind},
                                 {"sets", kind.sets},
                                 {"largest_deviation", number(kind.largest_deviation)},
                                 {"unit", kind.unit.empty() ? "1" : kind.unit.english},
                                 {"limit", kind.limit},
                                 {"pass", kind.pass}});
    json["reference_data"] = result.reference_data.empty() ? Json(nullptr) : Json(result.reference_data);
    json["verdict"] = result.pass ? "pass" : "fail";
    return json;
}

}  // namespace lathelier::verify
