// Modal changes by a block: units, feeds, speeds, nose radius compensation.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {
namespace {

constexpr double foot_m = 0.3048;

}  // namespace

void Interpreter::takeSpindle(BlockWords& words)
{
    const bool wasCss = modal_.is_css;
    const bool isLimit = words.hasG(G::SpeedLimit);
    if (words.hasG(G::CssOn)) {
        modal_.is_css = true;
        if (control_.css_is_per_revolution) {
            modal_.per_revolution = true;
            statedFeedMode_ = true;
        }
    }
    if (words.hasG(G::CssOff)) {
        modal_.is_css = false;
        if (control_.css_limit != 0) modal_.limit_rpm = notANumber;
        if (wasCss && !words.has('S')) {  // the current spindle speed is kept
            const double diameter_m = isKnown(modal_.at.x_mm) ? 2e-3 * std::abs(modal_.at.x_mm) : notANumber;
            double rpm = modal_.speed / (std::acos(-1.0) * diameter_m);
            if (isKnown(modal_.limit_rpm) && !(rpm < modal_.limit_rpm)) rpm = modal_.limit_rpm;
            modal_.speed = std::isfinite(rpm) ? rpm : notANumber;
        }
    }
    if (words.hasG(G::CssOn) && !wasCss && !words.has('S')) modal_.speed = notANumber;
    if (words.hasG(G::CssOn) && control_.css_limit != 0)
        modal_.limit_rpm = plain(words, control_.css_limit, notANumber);
    if (!words.has('S') || isOfDwell(words, 'S')) return;
    const double value = plain(words, 'S');
    if (isLimit)
        modal_.limit_rpm = value;
    else
        modal_.speed = modal_.is_css && modal_.inch_feed ? value * foot_m : value;
}

void Interpreter::takeModes(BlockWords& words)
{
    const bool wasPerRevolution = modal_.per_revolution;
    for (int i = 0; i < words.g_count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Word* const word = words.g_word[at];
        switch (words.g[at]) {
            case G::Inch:
                statedUnit_ = true;
                modal_.is_inch = true;
                modal_.inch_feed = false;
                break;
            case G::InchAll:
                statedUnit_ = true;
                modal_.is_inch = modal_.inch_feed = true;
                break;
            case G::Metric:
                statedUnit_ = true;
                modal_.is_inch = modal_.inch_feed = false;
                break;
            case G::PlaneZX: modal_.plane_by = nullptr; break;
            case G::PlaneOther:
                warn(notes::ncWordNotModelled, word, {{"found", shownWord(*word)}}, GapEffect::None);
                notUnderstood(word);
                modal_.plane_by = word;
                break;
            case G::PerMinute:
                modal_.per_revolution = false;
                statedFeedMode_ = true;
                break;
            case G::PerRevolution:
                modal_.per_revolution = true;
                statedFeedMode_ = true;
                break;
            case G::InverseTime:
                warn(notes::ncWordNotModelled, word, {{"found", shownWord(*word)}}, GapEffect::Measures);
                notUnderstood(word);
                break;
            case G::Absolute: modal_.is_incremental = false; break;
            case G::Incremental: modal_.is_incremental = true; break;
            case G::ArcAbsolute: modal_.arc_is_absolute = true; break;
            case G::ArcIncremental: modal_.arc_is_absolute = false; break;
            case G::Diameter:
            case G::Radius:
                modal_.is_diameter = words.g[at] == G::Diameter;
                statedDiameter_ = true;
                break;
            case G::CycleOff: modal_.motion = G::Unknown; break;
            case G::NoseOff: modal_.side = NoseSide::Off; break;
            case G::NoseLeft:
            case G::NoseRight:
                modal_.side = words.g[at] == G::NoseLeft ? NoseSide::Left : NoseSide::Right;
                modal_.nose_radius_mm = notANumber;
                if (words.has('D')) modal_.offset = static_cast<int>(plain(words, 'D'));
                break;
            case G::NoseLeftByWords:
            case G::NoseRightByWords: {
                modal_.side = words.g[at] == G::NoseLeftByWords ? NoseSide::Left : NoseSide::Right;
                modal_.nose_radius_mm = plain(words, 'D') / 2 * (modal_.is_inch ? mm_per_inch : 1);
                modal_.nose_tip = tipOfOrientation[static_cast<std::size_t>(std::clamp(plain(words, 'L'), 0.0, 9.0))];
                break;
            }
            case G::WorkOffset:
            case G::WorkOffsetNamed:
                changeOffset(words.g10[at], word);
                if (words.has('P')) plain(words, 'P');
                break;
            default: break;
        }
    }
    if (words.has('F') && !isOfDwell(words, 'F')) {
        modal_.feed = plain(words, 'F') * (modal_.inch_feed ? mm_per_inch : 1);
        modal_.feed_is_stale = false;
        modal_.thread_lead_mm = notANumber;
    } else if (wasPerRevolution != modal_.per_revolution && isKnown(modal_.feed)) {
        if (control_.feed_ends_with_its_kind)
            modal_.feed = notANumber;
        else
            modal_.feed_is_stale = true;
    }
    if (words.has('T')) {
        const double number = plain(words, 'T');
        const bool isLong = control_.tool_holds_offset && number >= 100;
        modal_.tool = static_cast<int>(std::clamp(isLong ? std::floor(number / 100) : number, 0.0, 1e6));
        modal_.offset = isLong ? static_cast<int>(std::fmod(number, 100)) : modal_.tool;
        if (modal_.offset == 0) modal_.offset = modal_.tool;
    }
}

}  // namespace lathelier::gcode
