// Limits of the search for marks.
//
// Where no origin is stated, a value was chosen on the practice scans: synthetic scans of turned parts with known
// truth. Names end in the unit; `…_sigmas` are multiples of the noise of single points.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lathelier::features {

/// Keyways, flats and free forms in the map of residuals (off_regions.h, marks.h).
struct MarkLimits {
    double cell_mm = 1;                   ///< height of a cell along the axis
    std::size_t sectors = 144;            ///< cells around the circle
    double most_rows = 1e5;               ///< of cells: bounds the memory
    double edge_margin_mm = 0.4;          ///< walls are blurred beside planes: points there belong to no mark
    double off_sigmas = 5, off_mm = 0.1;  ///< points further from the model are off it
    std::uint32_t least_off_points = 3;   ///< of a cell, more than half of its points
    std::size_t least_cells = 6, least_points = 40;  ///< of a region
    double tail_share = 0.002;                       ///< quantile that is the end of a region: stray points lie beyond
    // The plane of a floor or a flat.
    int plane_rounds = 6, robust_rounds = 2;  ///< of the fit of the plane, and of these with a limit by the median
    double plane_outlier_sigmas = 4;          ///< points further off the plane are the walls of a slot
    double robust_outlier_medians = 3;        ///< in the first rounds, of the median distance
    double least_plane_share = 0.6;           ///< of the points within the plane
    double largest_plane_sigmas = 1.6;        ///< rms distance of these
    double dependent_points = 4;              ///< neighbouring points whose errors count as one
    double floor_form_mm = 0.003;             ///< standard uncertainty of a floor's place beside the noise
    double floor_gap_mm = 2.5;                ///< between two pieces of one floor: two cells
    double same_floor_mm = 0.05, same_floor_deg = 2;  ///< differences of the pieces
    // Zones of one thread.
    double same_pitch_share = 0.005, same_major_mm = 0.1;  ///< by which pitch and crest may differ
    double thread_gap_pitches = 2;                         ///< a relief between two threads is wider
};

inline constexpr MarkLimits markLimits;

/// Threads and knurls in the spectrum of a rough zone (periodic_mark.h).
struct PeriodicLimits {
    int most_starts = 8;         ///< of a thread; more teeth are those of a knurl
    int most_teeth = 160;        ///< of a knurl
    double row_mm = 0.05;        ///< least height of a row of the grid
    double most_rows = 800;      ///< of that grid
    std::size_t columns = 512;   ///< of the grid around the circle: more than three for each tooth
    double radius_share = 0.25;  ///< points further from the zone's radius are no part of it
    std::size_t least_points = 1000, least_rows = 20;  ///< of a zone, and rows of its grid
    std::size_t check_rows = 32;                       ///< Progress::check() after so many
    double padding = 4;                                ///< steps of frequency in that of the zone's length
    double most_frequency_per_mm = 5, most_frequency_per_row = 0.4;  ///< finest pitch 0.2 mm, 2.5 rows
    double most_knurl_frequency_per_mm = 2;                          ///< of the ridges of a knurl along the axis
    double least_thread_frequency_per_mm = 0.15;                     ///< longest lead 6.7 mm
    double most_constant_power = 0.25;  ///< of a thread's wave, in the wave of its order that is the same along z
    double least_ring_waves = 2;        ///< over the length, of what does not turn
    double amplitude_sigmas = 3, amplitude_mm = 0.01;  ///< least amplitude of the peak
    double frequency_resolution_per_mm = 1e-7;
    double refinement = 3;        ///< each round's steps are so many times as fine
    std::size_t phase_bins = 64;  ///< over which the profile is folded
    double root_share = 0.02;     ///< quantile of the radii that is a knurl's root
};

inline constexpr PeriodicLimits periodicLimits;

}  // namespace lathelier::features
