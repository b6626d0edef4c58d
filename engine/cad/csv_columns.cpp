#include "engine/cad/csv_columns.h"

namespace lathelier::cad {
namespace {

MeasuredSize& measured(ShaftSegment& row)
{
    if (!row.measured) row.measured.emplace();
    return *row.measured;
}

SizeTolerance& tolerance(ShaftSegment& row)
{
    if (!row.tolerance) row.tolerance.emplace();
    return *row.tolerance;
}

template <auto Member>
constexpr CsvColumn ofRow(const char* name)
{
    return {name, [](const ShaftSegment& row) -> std::optional<double> { return row.*Member; },
            [](ShaftSegment& row, double value) { row.*Member = value; }, true};
}

template <auto Member>
constexpr CsvColumn ofTolerance(const char* name)
{
    return {name,
            [](const ShaftSegment& row) { return row.tolerance ? (*row.tolerance).*Member : std::optional<double>(); },
            [](ShaftSegment& row, double value) { tolerance(row).*Member = value; }, false};
}

template <auto Member>
constexpr CsvColumn ofMeasured(const char* name)
{
    return {name,
            [](const ShaftSegment& row) { return row.measured ? (*row.measured).*Member : std::optional<double>(); },
            [](ShaftSegment& row, double value) { measured(row).*Member = value; }, false};
}

template <auto Member>
constexpr CsvColumn ofUncertainty(const char* name)
{
    return {name,
            [](const ShaftSegment& row) {
                return row.measured ? row.measured->uncertainty.*Member : std::optional<double>();
            },
            [](ShaftSegment& row, double value) { measured(row).uncertainty.*Member = value; }, false};
}

}  // namespace

const std::vector<CsvColumn>& csvColumns()
{
    using S = ShaftSegment;
    using T = SizeTolerance;
    using M = MeasuredSize;
    using U = SizeUncertainty;
    static const std::vector<CsvColumn> all = {
        ofRow<&S::length_mm>("length_mm"),
        ofRow<&S::start_diameter_mm>("start_diameter_mm"),
        ofRow<&S::end_diameter_mm>("end_diameter_mm"),
        {"arc_radius_mm", [](const S& row) { return row.arc_radius_mm; },
         [](S& row, double value) { row.arc_radius_mm = value; }, false},
        {"bore_diameter_mm",
         [](const S& row) { return row.bore_diameter_mm > 0 ? row.bore_diameter_mm : std::optional<double>(); },
         [](S& row, double value) { row.bore_diameter_mm = value; }, false},
        ofTolerance<&T::lower_um>("tolerance_lower_um"),
        ofTolerance<&T::upper_um>("tolerance_upper_um"),
        ofMeasured<&M::length_mm>("measured_length_mm"),
        ofMeasured<&M::start_diameter_mm>("measured_start_diameter_mm"),
        ofMeasured<&M::end_diameter_mm>("measured_end_diameter_mm"),
        ofMeasured<&M::arc_radius_mm>("measured_arc_radius_mm"),
        ofUncertainty<&U::z_start_um>("U_z_start_um"),
        ofUncertainty<&U::z_end_um>("U_z_end_um"),
        ofUncertainty<&U::length_um>("U_length_um"),
        ofUncertainty<&U::start_diameter_um>("U_start_diameter_um"),
        ofUncertainty<&U::end_diameter_um>("U_end_diameter_um"),
        ofUncertainty<&U::arc_radius_um>("U_arc_radius_um"),
        ofUncertainty<&U::angle_deg>("U_angle_deg")};
    return all;
}

}  // namespace lathelier::cad
