// A series of one part with known truth: scans of copies whose seat drifts as the tool wears, and three bad ones, with
// the recipe that finds them.
//
// Files: original.ply; parts/part-0001.ply …; recipe.json of compare, with limits on the seat; truth.json: the oversize
// of the seat of each part, in µm on radius, and which are out of tolerance. Marked synthetic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::sample {

inline constexpr int fewestParts = 8;  ///< of a series: three of them are bad

struct SeriesModel {
    int parts = 30;           ///< at least fewestParts
    int points = 3000;        ///< of a scan, about; below, small defects could hide. The original has ten times as many
    std::uint64_t seed = 1;   ///< the same gives the same bytes
    double drift_um = 16;     ///< of the seat's radius from the first part to the last, about the nominal one
    double bad_um = 70;       ///< on the radius of the three bad parts, beside the drift
    double limit_mm = 0.04;   ///< of the deviation on the seat, both sides
    double sigma_mm = 0.004;  ///< of the scanner
    double spot_mm = 0.02;    ///< of the scanner
};

/// From 0, ascending: a quarter, a half and seven eighths through the series.
std::vector<int> badParts(const SeriesModel& model);

/// Of the seat's radius of the part `number`, from 0.
double oversize_um(const SeriesModel& model, int number);

/// Writes the files into the folder, which is made. Gives their paths: original, recipe, truth, parts in order. Error
/// fileNotWritable. Throws Cancelled.
std::vector<std::string> writeSeries(const std::string& directory, const SeriesModel& model,
                                     const Progress& progress = {});

}  // namespace lathelier::sample
