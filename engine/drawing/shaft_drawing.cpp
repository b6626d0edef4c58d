#include "engine/drawing/shaft_drawing.h"

#include <algorithm>
#include <utility>

#include "engine/drawing/difference_table.h"
#include "engine/drawing/features.h"
#include "engine/drawing/layout.h"
#include "engine/drawing/marks/mark_geometry.h"
#include "engine/drawing/rows.h"
#include "engine/drawing/title_block.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::drawing {
namespace {

constexpr double frameMargin_mm = 4;      // between the frame and what is drawn
constexpr double readableSize_mm = 60;    // least larger size of the part on paper, if possible
constexpr double generousSize_mm = 90;    // larger size of the part on paper that suffices for the smaller sheet
constexpr double smallestA4Factor = 0.5;  // the smallest scale for which the smaller sheet is taken

/// One combination to try.
struct Attempt {
    Sheet sheet = Sheet::A4Landscape;
    double height_mm = 3.5;
    double least_size_mm = 0;  ///< of the part on paper
    double least_factor = 0;
    LengthStyle lengths = LengthStyle::Parallel;
};

std::vector<Attempt> attemptsFor(const std::optional<Sheet>& sheet)
{
    std::vector<Attempt> attempts;
    if (!sheet)
        for (const Sheet small : {Sheet::A4Landscape, Sheet::A4Portrait})
            attempts.push_back({small, 3.5, generousSize_mm, smallestA4Factor});
    const Sheet last = sheet.value_or(Sheet::A3Landscape);
    for (const LengthStyle lengths : {LengthStyle::Parallel, LengthStyle::Running})
        for (const double height : {3.5, 2.5}) attempts.push_back({last, height, readableSize_mm, 0, lengths});
    for (const double least : {readableSize_mm / 2, 0.0})
        for (const LengthStyle lengths : {LengthStyle::Parallel, LengthStyle::Running})
            attempts.push_back({last, 2.5, least, 0, lengths});
    return attempts;
}

class Composer {
public:
    Composer(const Shaft& shaft, const DrawingOptions& options)
        : shaft_(withSettledMarks(withStatedBores(shaft))),
          options_(options),
          block_mm_(titleBlockHeight_mm(shaft, options))
    {
        double largest = shaft.length_mm();
        for (const ShaftSegment& row : shaft.segments)
            largest = std::max({largest, row.start_diameter_mm, row.end_diameter_mm});
        const std::vector<Attempt> attempts = attemptsFor(options.sheet);
        drawing_.sheet = attempts.back().sheet;
        drawing_.title = options.name.empty() ? shaft.name : options.name;
        if (!shaft.segments.empty()) {
            const Features features = featuresOf(shaft_, options);
            chain_ = options.lengths_from == LengthsFrom::Previous;
            if (chain_) {
                DrawingOptions from_end = options;
                from_end.lengths_from = LengthsFrom::Datum;
                running_ = featuresOf(shaft_, from_end);
            }
            bool done = false;
            for (std::size_t i = 0; i < attempts.size() && !done; ++i) done = take(attempts[i], features, largest);
            if (!done) {
                drawing_.complete = false;
                Features bare;
                bare.lengths.push_back(features.lengths.back());
                bare.differences = features.differences;
                take(attempts.back(), bare, largest);
                const Box frame = frameBox(drawing_.sheet);
                Label remark{{frame.left_mm + frameMargin_mm, frame.top_mm - frameMargin_mm - 2.5}, 2.5};
                remark.text = translated(
                    LT_TEXT("Engine", "INCOMPLETE: the sheet is too small for the dimensions and sections"), options);
                drawing_.labels.push_back(remark);
            }
        }
        append(drawing_, titleBlock(shaft_, options, drawing_.sheet, drawing_.scale));
    }

    Drawing take() { return std::move(drawing_); }

private:
    bool take(const Attempt& attempt, const Features& features, double largest_mm)
    {
        const bool running = attempt.lengths == LengthStyle::Running;
        const Features& used = running && chain_ && drawing_.complete ? running_ : features;
        Drawing table = differenceTable(used.differences, options_, attempt.sheet, block_mm_);
        Box room = frameBox(attempt.sheet).grown(-frameMargin_mm);
        room.bottom_mm = std::max(room.bottom_mm + block_mm_, boxOf(table).top_mm + frameMargin_mm);
        for (const Scale& scale : scales()) {
            const double factor = scale.factor();
            if (largest_mm * factor > room.width_mm()) continue;
            const bool too_small = scale != scales().front() && largest_mm * factor < attempt.least_size_mm;
            if (too_small || factor < attempt.least_factor) return false;
            LayoutStyle style{scale, attempt.height_mm, attempt.lengths, SectionPlace::Right, room.width_mm()};
            if (chain_ && !running) style.lengths = LengthStyle::Chain;
            for (const SectionPlace place : {SectionPlace::Right, SectionPlace::Below}) {
                if (place == SectionPlace::Below && used.sections.empty()) break;
                style.sections = place;
                Drawing content = layOut(shaft_, used, style);
                const Box box = boxOf(content);
                if (box.width_mm() > room.width_mm() || box.height_mm() > room.height_mm()) continue;
                move(content, {(room.left_mm + room.right_mm - box.left_mm - box.right_mm) / 2,
                               (room.bottom_mm + room.top_mm - box.bottom_mm - box.top_mm) / 2});
                drawing_.sheet = attempt.sheet;
                drawing_.scale = scale;
                append(drawing_, content);
                append(drawing_, table);
                drawing_.origin_mm = content.origin_mm;
                return true;
            }
        }
        return false;
    }

    Shaft shaft_;
    const DrawingOptions& options_;
    double block_mm_;
    bool chain_ = false;
    Features running_;  // of a chain: with its lengths from the free end
    Drawing drawing_;
};

}  // namespace

Drawing drawShaft(const Shaft& shaft, const DrawingOptions& options)
{
    return Composer(shaft, options).take();
}

bool hasMeasured(const Shaft& shaft, const DrawingOptions& options)
{
    const auto isMeasured = [](const auto& row) { return row.measured.has_value(); };
    return options.measured || !shaft.recovered.scan.empty() ||
           std::any_of(shaft.segments.begin(), shaft.segments.end(), isMeasured) ||
           std::any_of(shaft.marks.begin(), shaft.marks.end(),
                       [](const ShaftMark& mark) { return mark.uncertainty_mm.has_value(); }) ||
           std::any_of(shaft.bores.begin(), shaft.bores.end(), [&](const ShaftBore& bore) {
               return std::any_of(bore.segments.begin(), bore.segments.end(), isMeasured);
           });
}

std::optional<double> massInKilograms(const Shaft& shaft)
{
    if (!shaft.material) return std::nullopt;
    return volume_mm3(shaft) * shaft.material->density_kg_m3 * 1e-9;
}

}  // namespace lathelier::drawing
