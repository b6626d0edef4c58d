// Choice of the unit of a file's lengths.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/core/error.h"
#include "engine/io/text/units.h"

namespace lathelier::io {

/// Larger coordinates are rejected with their place in the file: 10 km, the limit of the registration, which could not
/// state a line.
inline constexpr double largestCoordinate_mm = 1e7;

/// largestCoordinate_mm in the unit of the file, in mm while the unit is unknown.
double largestCoordinate(const std::optional<LengthScale>& stated, const ImportOptions& options);

/// A stated unit has precedence (note unitNotUsed when another is given), else the given one, else an extent of 1 to 10
/// 000 is read as mm (note unitGuessed), else Error unitUnknown. Enters `unit` and `unit_source` into the facts.
LengthScale chooseLengthUnit(const std::optional<LengthScale>& stated, const ImportOptions& options, double extent,
                             FileFacts& facts, Notes& notes);

/// Root mean square distance of the points from their mean: a size that no motion changes. 0 without points.
double sizeOf_mm(const std::vector<Eigen::Vector3d>& points_mm);

/// How many times larger or smaller one unit of length is than another where the sizes of two parts differ by just that
/// much, within a fifth: 25.4 (inch in mm), 1000, 304.8, 39.37 (m in inch), 10; none for parts of like or other sizes.
std::optional<double> unitFactorBetween(double size_a_mm, double size_b_mm);

}  // namespace lathelier::io
