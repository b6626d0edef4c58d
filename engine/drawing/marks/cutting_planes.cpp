#include "engine/drawing/marks/cutting_planes.h"

#include <algorithm>
#include <cmath>

#include "engine/drawing/marks/section_drawing.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double shaft_mm = 2 * arrow_mm;  // of an arrow of a cutting plane
constexpr double besideOther_mm = 11;      // of planes whose arrows and letters may stand on one lane
constexpr double enoughClearance_mm = 2.5;
constexpr double laneHeights = 2.4;  // of a lane of letters, in heights of lettering
constexpr double sectionGap_mm = 8;

double clearanceOf(double x, const std::vector<double>& lines)
{
    double least = enoughClearance_mm;
    for (const double line : lines) least = std::min(least, std::abs(line - x));
    return least;
}

/// Where a letter stands beside its arrow: behind it, at the plane's end or beyond the plane; what no line crosses.
Label letterLabel(const CutPlace& cut, double y, bool above, const std::vector<double>& verticals, double height_mm)
{
    const double outer = above ? y + 0.45 * height_mm : y - 1.35 * height_mm;
    std::vector<Label> places;
    for (const auto& [at, anchor] :
         {std::pair(Vector2d(cut.x_mm - shaft_mm - 0.6, y - 0.5 * height_mm), Anchor::End),
          std::pair(Vector2d(cut.x_mm - 0.8, outer), Anchor::End), std::pair(Vector2d(cut.x_mm, outer), Anchor::Middle),
          std::pair(Vector2d(cut.x_mm + 0.8, y - 0.5 * height_mm), Anchor::Start)}) {
        Label label{at, height_mm};
        label.text = cut.letter;
        label.anchor = anchor;
        label.layer = Layer::Dimensions;
        places.push_back(label);
    }
    for (const Label& label : places) {
        const Box box = boxOf(label).grown(0.3);
        if (std::none_of(verticals.begin(), verticals.end(),
                         [&](double x) { return x > box.left_mm && x < box.right_mm; }))
            return label;
    }
    return places.front();
}

}  // namespace

std::vector<CutPlace> cutPlaces(const std::vector<CrossSection>& sections, double factor,
                                const std::vector<double>& lines)
{
    std::vector<CutPlace> cuts;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const double from = factor * sections[i].from_z_mm, to = factor * sections[i].to_z_mm, middle = (from + to) / 2;
        double best = middle;
        const auto score = [&](double x) {
            double least = besideOther_mm;
            for (const CutPlace& cut : cuts) least = std::min(least, std::abs(cut.x_mm - x));
            return least + clearanceOf(x, lines);
        };
        for (double off = 0.25; off <= (to - from) / 2; off += 0.25)
            for (const double x : {middle - off, middle + off})
                if (score(x) > score(best) + 1e-9) best = x;
        CutPlace cut{best, letterOf(i), 0};
        while (std::any_of(cuts.begin(), cuts.end(), [&](const CutPlace& other) {
            return other.lane == cut.lane && std::abs(other.x_mm - cut.x_mm) < besideOther_mm;
        }))
            ++cut.lane;
        cuts.push_back(cut);
    }
    return cuts;
}

double cutHeight(const std::vector<CutPlace>& cuts, double height_mm)
{
    int lanes = 0;
    for (const CutPlace& cut : cuts) lanes = std::max(lanes, cut.lane);
    return cutArrowOffset_mm + (2 + laneHeights * lanes) * height_mm;
}

void paintCuts(const std::vector<CutPlace>& cuts, double edge_mm, bool above, const std::vector<double>& verticals,
               DimensionPainter& paint, Drawing& drawing)
{
    const double sign = above ? 1 : -1;
    for (const CutPlace& cut : cuts) {
        const double far = edge_mm + sign * (cutArrowOffset_mm + cut.lane * laneHeights * paint.height_mm());
        drawing.lines.push_back({{cut.x_mm, edge_mm + sign}, {cut.x_mm, far}, Layer::Contour, thick_mm});
        paint.line({cut.x_mm - shaft_mm, far}, {cut.x_mm, far});
        paint.arrow({cut.x_mm, far}, {1, 0});
        drawing.labels.push_back(letterLabel(cut, far, above, verticals, paint.height_mm()));
    }
}

void addSections(const std::vector<CrossSection>& sections, const LayoutStyle& style, Drawing& drawing)
{
    if (sections.empty()) return;
    const bool below = style.sections == SectionPlace::Below;
    const Box view = boxOf(drawing);
    std::vector<Drawing> row;
    double width = 0, top = view.bottom_mm - sectionGap_mm;
    const auto placeRow = [&] {
        double high = 0, low = 0;
        for (const Drawing& one : row) {
            high = std::max(high, boxOf(one).top_mm);
            low = std::min(low, boxOf(one).bottom_mm);
        }
        double x =
            below ? std::max(view.left_mm, (view.left_mm + view.right_mm - width) / 2) : view.right_mm + sectionGap_mm;
        for (Drawing& one : row) {
            const Box box = boxOf(one);
            move(one, {x - box.left_mm, below ? top - high : 0});
            x += box.width_mm() + sectionGap_mm;
            append(drawing, one);
        }
        top -= high - low + sectionGap_mm;
        row.clear();
        width = 0;
    };
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Scale scale = sectionScale(sections[i], style.scale);
        std::string title = letterOf(i) + "-" + letterOf(i);
        if (scale != style.scale) title += " (" + scale.text() + ")";
        Drawing one = sectionDrawing(sections[i], title, scale.factor(), style.height_mm);
        const double needed = boxOf(one).width_mm() + sectionGap_mm;
        if (below && !row.empty() && width + needed > style.room_mm) placeRow();
        width += needed;
        row.push_back(std::move(one));
    }
    placeRow();
}

}  // namespace lathelier::drawing
