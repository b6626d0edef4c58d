#include "app/cli/shaft_outputs.h"

#include <algorithm>

#include "engine/core/shaft_codes.h"
#include "engine/core/shaft_contour.h"
#include "engine/core/shaft_rules.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"

namespace lathelier::cli {
namespace {

constexpr const char* shaftOption = "--shaft";
constexpr const char* stockOption = "--stock";

/// The shaft without the last `chucked_mm`.
Shaft withoutChucked(const Shaft& shaft, double chucked_mm)
{
    Shaft cut = beamView(shaft);
    double left = chucked_mm;
    while (left > 0 && !cut.segments.empty()) {
        ShaftSegment& last = cut.segments.back();
        if (last.length_mm <= left) {
            left -= last.length_mm;
            cut.segments.pop_back();
            continue;
        }
        const ContourPiece piece{{0, last.start_diameter_mm / 2},
                                 {last.length_mm, last.end_diameter_mm / 2},
                                 last.arc_radius_mm.value_or(0)};
        last.end_diameter_mm = 2 * piece.radiusAt_mm(last.length_mm - left);
        last.length_mm -= left;
        left = 0;
    }
    return cut;
}

}  // namespace

std::vector<OutputOption> shaftOutputs()
{
    return {{shaftOption, "Write the shaft as FILE.json."},
            {stockOption, "Write the contour as a stock file FILE.txt."}};
}

void writeShaftOutputs(const Request& request, const ShaftToWrite& asked, const Progress& progress, Answer& answer)
{
    const auto wanted = [&](const char* option) -> const std::string* {
        const auto found = request.outputs.find(option);
        return found == request.outputs.end() ? nullptr : &found->second;
    };
    if (const std::string* path = wanted(shaftOption)) io::writeFile(*path, io::shaftText(asked.shaft));
    const bool others = std::any_of(request.outputs.begin(), request.outputs.end(),
                                    [](const auto& output) { return output.first != shaftOption; });
    if (!others) return;
    if (!asked.complete) throw Error(errors::shaftIncomplete, {{"reason", asked.missing}});
    const Notes remarks = checkShaft(asked.shaft);
    answer.notes.insert(answer.notes.end(), remarks.begin(), remarks.end());
    progress.check();
    if (const std::string* path = wanted(stockOption))
        io::writeFile(*path, io::stockText(withoutChucked(asked.shaft, asked.chucked_mm)));
}

}  // namespace lathelier::cli
