#include "engine/drawing/layout.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/drawing/dimension_lines.h"
#include "engine/drawing/lanes.h"
#include "engine/drawing/leaders.h"
#include "engine/drawing/marks/cutting_planes.h"
#include "engine/drawing/marks/view_marks.h"
#include "engine/drawing/view.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double firstLane_mm = 10;       // from the view to the first dimension line
constexpr double axisOverhang_mm = 4;     // of the axis
constexpr double leaderSpace_mm = 2;      // least distance of leaders
constexpr double edgeClearance_mm = 1.2;  // between a dimension line and an edge beside it
constexpr double leaderBend_mm = 3;       // leaders are vertical from so far above the view; also beside keyways

class Layout {
public:
    Layout(const Shaft& shaft, const Features& features, const LayoutStyle& style)
        : features_(features),
          factor_(style.scale.factor()),
          bored_(!shaft.bores.empty()),
          paint_(drawing_, style.height_mm)
    {
        const double factor = factor_;
        const LengthStyle lengths = style.lengths;
        drawing_ = viewOf(shaft, factor);
        view_ = boxOf(drawing_);
        occupied_ = markBoxes(shaft, factor);
        for (const BoreDimension& bore : features.bores)
            for (const double z : {bore.size.from_z_mm, bore.size.to_z_mm}) edges_.push_back(factor * z);
        for (const LengthDimension& length : features.bore_lengths)
            for (const double z : {length.from_z_mm, length.to_z_mm}) edges_.push_back(factor * z);
        planCuts();
        for (const DiameterDimension& diameter : features.diameters) addDiameter(diameter);
        if (lengths == LengthStyle::Running)
            addRunningLengths();
        else
            addLengths(lengths == LengthStyle::Chain ? chainLanes() : parallelLanes());
        for (const BoreDimension& bore : features.bores) sortBore(bore);
        addBores(freeBores_, true);
        addBores(chuckBores_, false);
        for (const Callout& callout : features.callouts)
            if (callout.mouth == Mouth::None || !placeBeside(callout))
                leaders_.push_back({factor * callout.at_mm, callout.label, std::nullopt});
        addTop();
        addAxis();
        addSections(features.sections, style, drawing_);
    }

    Drawing take() { return std::move(drawing_); }

private:
    struct Leader {
        Vector2d at_mm;
        DimensionText label;
        std::optional<double> lower_y_mm;  ///< a ⌀: lower end of its dimension line
    };

    bool isFree(const Box& box) const
    {
        return std::none_of(occupied_.begin(), occupied_.end(), [&](const Box& other) { return box.overlaps(other); });
    }

    bool isNearEdge(double x) const
    {
        return std::any_of(edges_.begin(), edges_.end(),
                           [&](double edge) { return std::abs(edge - x) < edgeClearance_mm; });
    }

    double pitch() const { return 2 * paint_.height_mm(); }

    void addDiameter(const DiameterDimension& diameter)
    {
        const double radius = factor_ * diameter.diameter_mm / 2;
        const double from = factor_ * diameter.from_z_mm, to = factor_ * diameter.to_z_mm;
        if (!placeInside(diameter, radius, from, to)) {
            const double x = clearPlace(from, to, radius);
            const double axis = factor_ * diameter.offset_mm;
            leaders_.push_back(
                {{x, axis + radius}, diameter.label, bored_ ? std::nullopt : std::optional(axis - radius)});
        }
    }

    /// Place nearest to the middle where a dimension line across the view crosses nothing; the middle where there is
    /// none.
    double clearPlace(double from, double to, double radius) const
    {
        const double middle = (from + to) / 2, reach = (to - from) / 2 - 1;
        for (double off = 0; off <= reach; off += 0.5)
            for (const double x : {middle + off, middle - off})
                if (!isNearEdge(x) && isFree({x - leaderBend_mm, -radius, x + leaderBend_mm, bored_ ? 0 : radius}))
                    return x;
        return middle;
    }

    /// On a line across the view where there is room; the place nearest to the row's middle.
    bool placeInside(const DiameterDimension& diameter, double radius, double from, double to)
    {
        const double band = paint_.band_mm(), width = paint_.widthOf(diameter.label), margin = 1;
        const double clear = factor_ * diameter.clear_diameter_mm, room = (bored_ ? clear / 2 : clear) - 2;
        // The text of an eccentric would lie on its axis.
        if (width > room || to - from < band + 2 * margin || diameter.offset_mm != 0) return false;
        const double middle = (from + to + band) / 2, reach = (to - from - band) / 2 - margin;
        for (double off = 0; off <= reach + 1e-9; off += 1)
            for (const double x : {middle + off, middle - off}) {
                const Box box{x - band, -radius, x + 0.5, bored_ ? 0 : radius};
                if (!isFree(box) || isNearEdge(x)) continue;
                addInside(diameter.label, x, radius, factor_ * diameter.offset_mm);
                occupied_.push_back(box);
                return true;
            }
        return false;
    }

    void addInside(const DimensionText& label, double x, double radius, double axis)
    {
        if (!bored_) {
            paint_.vertical(x, axis - radius, axis + radius, label);
            const Box text = boxOf(drawing_.labels.back());
            if (text.bottom_mm < 0 && text.top_mm > 0) gaps_.emplace_back(text.left_mm - 0.3, text.right_mm + 0.3);
            return;
        }
        paint_.line({x, -radius}, {x, 3});
        paint_.arrow({x, -radius}, {0, -1});
        paint_.text({x - paint_.gap_mm(), -radius / 2}, label, Anchor::Middle, 90);
    }

    /// Height of the letters of cutting planes between the view and the first lane.
    double cutSpace() const { return cuts_.empty() ? 0 : cutHeight(cuts_, paint_.height_mm()) - cutArrowOffset_mm; }

    /// Where the cutting planes cross the view, clear of edges and extension lines where they can be.
    void planCuts()
    {
        std::vector<double> lines = edges_;
        for (const LengthDimension& length : features_.lengths) lines.push_back(factor_ * length.to_z_mm);
        lines.push_back(0);
        // Leaders stand about these places; an arrow is as long as two heads.
        std::vector<double> leaders;
        for (const Callout& callout : features_.callouts) leaders.push_back(factor_ * callout.at_mm.x());
        for (const DiameterDimension& diameter : features_.diameters)
            leaders.push_back(factor_ * (diameter.from_z_mm + diameter.to_z_mm) / 2);
        for (const double x : leaders)
            for (const double along : {0.0, arrow_mm, 2 * arrow_mm}) lines.push_back(x + along);
        cuts_ = cutPlaces(features_.sections, factor_, lines);
    }

    /// Lanes of the lengths, 0 nearest to the view.
    void addLengths(const std::vector<int>& lanes)
    {
        const double first = view_.bottom_mm - firstLane_mm - cutSpace();
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            const LengthDimension& length = features_.lengths[i];
            paint_.horizontal(factor_ * length.from_z_mm, factor_ * length.to_z_mm, first - lanes[i] * pitch(),
                              -factor_ * length.from_radius_mm, -factor_ * length.to_radius_mm, length.label);
        }
    }

    std::vector<int> parallelLanes() const
    {
        std::vector<int> lanes(features_.lengths.size());
        for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = static_cast<int>(i);
        return lanes;
    }

    std::vector<int> chainLanes() const
    {
        std::vector<LaneSpan> spans;
        for (const LengthDimension& length : features_.lengths) {
            LaneSpan span{factor_ * length.from_z_mm, factor_ * length.to_z_mm, 0, 0};
            std::tie(span.left_mm, span.right_mm) = paint_.extentOf(span.from_mm, span.to_mm, length.label);
            spans.push_back(span);
        }
        return lanesOf(spans);
    }

    void addRunningLengths()
    {
        const double y = view_.bottom_mm - firstLane_mm - cutSpace();
        std::vector<double> places;
        for (const LengthDimension& length : features_.lengths) places.push_back(factor_ * length.to_z_mm);
        const std::vector<double> x = spread(places, paint_.band_mm() + 0.5);
        const double first_y = -factor_ * features_.lengths.front().from_radius_mm;
        paint_.line({0, first_y - 1}, {0, y - 1});
        drawing_.arcs.push_back({{0, y}, 1, 0, 360, Layer::Dimensions, thin_mm});
        paint_.line({1, y}, {places.back(), y});
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Vector2d knee(x[i], y - 5);
            paint_.line({places[i], -factor_ * features_.lengths[i].to_radius_mm - 1}, {places[i], y - 1});
            paint_.line({places[i], y - 1}, knee);
            paint_.arrow({places[i], y}, {1, 0});
            paint_.text({x[i] + 0.42 * paint_.height_mm(), knee.y() - 1}, features_.lengths[i].label, Anchor::End, 90);
        }
    }

    void sortBore(const BoreDimension& bore)
    {
        const double middle = (bore.size.from_z_mm + bore.size.to_z_mm) / 2 * factor_;
        const bool nearer_free = middle - view_.left_mm <= view_.right_mm - middle;
        if (bore.open_free && (nearer_free || !bore.open_chuck))
            freeBores_.push_back(bore.size);
        else if (bore.open_chuck)
            chuckBores_.push_back(bore.size);
        else
            leaders_.push_back({{middle, factor_ * bore.size.diameter_mm / 2}, bore.size.label, std::nullopt});
    }

    /// Beside the view, small ones nearest to it; half dimension lines, since the section shows half.
    void addBores(std::vector<DiameterDimension>& bores, bool left)
    {
        std::stable_sort(bores.begin(), bores.end(), [](const DiameterDimension& a, const DiameterDimension& b) {
            return a.diameter_mm < b.diameter_mm;
        });
        const double sense = left ? -1 : 1, step = paint_.band_mm() + 2;
        double x = left ? view_.left_mm - step - 1 : view_.right_mm + axisOverhang_mm + step;
        for (const DiameterDimension& bore : bores) {
            const double radius = factor_ * bore.diameter_mm / 2, width = paint_.widthOf(bore.label);
            const double low = std::min(-axisOverhang_mm, radius - arrow_mm - 2 - width);
            while (overlapsLabel({x - paint_.band_mm(), low, x + 0.5, radius})) x += sense * step;
            paint_.line({factor_ * (left ? bore.from_z_mm : bore.to_z_mm), radius}, {x + sense * 1.5, radius});
            paint_.line({x, radius}, {x, low});
            paint_.arrow({x, radius}, {0, 1});
            paint_.text({x - paint_.gap_mm(), radius - arrow_mm - 1}, bore.label, Anchor::End, 90);
            x += sense * step;
        }
    }

    /// Beside the mouth of a bore, above the dimensions of bores and below the view's top.
    bool placeBeside(const Callout& callout)
    {
        const bool left = callout.mouth == Mouth::Free;
        const double sense = left ? -1 : 1, width = paint_.widthOf(callout.label);
        const Vector2d at = factor_ * callout.at_mm;
        const Vector2d knee((left ? view_.left_mm : view_.right_mm) + sense * 4, at.y() + 6);
        Label label{knee + Vector2d(sense * 0.5, paint_.gap_mm()), paint_.height_mm()};
        label.text = callout.label.text;
        label.anchor = left ? Anchor::End : Anchor::Start;
        const Box box = boxOf(label);
        if (box.top_mm > view_.top_mm + leaderBend_mm || overlapsLabel(box)) return false;
        paint_.line(at, knee);
        paint_.arrow(at, at - knee);
        paint_.line(knee, knee + Vector2d(sense * (width + 1), 0));
        paint_.text(label.at_mm, callout.label, label.anchor);
        return true;
    }

    bool overlapsLabel(const Box& box) const
    {
        return std::any_of(drawing_.labels.begin(), drawing_.labels.end(),
                           [&](const Label& label) { return boxOf(label).overlaps(box); });
    }

    /// Depths of bores, then the texts of leaders above them.
    void addTop()
    {
        std::vector<LeaderText> texts;
        for (const Leader& leader : leaders_) texts.push_back({leader.at_mm.x(), paint_.widthOf(leader.label) + 1});
        for (const CutPlace& cut : cuts_) texts.push_back({cut.x_mm, 0});
        places_ = placeLeaders(texts, leaderSpace_mm);
        places_.resize(leaders_.size());
        double y = view_.top_mm + firstLane_mm + cutSpace();
        for (const LengthDimension& length : features_.bore_lengths) {
            addBoreLength(length, y);
            y += pitch();
        }
        const double bend = view_.top_mm + leaderBend_mm;
        double first =
            features_.bore_lengths.empty() ? view_.top_mm + leaderBend_mm + 4 : y - pitch() + 2 * leaderBend_mm;
        first = std::max(first, addCuts());
        for (std::size_t i = 0; i < leaders_.size(); ++i) addLeader(leaders_[i], places_[i], bend, first);
    }

    void addBoreLength(const LengthDimension& length, double y)
    {
        const double from = factor_ * length.from_z_mm, to = factor_ * length.to_z_mm;
        const double half = paint_.widthOf(length.label) / 2, middle = (from + to) / 2;
        const double reach = std::abs(to - from) / 2 - half - 0.5;
        const auto crossed = [&](double x) {
            return std::any_of(places_.begin(), places_.end(),
                               [&](const LeaderPlace& place) { return std::abs(place.x_mm - x) < half + 0.5; });
        };
        std::optional<double> text_x;
        for (double off = 0; off <= reach && !text_x; off += 0.5)
            for (const double x : {middle - off, middle + off})
                if (!crossed(x)) text_x = x;
        paint_.horizontal(from, to, y, factor_ * length.from_radius_mm, factor_ * length.to_radius_mm, length.label,
                          text_x.value_or(DimensionPainter::outside));
    }

    void addLeader(const Leader& leader, const LeaderPlace& place, double bend, double first)
    {
        const double y = first + pitch() * place.lane, sense = place.to_left ? -1 : 1;
        const Vector2d knee(place.x_mm, bend), shelf(place.x_mm, y);
        const double width = paint_.widthOf(leader.label);
        if (leader.lower_y_mm) {
            const bool room = leader.at_mm.y() - *leader.lower_y_mm > 3 * arrow_mm;
            const Vector2d low(leader.at_mm.x(), *leader.lower_y_mm), up(0, 1);
            paint_.line(room ? low : Vector2d(low - 4 * up), leader.at_mm);
            paint_.arrow(low, room ? Vector2d(-up) : up);
            paint_.arrow(leader.at_mm, room ? up : Vector2d(-up));
            const Vector2d above(leader.at_mm.x(), leader.at_mm.y() + (room ? 0 : arrow_mm + 1));
            paint_.line(leader.at_mm, above);
            paint_.line(above, knee);
        } else {
            paint_.line(leader.at_mm, knee);
            paint_.arrow(leader.at_mm, leader.at_mm - knee);
        }
        paint_.line(knee, shelf);
        paint_.line(shelf, {place.x_mm + sense * (width + 1), y});
        paint_.text({place.x_mm + sense * 0.5, y + paint_.gap_mm()}, leader.label,
                    place.to_left ? Anchor::End : Anchor::Start);
    }

    /// Their lines, arrows and letters. The height up to which leaders are to keep clear.
    double addCuts()
    {
        if (cuts_.empty()) return 0;
        std::vector<double> above, below;
        for (const LeaderPlace& place : places_) above.push_back(place.x_mm);
        for (const LengthDimension& length : features_.bore_lengths)
            for (const double z : {length.from_z_mm, length.to_z_mm}) above.push_back(factor_ * z);
        for (const LengthDimension& length : features_.lengths)
            for (const double z : {length.from_z_mm, length.to_z_mm}) below.push_back(factor_ * z);
        paintCuts(cuts_, view_.top_mm, true, above, paint_, drawing_);
        paintCuts(cuts_, view_.bottom_mm, false, below, paint_, drawing_);
        return view_.top_mm + cutHeight(cuts_, paint_.height_mm());
    }

    void addAxis()
    {
        std::sort(gaps_.begin(), gaps_.end());
        double start = view_.left_mm - axisOverhang_mm;
        const auto add = [&](double end) {
            if (end - start > 0.5)
                drawing_.lines.push_back({{start, 0}, {end, 0}, Layer::Axis, thin_mm, LineType::DashDot});
        };
        for (const auto& [from, to] : gaps_) {
            add(from);
            start = std::max(start, to);
        }
        add(view_.right_mm + axisOverhang_mm);
    }

    const Features& features_;
    double factor_;
    bool bored_;
    Drawing drawing_;
    DimensionPainter paint_;
    Box view_;
    std::vector<Box> occupied_;  // inside the view
    std::vector<CutPlace> cuts_;
    std::vector<double> edges_;                    // x of upright lines of bores
    std::vector<std::pair<double, double>> gaps_;  // of the axis
    std::vector<Leader> leaders_;
    std::vector<LeaderPlace> places_;  // of leaders_
    std::vector<DiameterDimension> freeBores_, chuckBores_;
};

}  // namespace

Drawing layOut(const Shaft& shaft, const Features& features, const LayoutStyle& style)
{
    return Layout(shaft, features, style).take();
}

}  // namespace lathelier::drawing
