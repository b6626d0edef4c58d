#include "engine/core/units.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {
namespace {

/// The parameters of a section's roundness, except the outlier rule: outliers are sought over the revolutions.
std::vector<Field<TrajectoryParameters>> formFields()
{
    std::vector<Field<TrajectoryParameters>> result;
    for (const Field<form::RoundnessParameters>& field : fields<form::RoundnessParameters>()) {
        if (field.info.key == "outliers") continue;
        result.push_back({field.info, [get = field.get](const TrajectoryParameters& p) { return get(p.form); },
                          [set = field.set](TrajectoryParameters& p, const Value& value) { set(p.form, value); }});
    }
    return result;
}

}  // namespace

const std::vector<Field<ProbeCalibration>>& fieldsOf(const ProbeCalibration*)
{
    using P = ProbeCalibration;
    static const std::vector<Field<P>> all{
        field("probe", &P::probe,
              {{"X3", LT_TEXT("Engine", "X3")},
               {"Y3", LT_TEXT("Engine", "Y3")},
               {"Xp", LT_TEXT("Engine", "Xp")},
               {"Yp", LT_TEXT("Engine", "Yp")}},
              Label{LT_TEXT("Engine", "Probe"), LT_TEXT("Engine", "The signal that it gives.")}),
        field("sensitivity_um_per_V", &P::sensitivity_um_per_V, Range{1e-6, 1e6},
              Label{LT_TEXT("Engine", "Sensitivity"), LT_TEXT("Engine", "By its calibration certificate."),
                    LT_TEXT("Engine", "µm/V")}),
        field("calibrated", &P::calibrated,
              Label{LT_TEXT("Engine", "Calibrated"), LT_TEXT("Engine", "Date of the calibration, for the report.")}),
    };
    return all;
}

const std::vector<Field<TrajectoryParameters>>& fieldsOf(const TrajectoryParameters*)
{
    using P = TrajectoryParameters;
    static const std::vector<Field<P>> all = [] {
        std::vector<Field<P>> list{
            field("workpiece_diameter_mm", &P::workpiece_diameter_mm, Range{0.1, 10000},
                  Label{LT_TEXT("Engine", "Workpiece diameter"),
                        LT_TEXT("Engine", "Nominal; by default as the record says. Form is measured, size is not."),
                        unit::mm}),
            field("points", &P::points, Range{8, 20000},
                  Label{LT_TEXT("Engine", "Angles of a revolution"),
                        LT_TEXT("Engine", "Every revolution is sampled anew at so many even angles."),
                        {},
                        true}),
            field("revolutions", &P::revolutions, Range{2, 100000},
                  Label{LT_TEXT("Engine", "Revolutions of a section"),
                        LT_TEXT("Engine", "So many are averaged; fewer when the record is shorter."),
                        {},
                        true}),
            field("channel_skew_s", &P::channel_skew_s, Range{0, 1},
                  Label{LT_TEXT("Engine", "Delay from channel to channel"),
                        LT_TEXT("Engine", "A multiplexed converter samples each channel so much after the one before."),
                        unit::s, true}),
            field("channels", &P::channels,
                  Label{LT_TEXT("Engine", "Channels"),
                        LT_TEXT("Engine",
                                "Which channel is which signal, counted from 0: marker=0 or angle=0, X3=1, Y3=2, Xp=3, "
                                "Yp=4; -X3=1 turns a sign."),
                        {},
                        true}),
            field("sensitivity_um_per_V", &P::sensitivity_um_per_V, Range{1e-6, 1e6},
                  Label{LT_TEXT("Engine", "Sensitivity"),
                        LT_TEXT(
                            "Engine",
                            "Of displacement channels recorded in volts; others need none. Not given: 50 is assumed."),
                        LT_TEXT("Engine", "µm/V"), true}),
            rows("probes", &P::probes, Range{0, 4},
                 Label{LT_TEXT("Engine", "Calibration of single probes"),
                       LT_TEXT("Engine",
                               "Where probes differ: signal, sensitivity, date of the calibration; X3,49.8,2026-01-31;"
                               "Y3,50.2."),
                       {},
                       true}),
            field("marker_threshold_V", &P::marker_threshold_V, Range{-1000, 1000},
                  Label{LT_TEXT("Engine", "Marker threshold"),
                        LT_TEXT("Engine", "By default half way between the marker's two levels."),
                        LT_TEXT("Engine", "V"), true}),
            field("rotation", &P::rotation,
                  {{"same", LT_TEXT("Engine", "As recorded")}, {"opposite", LT_TEXT("Engine", "Opposite")}},
                  Label{LT_TEXT("Engine", "Angle on the part"),
                        LT_TEXT("Engine", "Seen from the part, the angle may run against the spindle's."),
                        {},
                        true}),
            field("z_mm", &P::z_mm,
                  Label{LT_TEXT("Engine", "Places of the sections"),
                        LT_TEXT("Engine", "Along the workpiece from its free end, one for each: 5,10,15 or 5,5;10;15."),
                        unit::mm}),
            field("feed_mm_rev", &P::feed_mm_rev, Range{1e-6, 1000},
                  Label{LT_TEXT("Engine", "Feed"),
                        LT_TEXT("Engine", "Cuts one continuous record into sections along the workpiece."),
                        unit::mm_rev}),
            field("sections", &P::sections, Range{1, 10000},
                  Label{LT_TEXT("Engine", "Sections"),
                        LT_TEXT("Engine", "Into how many a continuous record is cut."),
                        {},
                        true}),
            field("drift", &P::drift,
                  {{"none", LT_TEXT("Engine", "Kept")}, {"section", LT_TEXT("Engine", "Slope of a section removed")}},
                  Label{LT_TEXT("Engine", "Drift"),
                        LT_TEXT("Engine", "The mean of a section stays in any case: it is the size."),
                        {},
                        true}),
            field("outliers", &P::outliers,
                  {{"none", LT_TEXT("Engine", "Kept")}, {"hampel", LT_TEXT("Engine", "Left out by Hampel's rule")}},
                  Label{LT_TEXT("Engine", "Outliers"),
                        LT_TEXT("Engine", "Samples and revolutions that stand out from the others of their section."),
                        {},
                        true}),
            field("outlier_sigmas", &P::outlier_sigmas, Range{2, 100},
                  Label{LT_TEXT("Engine", "Outliers from"),
                        LT_TEXT("Engine", "In robust standard deviations from the median."), LT_TEXT("Engine", "σ"),
                        true}),
        };
        for (Field<P>& form : formFields()) list.push_back(std::move(form));
        return list;
    }();
    return all;
}

}  // namespace lathelier::trajectory
