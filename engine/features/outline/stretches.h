// Chains of walls cut into stretches between shoulders, steps, gaps and rough zones.
#pragma once

#include <vector>

#include "engine/features/outline/outline.h"
#include "engine/features/outline/wear.h"

namespace lathelier::features {

/// Kind of a stretch's end. Step: of the radius, too small for a shoulder. Rough: start or end of a thread or knurl;
/// Lead: the same on a cone.
enum class Border { Shoulder, Step, Gap, Rough, Lead, End };

/// Elements between two borders, before planes are made of these.
struct Stretch {
    std::vector<Element> elements;  ///< in order of z
    std::vector<double> nodes_mm;   ///< z of the junctions, starting values: one more than elements
    double from_mm = 0, to_mm = 0;  ///< of its walls
    Border after = Border::End;     ///< toward larger z
    std::vector<Wall> coarse;       ///< walls that it was made from
    std::vector<Wall> crests;       ///< of these, those over the crests of a rough zone
    std::vector<Wear> worn;         ///< wear subtracted from its walls
};

/// Chains of one side, without those that lie beside a longer one.
std::vector<const Chain*> chainsOf(const Walls& walls, bool bore);

/// Slope of the walls about one of them.
double slopeAt(const std::vector<Wall>& walls, std::size_t i);

/// All of one side in order of z; rough zones and merged junctions go into the outline.
std::vector<Stretch> stretchesOf(const OutlineInput& input, Outline& outline, const Progress& progress);

}  // namespace lathelier::features
