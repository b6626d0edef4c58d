#include "engine/form/circles_json.h"

#include <nlohmann/json.hpp>

namespace lathelier::form {
namespace {

/// What all four have; a number that does not exist is null.
Json common(const FittedCircle& circle)
{
    return {{"centre_x_mm", number(circle.centre_mm.x())},
            {"centre_y_mm", number(circle.centre_mm.y())},
            {"radius_mm", number(circle.radius_mm)},
            {"inner_radius_mm", number(circle.inner_radius_mm)},
            {"outer_radius_mm", number(circle.outer_radius_mm)},
            {"RONt_um", number(circle.RONt_um)}};
}

/// What the exact ones have besides.
Json exact(const FittedCircle& circle)
{
    Json json = common(circle);
    json["contacts"] = Json::array();
    for (const CircleContact& contact : circle.contacts)
        json["contacts"].push_back(
            {{"index", contact.index}, {"side", contact.side == CircleContact::Side::Outer ? "outer" : "inner"}});
    json["certified_gap_um"] = number(circle.certified_gap_um);
    json["unique"] = circle.unique;
    return json;
}

}  // namespace

Json toJson(const ReferenceCircles& circles)
{
    Json least_squares = common(circles.LSCI);
    least_squares["RONp_um"] = number(circles.LSCI.RONp_um);
    least_squares["RONv_um"] = number(circles.LSCI.RONv_um);
    least_squares["RONq_um"] = number(circles.LSCI.RONq_um);
    return {{"LSCI", least_squares},
            {"MZCI", exact(circles.MZCI)},
            {"MICI", exact(circles.MICI)},
            {"MCCI", exact(circles.MCCI)}};
}

}  // namespace lathelier::form
