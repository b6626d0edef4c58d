// Parts made for the chain, each with its own machine, tools and control: nominal shape, drawing, job, set-up, scans.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/cam/job_file.h"
#include "engine/deflection/setup_file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/sample/sample.h"
#include "engine/sample/scan_ply.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::golden {

/// A part of the test's own.
struct Part {
    const char* name;
    sample::ShaftModel model;            ///< nominal
    double worn_um;                      ///< taken off the first piece's radius in its middle
    double copy_um;                      ///< on the radius of the copy's first piece, at its free end
    double bar_mm, chuck_mm;             ///< diameter of the bar, z of the chuck's face
    const char* post;                    ///< control
    const char* extension;               ///< of its programs
    receptance::SpindleSprings springs;  ///< machine
    bool is_drawn;                       ///< a drawing is stated; else what was recognised is cut
    const char* setups;                  ///< clampings, unused by the chain: for the reader
};

inline const std::vector<Part>& parts()
{
    static const std::vector<Part> all{
        {"pin",
         {{0, 60, 12, 12, 0, 0, 0, 0, 0, 0}, {60, 90, 16, 16, 0, 0, 0, 0, 0, 0}},
         15,
         12,
         36,
         105,
         "haas",
         ".nc",
         {30000, 150e6, 0.05},
         true,
         "1"},
        {"roller",
         {{0, 25, 10, 10, 0, 0, 0, 0, 0, 0}, {25, 75, 18, 18, 0, 0, 0, 0, 0, 0}, {75, 80, 18, 15, 0, 0, 0, 0, 0, 0}},
         10,
         8,
         40,
         95,
         "sinumerik",
         ".mpf",
         {20000, 197e6, 0.06},
         true,
         "1"},
        {"spacer",
         {{0, 40, 14, 14, 0, 0, 0, 0, 0, 0}, {40, 50, 20, 20, 0, 0, 0, 0, 0, 0}, {50, 85, 15, 15, 0, 0, 0, 0, 0, 0}},
         8,
         10,
         44,
         100,
         "linuxcnc",
         ".ngc",
         {45000, 198e6, 0.04},
         false,
         "auto"}};
    return all;
}

inline Shaft drawingOf(const Part& part)
{
    Shaft shaft;
    shaft.name = part.name;
    for (const sample::ShaftPiece& piece : part.model) {
        ShaftSegment row;
        row.length_mm = piece.z_end_mm - piece.z_start_mm;
        row.start_diameter_mm = 2 * piece.radius_start_mm;
        row.end_diameter_mm = 2 * piece.radius_end_mm;
        if (row.start_diameter_mm != row.end_diameter_mm) row.role = "chamfer";
        shaft.segments.push_back(row);
    }
    return shaft;
}

inline cam::Job jobOf(const Part& part)
{
    cam::Job job;
    job.title = part.name;
    job.stock.diameter_mm = part.bar_mm;
    job.stock.face_allowance_mm = 0.8;
    job.setup.chuck_face_z_mm = part.chuck_mm;
    job.tools = {cam::roughD55(), cam::finishD55(),
                 cam::insert(6, cam::ToolUse::FinishBack, 0.4, 93, 35, Hand::FromChuck),
                 cam::blade(8, cam::ToolUse::Groove, 3, 0.2, 20)};
    job.tools.back().feed_mm_rev = 0.06;
    job.cutting.rough = {1.5, 0.2, 180, 0.3};
    job.cutting.finish = {0.1, 200};
    job.max_rpm = 3500;
    return job;
}

inline deflection::TurningSetup setupOf(const Part& part)
{
    deflection::TurningSetup setup;
    setup.material.cutting = {1750, 95, 600, 80};
    setup.tool.corner_radius_mm = 0.4;
    setup.tool.entering_angle_deg = 93;
    setup.chuck = {part.springs.radial_N_mm, 0, part.springs.tilt_N_mm_rad, 0};
    return setup;
}

inline std::string scanOf(sample::ShaftModel model, std::uint64_t seed)
{
    sample::ScannerModel scanner;
    scanner.seed = seed;
    scanner.row_pitch_mm = 0.25;
    scanner.angle_step_deg = 3;
    scanner.sigma_mm = 0.02;
    scanner.scan_T_part = Eigen::Translation3d(0.2, 0.4, 2) * Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX());
    return sample::scanPly(sample::scanShaft(model, scanner));
}

}  // namespace lathelier::golden
