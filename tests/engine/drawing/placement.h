// Checks of the placement in a drawing.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/drawing/drawing.h"

namespace lathelier::drawing {

/// Pairs of texts whose boxes overlap.
inline std::vector<std::string> overlappingTexts(const Drawing& drawing)
{
    std::vector<std::string> found;
    for (std::size_t i = 0; i < drawing.labels.size(); ++i)
        for (std::size_t j = i + 1; j < drawing.labels.size(); ++j)
            if (boxOf(drawing.labels[i]).overlaps(boxOf(drawing.labels[j])))
                found.push_back(drawing.labels[i].text + " / " + drawing.labels[j].text);
    return found;
}

/// Does the segment enter the box? (Liang and Barsky)
inline bool enters(const Line& line, const Box& box)
{
    double first = 0, last = 1;
    const Eigen::Vector2d run = line.to_mm - line.from_mm;
    const auto cut = [&](double p, double q) {
        if (p == 0) return q > 0;
        const double t = q / p;
        if (p < 0)
            first = std::max(first, t);
        else
            last = std::min(last, t);
        return first < last;
    };
    return cut(-run.x(), line.from_mm.x() - box.left_mm) && cut(run.x(), box.right_mm - line.from_mm.x()) &&
           cut(-run.y(), line.from_mm.y() - box.bottom_mm) && cut(run.y(), box.top_mm - line.from_mm.y());
}

/// Texts whose capitals a line crosses.
inline std::vector<std::string> crossedTexts(const Drawing& drawing)
{
    std::vector<std::string> found;
    for (const Label& label : drawing.labels) {
        const double angle = label.angle_deg * std::acos(-1.0) / 180;
        const auto seen = [&](const Eigen::Vector2d& point) -> Eigen::Vector2d {  // as the writing runs
            const Eigen::Vector2d off = point - label.at_mm;
            return {off.x() * std::cos(angle) + off.y() * std::sin(angle),
                    off.y() * std::cos(angle) - off.x() * std::sin(angle)};
        };
        Label level = label;
        level.at_mm = {0, 0};
        level.angle_deg = 0;
        Box box = boxOf(level).grown(-0.1);
        box.bottom_mm += 0.32 * label.height_mm;
        box.top_mm -= 0.15 * label.height_mm;
        if (std::any_of(drawing.lines.begin(), drawing.lines.end(), [&](const Line& line) {
                return line.layer != Layer::Frame && enters({seen(line.from_mm), seen(line.to_mm)}, box);
            }))
            found.push_back(label.text);
    }
    return found;
}

}  // namespace lathelier::drawing
