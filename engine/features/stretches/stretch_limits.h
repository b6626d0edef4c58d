// Limits of the search for stretches that are not round.
//
// Where no origin is stated, a value was chosen on synthetic scans of turned parts with known truth. Names end in the
// unit; `…_sigmas` are multiples of the noise of single points.
#pragma once

#include <cstddef>

namespace lathelier::features {

/// Sections across the axis, and runs of equal ones (sections.h).
struct SectionLimits {
    std::size_t sectors = 360;                      ///< of a section
    double points_per_section = 1000;               ///< sections with fewer are longer
    double shortest_mm = 0.5, longest_mm = 2;       ///< length of a section
    double most_sections = 4000;                    ///< bounds the memory
    double wall_gap_mm = 0.5, wall_gap_sigmas = 8;  ///< points of a sector further apart lie on different walls
    double least_seen_share = 0.08;                 ///< of the sectors: fewer show no shape
    double least_spread_mm = 0.04, least_spread_sigmas = 2;  ///< rms of the radius: a lower one is called round
    double like_spread = 0.7;                                ///< rms difference of equal sections, of their own spread
    double like_sigmas = 3;                                  ///< besides: noise of the medians of sectors
    double like_mean_mm = 0.1, like_mean_sigmas = 4;         ///< by which the mean radii of equal sections may differ
    std::size_t least_sections = 3;                          ///< of a run; fewer lie across an edge
    double least_run_mm = 2.5;                               ///< of equal sections
    double join_mm = 1.6;                                    ///< equal runs this near to each other are one
    double inner_mm = 0.4;  ///< with `wall_gap_sigmas`: points further below are a bore's
};
inline constexpr SectionLimits sectionLimits;

/// Proofs of the shape of a stretch: eccentric_fit.h, prism_fit.h, spline_fit.h.
struct StretchProof {
    std::size_t most_points = 150000;  ///< of a stretch that are used, drawn evenly
    std::size_t least_points = 500;
    double on_sigmas = 4, on_mm = 0.02;      ///< points nearer lie on the shape; the length: waviness and form of a cut
    double least_on_share = 0.9;             ///< of the points; corners and flanks blur some
    double rms_sigmas = 1.4, rms_mm = 0.01;  ///< of the points on the shape
    double tukey_sigmas = 5;                 ///< of the robust fits
    int rounds = 25;                         ///< of these
    double settled_mm = 1e-7;                ///< last step of such a fit
    double dependent_points = 4;             ///< neighbouring points whose errors count as one
    double form_mm = 0.002;                  ///< standard uncertainty of the form of a cut, in every U
    std::size_t z_parts = 4;                 ///< the shape is the same in so many parts along the axis
    double drift_sigmas = 5, drift_mm = 0.02;  ///< by which these may differ
    // Eccentric.
    double least_offset_mm = 0.15;  ///< less is an error of form: a note
    double least_arc_share = 0.25;  ///< of the circle about the own axis that is seen
    double slid_offset_share =
        0.3;  ///< of the radius: with a larger offset points are moved with the axis, not radially
    // Prisms.
    std::size_t profile_sectors = 720;
    double phase_step_deg = 0.25;
    double flat_share = 0.6;         ///< of the half angle of a face: used for the search, chamfered corners lie beyond
    double least_flat_share = 0.35;  ///< of the circle on faces, the rest on the corner circle
    int corner_steps = 200;          ///< of the search for the circle over the corners, from these to the faces
    double sharp_mm = 0.1;           ///< corners that are cut by less are sharp
    std::size_t least_corner_sectors = 8;    ///< that are cut: then their median is the circle's radius
    double most_centre_mm = 0.3;             ///< of the prism off the axis
    double face_mm = 0.05, face_sigmas = 4;  ///< by which a single face may be off
    std::size_t least_face_points = 20;
    // Splines and serrations.
    int least_teeth = 6, most_teeth = 60;
    std::size_t fold_bins = 32;                          ///< of the profile folded over a pitch, for the search
    std::size_t pitch_bins = 96, least_pitch_bins = 24;  ///< of the final one
    double points_per_bin = 40;                          ///< else there are fewer
    double least_explained = 0.9;  ///< share of the variance of the radius that the folded profile explains
    double as_good = 0.02;         ///< the highest number of teeth that explains as much is theirs
    double least_depth_mm = 0.15, least_depth_sigmas = 6;
    double wave_share = 0.95;  ///< of a profile's variance in one wave: lobes of form, unless it is deep
    double deep_share = 0.15;  ///< depth over pitch of teeth
    double between_level = 0.25,
           most_between_share = 0.3;  ///< of the depth and the pitch: few teeth have steep flanks,
    std::size_t few_teeth = 12;       ///< a polygon has not; more teeth may be serrations
    double level_share = 0.05;        ///< quantile of the bins that is near the root, 1 - it near the crest
    double odd_tooth_share = 0.25;    ///< of the depth: by which a single tooth or gap may be off
    double least_pitch_mm = 2.2;      ///< DIN 82: finer ones are a knurl (mark_proof.h)
    double flank_sigmas = 4;          ///< points between the levels by more are a flank's
    double slope_share = 0.3;  ///< parallel flanks are as wide below as above, radial ones in proportion to the radius
    double least_flank_share = 0.01;                           ///< of the points: radial flanks show none
    double flank_scatter_sigmas = 3, flank_scatter_mm = 0.03;  ///< of the points on a parallel flank
    double scattered_sigmas = 2.5;                             ///< bins of the pitch that scatter more are flanks
    double rise_sigmas = 1, rise_mm = 0.02;                    ///< likewise where the bins beside differ by more,
    double least_level_share = 0.25;  ///< unless that leaves less of the pitch: a serration has no levels
};
inline constexpr StretchProof stretchProof;

/// Deep threads and worms: helix_fit.h.
struct HelixLimits {
    double least_spread_mm = 0.34;  ///< rms of the radius of a section; M16×2 has 0.35, and shallower ones are one wall
    double least_zone_mm = 5;       ///< of such sections
    double least_depth_mm = 1.2;    ///< M16×2 has 1.23
    double shortest_pitch_mm = 1.8, longest_pitch_mm = 13;  ///< M16×2 to module 4
    std::size_t most_starts = 4;
    std::size_t search_points = 15000;
    double steps_per_wave = 5;      ///< of the grid of frequencies, over the length
    int rounds = 12;                ///< of its halving: phases within a thousandth
    double least_explained = 0.85;  ///< of the variance: flanks are steep, and rays are blurred along the axis
    double least_pitches = 1.5;     ///< that the stretch holds
    double crest_mm = 0.15;         ///< by which the crest of the radii may differ from that of the profile
    double module_share = 0.004;    ///< by which a pitch may differ from that of a module
    double least_worm_depth = 1.8, most_worm_depth = 2.6;  ///< in modules; DIN 3975: 2.2
};
inline constexpr HelixLimits helixLimits;

/// Ends of a stretch along the axis (stretch_ends.h) and how its points are moved (rounding.h).
struct StretchEnds {
    double reach_mm = 1.2;                 ///< of the search for an end
    double beyond_mm = 0.6;                ///< from here to `reach_mm` beyond the end points show what follows
    double low_sigmas = 6, low_mm = 0.05;  ///< below the round: where the shape shows
    std::size_t least_points = 20;
    double unseen_share = 0.7;          ///< of the share within: taken beyond the end of the data
    double crest_reach_mm = 3;          ///< as `reach_mm`, of crests and corners alone: sections go on in chamfers
    double earlier_mm = 0.1;            ///< by which crests end before the rest: then in a chamfer
    double helix_reach_mm = 4;          ///< as `reach_mm`: sections of chamfers are among those that wind
    double extend_mm = 4;               ///< of gaps and faces beyond, on a chamfer
    double extend_step_mm = 0.3;        ///< steps of that search
    double corner_share = 0.25;         ///< of the height of a prism's corners over its faces: there it is a corner
    std::size_t least_step_points = 4;  ///< of a step, in gaps and beside them
    double shared_mm = 0.004;  ///< standard uncertainty of the walls that are made of moved points: form of the shape
    double edge_mm = 0.6;      ///< beside an end points that are not on the shape are those of the neighbour
    double edge_sigmas = 5, edge_off_mm = 0.05;
    int line_rounds = 5;                 ///< of the line through a chamfer
    double least_slope = 0.1;            ///< of such a line: flatter ones are none
    double begin_mm = 0.5;               ///< by which it may begin elsewhere than the section seems to end
    double grow_step_mm = 0.5;           ///< steps by which the sections of a stretch are followed,
    std::size_t most_grow_steps = 2000;  ///< at most
    double crest_share = 0.97;           ///< of the points on crests and corners: fewer are those of a chamfer
    double absorb_share = 0.85;          ///< of the points of a run beside, on the shape: it is part of the stretch
    double at_end_mm = 1.5;              ///< between the ends of a stretch and of the part: chamfers to 1 mm and more
    double end_sigma_mm = 0.25;        ///< of an end that is not explained: chamfers of corners were up to 0.5 mm off,
    double spline_end_sigma_mm = 0.1;  ///< and of teeth up to 0.13 mm
    double over_share = 0.5;           ///< of another mark within a stretch: then it is part of it
};
inline constexpr StretchEnds stretchEnds;

}  // namespace lathelier::features
