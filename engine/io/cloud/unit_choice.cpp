#include "engine/io/cloud/unit_choice.h"

#include <algorithm>
#include <cmath>

#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

constexpr double smallestGuess = 1;
constexpr double largestGuess = 10000;

}  // namespace

double largestCoordinate(const std::optional<LengthScale>& stated, const ImportOptions& options)
{
    const std::optional<LengthScale> known = stated ? stated : lengthScale(options.unit);
    return known ? largestCoordinate_mm / known->mm : largestCoordinate_mm;
}

LengthScale chooseLengthUnit(const std::optional<LengthScale>& stated, const ImportOptions& options, double extent,
                             FileFacts& facts, Notes& notes)
{
    const std::optional<LengthScale> given = lengthScale(options.unit);
    LengthScale unit{"mm", 1};
    if (stated) {
        unit = *stated;
        facts.unit_source = "stated";
        if (given && given->key != stated->key)
            notes.push_back({notes::unitNotUsed, {{"unit", stated->key}, {"given", given->key}}});
    } else if (given) {
        unit = *given;
        facts.unit_source = "given";
    } else {
        if (!(extent >= smallestGuess && extent <= largestGuess))
            throw Error(errors::unitUnknown, {{"extent", extent}});
        facts.unit_source = "guessed";
        notes.push_back({notes::unitGuessed, {{"unit", unit.key}, {"extent", extent}}});
    }
    facts.unit = unit.key;
    return unit;
}

double sizeOf_mm(const std::vector<Eigen::Vector3d>& points_mm)
{
    if (points_mm.empty()) return 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points_mm) mean += point;
    mean /= static_cast<double>(points_mm.size());
    double squares = 0;
    for (const Eigen::Vector3d& point : points_mm) squares += (point - mean).squaredNorm();
    return std::sqrt(squares / static_cast<double>(points_mm.size()));
}

std::optional<double> unitFactorBetween(double size_a_mm, double size_b_mm)
{
    constexpr double tolerance = 1.2;
    if (!(size_a_mm > 0) || !(size_b_mm > 0)) return std::nullopt;
    const double ratio = std::max(size_a_mm, size_b_mm) / std::min(size_a_mm, size_b_mm);
    for (const double factor : {10.0, 25.4, 1000 / 25.4, 304.8, 1000.0})
        if (ratio > factor / tolerance && ratio < factor * tolerance) return factor;
    return std::nullopt;
}

}  // namespace lathelier::io
