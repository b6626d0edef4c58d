#include "engine/features/nominal/row_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/features/nominal/nominal_limits.h"

namespace lathelier::features {
namespace {

double inMillimetres(const std::optional<double>& value_um)
{
    return value_um.value_or(0) / 1000;
}

bool isSeen(const Recognition& recognition, std::size_t end)
{
    return recognition.ends.size() <= end || isClosed(recognition.ends[end]);
}

bool isRelievedFace(const RowChain& chain, std::size_t i)
{
    return i < chain.size() && chain.row(i).kind == RowKind::Cone && chain.length_mm(i) < 0;
}

bool isHollow(const RowChain& chain, std::size_t i)
{
    return i < chain.size() && chain.row(i).kind == RowKind::Arc && chain.isConcave(i);
}

bool isFace(Joint joint)
{
    return joint == Joint::Plane || joint == Joint::Relieved;
}

/// Places of the rows of an undercut whose run-out comes first, its form F by its relieved face, and its width.
std::optional<UndercutRows> rowsBeforeFace(const RowChain& chain, std::size_t first)
{
    UndercutRows found;
    found.first = found.run_out = first;
    found.bottom = first + 1;
    found.arc = found.last = first + 2;
    if (!isHollow(chain, found.arc)) return {};
    const bool has_face_row = isRelievedFace(chain, found.last + 1);
    if (has_face_row) ++found.last;
    if (first == 0 || found.last + 1 >= chain.size() || chain.joint(first) != Joint::Joined) return {};
    const Joint face = chain.joint(found.last + 1);
    if (!isFace(face) && !has_face_row) return {};
    if (!(chain.startHeight_mm(found.last + 1) > chain.endHeight_mm(found.arc))) return {};
    found.measured.width.value_mm = chain.closing_mm(found.last) - chain.start_mm(first);
    if (has_face_row || face == Joint::Relieved) found.measured.form = UndercutForm::F;
    return found;
}

/// The same where the face comes first.
std::optional<UndercutRows> rowsBehindFace(const RowChain& chain, std::size_t first)
{
    UndercutRows found;
    found.first = first;
    found.before_face = false;
    found.arc = isRelievedFace(chain, first) ? first + 1 : first;
    found.bottom = found.arc + 1;
    found.run_out = found.last = found.arc + 2;
    if (!isHollow(chain, found.arc) || first == 0 || found.last + 1 >= chain.size()) return {};
    if (chain.joint(found.last + 1) != Joint::Joined || !isFace(chain.joint(first))) return {};
    if (!(chain.endHeight_mm(first - 1) > chain.startHeight_mm(found.arc))) return {};
    found.measured.width.value_mm = chain.end_mm(found.last) - chain.end_mm(first - 1);
    if (found.arc != first || chain.joint(first) == Joint::Relieved) found.measured.form = UndercutForm::F;
    return found;
}

/// Form, sizes and uncertainties of an undercut whose rows and width are known.
void measure(const RowChain& chain, UndercutRows& found)
{
    const RecognizedRow &cone = chain.row(found.run_out), &bottom = chain.row(found.bottom),
                        &arc = chain.row(found.arc);
    const bool before = found.before_face;
    MeasuredUndercut& measured = found.measured;
    // The circle of form F reaches t2, at least 0.1 mm, beyond the face; where it ends there it is cut off.
    const double face_at = before ? chain.closing_mm(found.last) : chain.end_mm(found.first - 1);
    const double reach = std::abs(chain.piece(found.arc).centre_mm().x() - face_at);
    const bool beyond = std::abs(*arc.arc_radius_mm) - reach > rowPatternLimits.beyond_face_mm;
    if (beyond || !arc.fully_visible) measured.form = UndercutForm::F;
    const double start = chain.startHeight_mm(found.run_out), end = chain.endHeight_mm(found.run_out);
    measured.shaft_mm = std::abs(before ? start : end);
    measured.depth = {std::abs(start - end) / 2,
                      std::hypot(diameterUncertainty_mm(cone), diameterUncertainty_mm(bottom)) / 2};
    const double free = inMillimetres(before ? cone.uncertainty.z_start_um : cone.uncertainty.z_end_um);
    const double face = inMillimetres(before ? arc.uncertainty.z_end_um : arc.uncertainty.z_start_um);
    measured.width.U_mm = std::hypot(free, face);
    measured.radius = {std::abs(*arc.arc_radius_mm), inMillimetres(arc.uncertainty.arc_radius_um)};
}

}  // namespace

RowChain::RowChain(const Recognition& recognition) : rows_(&recognition.segments)
{
    startsAtEnd_ = isSeen(recognition, 0);
    endsAtEnd_ = isSeen(recognition, 1);
    if (!recognition.ends.empty()) endUncertainty_mm_ = recognition.ends.front().uncertainty_mm;
    if (recognition.ends.size() > 1) farEndUncertainty_mm_ = recognition.ends[1].uncertainty_mm;
    findJoints();
}

RowChain::RowChain(const Recognition& recognition, std::size_t bore) : rows_(&recognition.bores[bore]), sign_(-1)
{
    const double length =
        recognition.segments.empty() ? recognition.length_mm.value_or(0) : recognition.segments.back().z_end_mm;
    const RecognizedRow &first = rows_->front(), &last = rows_->back();
    const double to_free = std::min(first.z_start_mm, first.z_end_mm);
    const double to_chuck = length - std::max(last.z_start_mm, last.z_end_mm);
    // Rows run from the mouth inward; a single row belongs to the end that it is nearer to, or that its order of z
    // gives.
    const bool falls =
        size() > 1 ? first.z_start_mm + first.z_end_mm > last.z_start_mm + last.z_end_mm : to_chuck < to_free;
    const bool from_chuck = falls || first.z_start_mm > first.z_end_mm;
    sense_ = from_chuck ? -1 : 1;
    origin_mm_ = from_chuck ? length : 0;
    if (recognition.ends.size() > (from_chuck ? 1U : 0U))
        endUncertainty_mm_ = recognition.ends[from_chuck ? 1 : 0].uncertainty_mm;
    startsAtEnd_ = isSeen(recognition, from_chuck ? 1 : 0);
    endsAtEnd_ = end_mm(size() - 1) > length - rowPatternLimits.through_mm;
    findJoints();
}

void RowChain::findJoints()
{
    joints_.assign(size() + 1, Joint::End);
    for (std::size_t i = 1; i < size(); ++i) {
        const double ahead = start_mm(i) - end_mm(i - 1);
        const double step = std::abs(row(i).start_diameter_mm - row(i - 1).end_diameter_mm);
        joints_[i] = ahead > rowPatternLimits.join_gap_mm        ? Joint::Gap
                     : ahead < -rowPatternLimits.least_relief_mm ? Joint::Relieved
                     : step <= rowPatternLimits.same_diameter_mm ? Joint::Joined
                                                                 : Joint::Plane;
    }
}

bool RowChain::isRoughSeam(std::size_t boundary) const
{
    const auto isRough = [](const RecognizedRow& row) { return row.role == "thread" || row.role == "knurl"; };
    if (joint(boundary) != Joint::Plane) return false;
    const RecognizedRow &before = row(boundary - 1), &after = row(boundary);
    return isRough(before) != isRough(after) &&
           std::abs(before.end_diameter_mm - after.start_diameter_mm) / 2 <= rowPatternLimits.rough_seam_mm;
}

double RowChain::angle_deg(std::size_t i) const
{
    return std::atan2(std::abs(endHeight_mm(i) - startHeight_mm(i)) / 2, std::abs(length_mm(i))) * 180 /
           std::numbers::pi;
}

ContourPiece RowChain::piece(std::size_t i) const
{
    return {{start_mm(i), row(i).start_diameter_mm / 2},
            {end_mm(i), row(i).end_diameter_mm / 2},
            row(i).arc_radius_mm.value_or(0)};
}

double RowChain::boundaryUncertainty_mm(std::size_t boundary) const
{
    double own_mm = 0;
    if (boundary > 0) own_mm = inMillimetres(row(boundary - 1).uncertainty.z_end_um);
    if (own_mm == 0 && boundary < size()) own_mm = inMillimetres(row(boundary).uncertainty.z_start_um);
    if (own_mm == 0 && boundary == size()) own_mm = farEndUncertainty_mm_;
    return std::hypot(own_mm, endUncertainty_mm_);
}

double RowChain::closing_mm(std::size_t i) const
{
    return joint(i + 1) == Joint::Relieved ? start_mm(i + 1) : end_mm(i);
}

double diameterUncertainty_mm(const RecognizedRow& row)
{
    return std::max(inMillimetres(row.uncertainty.start_diameter_um), inMillimetres(row.uncertainty.end_diameter_um));
}

double lengthUncertainty_mm(const RecognizedRow& row)
{
    if (row.uncertainty.length_um) return *row.uncertainty.length_um / 1000;
    return std::hypot(inMillimetres(row.uncertainty.z_start_um), inMillimetres(row.uncertainty.z_end_um));
}

std::optional<UndercutRows> undercutRowsAt(const RowChain& chain, std::size_t first)
{
    auto found = chain.row(first).kind == RowKind::Cone && chain.length_mm(first) > 0 ? rowsBeforeFace(chain, first)
                                                                                      : rowsBehindFace(chain, first);
    if (!found) return {};
    const std::size_t run_out = found->run_out, arc = found->arc;
    const RecognizedRow& cone = chain.row(run_out);
    if (cone.kind != RowKind::Cone || chain.row(found->bottom).kind != RowKind::Cylinder) return {};
    const double falls = chain.startHeight_mm(run_out) - chain.endHeight_mm(run_out);
    const double rises = chain.endHeight_mm(arc) - chain.startHeight_mm(arc);
    if (found->before_face != (falls > 0) || found->before_face != (rises > 0)) return {};
    const double window = rowPatternLimits.run_out_tolerance_deg + cone.uncertainty.angle_deg.value_or(0);
    if (std::abs(chain.angle_deg(run_out) - undercutRunOut_deg) > window) return {};
    measure(chain, *found);
    if (found->measured.depth.value_mm > rowPatternLimits.deepest_undercut_mm ||
        found->measured.width.value_mm > rowPatternLimits.widest_undercut_mm)
        return {};
    return found;
}

std::optional<GrooveRows> grooveRowsAt(const RowChain& chain, std::size_t first)
{
    const RowPatternLimits& limits = rowPatternLimits;
    if (first == 0) return {};
    const auto meets = [&](std::size_t b) { return chain.joint(b) == Joint::Plane || chain.joint(b) == Joint::Joined; };
    const double left = chain.endHeight_mm(first - 1);
    GrooveRows found;
    found.first = first;
    bool rising = false;
    double lowest = left;
    for (std::size_t i = first; i < chain.size() && i < first + limits.most_groove_rows && meets(i); ++i) {
        const RecognizedRow& row = chain.row(i);
        if (!row.role.empty() || chain.length_mm(i) < 0) return {};
        const double start = chain.startHeight_mm(i), end = chain.endHeight_mm(i);
        const double before = chain.endHeight_mm(i - 1);
        // Heights fall to the bottom and rise again, once.
        if (i > first && chain.joint(i) == Joint::Plane) return {};
        if (i == first && start > before + limits.same_end_mm) return {};
        if (end > start + limits.same_end_mm) rising = true;
        if (rising && end < start - limits.same_end_mm) return {};
        if (row.kind == RowKind::Cylinder) {
            if (found.bottom || rising) return {};
            found.bottom = i;
        }
        if (row.kind == RowKind::Cone && chain.angle_deg(i) < limits.least_flank_deg) return {};
        if (row.kind == RowKind::Arc && !chain.isConcave(i)) return {};
        lowest = std::min({lowest, start, end});
        if (i + 1 >= chain.size() || !meets(i + 1)) return {};
        const double right = chain.startHeight_mm(i + 1), rim = std::min(left, right);
        const double width = chain.end_mm(i) - chain.start_mm(first);
        if (width > limits.widest_groove_mm) return {};
        const bool closed =
            chain.joint(i + 1) == Joint::Plane ? right > end : std::abs(end - right) <= limits.same_end_mm;
        const bool next_rises = i + 1 < chain.size() && chain.joint(i + 1) == Joint::Joined &&
                                chain.endHeight_mm(i + 1) > right + limits.same_end_mm;
        if (!closed || rim - lowest < limits.shallowest_groove_mm || next_rises) continue;
        if (width < limits.narrowest_groove_mm || width > limits.widest_groove_share * std::abs(rim)) return {};
        found.last = i;
        found.between_planes = chain.joint(first) == Joint::Plane && chain.joint(i + 1) == Joint::Plane;
        // A flank on one side and a plane on the other is a step with a fillet or a run-out, not a groove.
        if (!found.between_planes && (chain.joint(first) == Joint::Plane || chain.joint(i + 1) == Joint::Plane))
            return {};
        found.width = {width, std::hypot(inMillimetres(chain.row(first).uncertainty.z_start_um),
                                         inMillimetres(row.uncertainty.z_end_um))};
        if (const auto length_um = row.uncertainty.length_um; length_um && first == i)
            found.width.U_mm = *length_um / 1000;
        const std::size_t shaft = left < right ? first - 1 : i + 1;
        found.shaft = {std::abs(rim), diameterUncertainty_mm(chain.row(shaft))};
        return found;
    }
    return {};
}

}  // namespace lathelier::features
