// Cutting planes of sections in the main view (ISO 128-3), and the sections beside or below it.
#pragma once

#include <string>
#include <vector>

#include "engine/drawing/dimension_lines.h"
#include "engine/drawing/layout.h"
#include "engine/drawing/marks/cross_section.h"

namespace lathelier::drawing {

inline constexpr double cutArrowOffset_mm = 5;  ///< from the view to the arrows of the first lane

struct CutPlace {
    double x_mm = 0;
    std::string letter;
    int lane = 0;  ///< of its arrows and letters: those of near planes stand further from the view
};

/// In the order of the sections, each within its stretch, as far as possible from `lines` and from each other.
std::vector<CutPlace> cutPlaces(const std::vector<CrossSection>& sections, double factor,
                                const std::vector<double>& lines);

/// Height from the view that planes need for their arrows and letters.
double cutHeight(const std::vector<CutPlace>& cuts, double height_mm);

/// Above or below an edge of the view; letters keep clear of `verticals`.
void paintCuts(const std::vector<CutPlace>& cuts, double edge_mm, bool above, const std::vector<double>& verticals,
               DimensionPainter& paint, Drawing& drawing);

/// All sections, beside the view on its axis, or in rows below it.
void addSections(const std::vector<CrossSection>& sections, const LayoutStyle& style, Drawing& drawing);

}  // namespace lathelier::drawing
