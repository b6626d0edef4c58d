// The rows of one contour, as needed for roles and nominal sizes: u runs along the rows from 0 (the free end; of a
// bore its mouth), heights grow out of the material, with the kind of joint between neighbours.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/features/nominal/nominal.h"
#include "engine/features/recognition.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::features {

/// How a row meets the one before it.
enum class Joint {
    End,      ///< no row there: the end of the contour
    Joined,   ///< in one point
    Plane,    ///< at one u: a shoulder
    Gap,      ///< no data between
    Relieved  ///< the next row starts before this one ends: the face is undercut
};

/// One contour. Precondition: it has rows, and they outlive the chain.
class RowChain {
public:
    /// The outside.
    explicit RowChain(const Recognition& recognition);
    /// Bore number `bore`: its rows run from its mouth inward, so that z falls along one from the chuck.
    RowChain(const Recognition& recognition, std::size_t bore);

    std::size_t size() const { return rows_->size(); }
    const RecognizedRow& row(std::size_t i) const { return (*rows_)[i]; }
    Joint joint(std::size_t boundary) const { return joints_[boundary]; }  ///< before row `boundary`; size(): after all
    /// Does the row continue here in one with role "thread" or "knurl"? A step up to 0.1 mm counts as none, since the
    /// diameter of a crest is less certain.
    bool isRoughSeam(std::size_t boundary) const;
    double start_mm(std::size_t i) const { return sense_ * (row(i).z_start_mm - origin_mm_); }
    double end_mm(std::size_t i) const { return sense_ * (row(i).z_end_mm - origin_mm_); }
    double length_mm(std::size_t i) const { return end_mm(i) - start_mm(i); }
    /// Heights: diameters, negative in a bore, so that material always ends upward.
    double startHeight_mm(std::size_t i) const { return sign_ * row(i).start_diameter_mm; }
    double endHeight_mm(std::size_t i) const { return sign_ * row(i).end_diameter_mm; }
    bool isConvex(std::size_t i) const { return sign_ * row(i).arc_radius_mm.value_or(0) > 0; }
    bool isConcave(std::size_t i) const { return sign_ * row(i).arc_radius_mm.value_or(0) < 0; }
    /// Of a cone to the axis, without sign.
    double angle_deg(std::size_t i) const;
    /// The row in (u, r).
    ContourPiece piece(std::size_t i) const;

    bool isBore() const { return sign_ < 0; }
    double sign() const { return sign_; }
    bool isFromChuck() const { return sense_ < 0; }
    /// Is there an end of the part before the first row, after the last one?
    bool startsAtEnd() const { return startsAtEnd_; }
    bool endsAtEnd() const { return endsAtEnd_; }
    /// Expanded uncertainty of a boundary's u, that of the contour's own start included.
    double boundaryUncertainty_mm(std::size_t boundary) const;
    /// Where a plane or an end lies that closes row i: at a relieved face the start of the next row.
    double closing_mm(std::size_t i) const;

private:
    void findJoints();

    const std::vector<RecognizedRow>* rows_;
    std::vector<Joint> joints_;
    double sign_ = 1, sense_ = 1, origin_mm_ = 0;
    bool startsAtEnd_ = true, endsAtEnd_ = true;
    double endUncertainty_mm_ = 0, farEndUncertainty_mm_ = 0;
};

/// U of a row's diameters in mm, the larger; 0: not known.
double diameterUncertainty_mm(const RecognizedRow& row);
/// U of a row's length in mm; 0: not known.
double lengthUncertainty_mm(const RecognizedRow& row);

/// Rows that have the pattern of an undercut of DIN 509: cylinder, cone of 15° ± 2°, bottom, hollow arc, face.
struct UndercutRows {
    std::size_t first = 0, last = 0;  ///< of its rows, the relieved face included
    std::size_t run_out = 0, bottom = 0, arc = 0;
    bool before_face = true;  ///< false: the face comes first
    MeasuredUndercut measured;
};
/// The undercut whose first row is `first`; none: no such pattern.
std::optional<UndercutRows> undercutRowsAt(const RowChain& chain, std::size_t first);

/// Rows of a groove: lower than both neighbours, narrow, between planes or flanks.
struct GrooveRows {
    std::size_t first = 0, last = 0;    ///< rows of the chain, both included
    std::optional<std::size_t> bottom;  ///< its cylinder
    bool between_planes = false;        ///< else between flanks
    Measured width, shaft;              ///< shaft: the lower of its neighbours
};
/// The shortest groove whose first row is `first`; none: no such pattern.
std::optional<GrooveRows> grooveRowsAt(const RowChain& chain, std::size_t first);

}  // namespace lathelier::features
