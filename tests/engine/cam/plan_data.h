// Jobs for plans, made here: tools of the trade, the papers' shaft, random shafts.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "engine/cam/plan.h"

namespace lathelier::cam {

inline ShaftSegment row(double length, double start, double end, double arc = 0)
{
    ShaftSegment segment;
    segment.length_mm = length;
    segment.start_diameter_mm = start;
    segment.end_diameter_mm = end;
    if (arc != 0) segment.arc_radius_mm = arc;
    return segment;
}

inline JobTool insert(int number, ToolUse use, double radius, double entering, double tip,
                      Hand hand = Hand::TowardChuck)
{
    JobTool tool;
    tool.number = number;
    tool.use = use;
    tool.corner_radius_mm = radius;
    tool.entering_angle_deg = entering;
    tool.tip_angle_deg = tip;
    tool.edge_length_mm = 12;
    tool.hand = hand;
    return tool;
}

inline JobTool blade(int number, ToolUse use, double width, double corner, double depth)
{
    JobTool tool;
    tool.number = number;
    tool.use = use;
    tool.width_mm = width;
    tool.corner_radius_mm = corner;
    tool.reach_mm = depth;
    return tool;
}

inline JobTool roughC80()
{
    return insert(1, ToolUse::Rough, 0.8, 95, 80);
}
inline JobTool finishC80()
{
    return insert(2, ToolUse::Finish, 0.4, 95, 80);
}
inline JobTool roughD55()
{
    return insert(5, ToolUse::Rough, 0.8, 93, 55);
}
inline JobTool finishD55()
{
    return insert(3, ToolUse::Finish, 0.4, 93, 55);
}
inline JobTool finishV35()
{
    return insert(4, ToolUse::Finish, 0.4, 93, 35);
}
inline JobTool backV35()
{
    return insert(6, ToolUse::FinishBack, 0.4, 93, 35, Hand::FromChuck);
}

inline Job jobWith(std::vector<ShaftSegment> rows, double bar, double chuck, std::vector<JobTool> tools)
{
    Job job;
    job.title = "TEST";
    job.shaft = Shaft{};
    job.shaft->segments = std::move(rows);
    job.stock.diameter_mm = bar;
    job.stock.face_allowance_mm = 1;
    job.setup.chuck_face_z_mm = chuck;
    job.tools = std::move(tools);
    job.cutting.rough = {2, 0.25, 190, 0.3};
    job.cutting.finish = {0.1, 190};
    return job;
}

inline std::vector<ShaftSegment> paperRows()
{
    return {row(98, 30, 30), row(10, 37, 37), row(70, 33.8, 33.8), row(5, 33.8, 23.8)};
}

inline std::vector<ShaftSegment> neckRows()
{
    return {row(2, 16, 20),  row(25, 20, 20), row(3, 17, 17), row(30, 24, 24), row(2, 24, 28, -2),
            row(15, 28, 28), row(12, 28, 20), row(8, 20, 20), row(6, 20, 30),  row(20, 30, 30)};
}

inline Job paperJob(std::vector<JobTool> tools, bool part_off = false)
{
    Job job = jobWith(paperRows(), 40, 200, std::move(tools));
    job.part_off = part_off;
    return job;
}

inline TurningPlan planned(const Job& job, const char* post = "linuxcnc", SetupChoice setups = SetupChoice::One)
{
    TurningInputs inputs;
    inputs.post = postNamed(post);
    TurningParameters parameters;
    parameters.setups = setups;
    return planTurning(*job.shaft, job, inputs, parameters);
}

/// 3 to 14 rows: cylinders, cones, tangent and arbitrary arcs, grooves, chamfers.
inline Shaft randomShaft(std::mt19937& random)
{
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Shaft shaft;
    const int count = std::uniform_int_distribution<int>(3, 14)(random);
    double diameter = uniform(10, 36);
    if (uniform(0, 1) < 0.5) {
        const double chamfer = uniform(0.5, 2);
        shaft.segments.push_back(row(chamfer, diameter, diameter + 2 * chamfer));
        diameter += 2 * chamfer;
    }
    while (static_cast<int>(shaft.segments.size()) < count) {
        const int kind = std::uniform_int_distribution<int>(0, 6)(random);
        const double next = std::clamp(diameter + uniform(-6, 8), 8.0, 46.0);
        const double length = uniform(3, 20), rise = (next - diameter) / 2;
        if (kind <= 2) {
            diameter = uniform(0, 1) < 0.6 ? next : diameter;
            shaft.segments.push_back(row(length, diameter, diameter));
        } else if (kind == 3) {
            shaft.segments.push_back(row(length, diameter, next));
            diameter = next;
        } else if (kind == 4) {  // an arc that does not turn back: radius far above what its chord needs
            const double chord = std::hypot(length, rise), slope = std::abs(std::atan2(rise, length));
            const double lean = std::min(std::acos(-1.0) / 2 - slope - 0.05, 1.0);
            if (lean < 0.05) continue;
            const double radius = chord / 2 / std::sin(uniform(0.3, 0.95) * lean);
            shaft.segments.push_back(row(length, diameter, next, uniform(0, 1) < 0.5 ? radius : -radius));
            diameter = next;
        } else if (kind == 5 && rise > 0.4) {  // a quarter of a fillet or of a rounding, tangent to the cylinder
            const double radius = std::min(rise, 4.0);
            const bool hollow = uniform(0, 1) < 0.5;
            shaft.segments.push_back(row(radius, diameter, diameter + 2 * radius, hollow ? -radius : radius));
            diameter += 2 * radius;
            shaft.segments.push_back(row(length, diameter, diameter));
        } else if (kind == 6 && diameter > 13) {  // a groove
            const double depth = uniform(0.5, 2.5);
            shaft.segments.push_back(row(uniform(2, 6), diameter - 2 * depth, diameter - 2 * depth));
            shaft.segments.push_back(row(length, diameter, diameter));
        }
    }
    return shaft;
}

/// A job for it: one of several sets of tools, with rest tools or not.
inline Job randomJob(std::mt19937& random, bool rest_tools)
{
    std::vector<JobTool> tools = std::uniform_int_distribution<int>(0, 1)(random) == 0
                                     ? std::vector<JobTool>{roughC80(), finishC80()}
                                     : std::vector<JobTool>{roughD55(), finishD55()};
    if (rest_tools) {
        tools.push_back(backV35());
        tools.push_back(blade(8, ToolUse::Groove, 2, 0.2, 30));
    }
    const Shaft shaft = randomShaft(random);
    double largest = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        largest = std::max({largest, segment.start_diameter_mm, segment.end_diameter_mm});
        if (segment.arc_radius_mm.value_or(0) > 0) {  // a convex arc may stand higher than its ends
            const ContourPiece piece{{0, segment.start_diameter_mm / 2},
                                     {segment.length_mm, segment.end_diameter_mm / 2},
                                     *segment.arc_radius_mm,
                                     0};
            largest = std::max(largest, 2 * (piece.centre_mm().y() + *segment.arc_radius_mm));
        }
    }
    Job job = jobWith(shaft.segments, std::ceil(largest + 1), shaft.length_mm() + 20, std::move(tools));
    job.part_off = rest_tools;
    return job;
}

inline JobTool centreDrill(int number)
{
    JobTool tool;
    tool.number = number;
    tool.use = ToolUse::CentreDrill;
    return tool;
}

/// Between chuck and tailstock, with its centre hole drilled first.
inline Job tailstockJob()
{
    Job job = jobWith({row(1, 26, 28), row(39, 28, 28), row(40, 34, 34), row(60, 42, 42)}, 46, 165,
                      {roughC80(), finishC80(), centreDrill(9)});
    job.setup.tailstock = JobTailstock{5, {}};
    return job;
}

/// With a thread M24 that runs out into a relief.
inline Job threadedJob()
{
    JobTool threader;
    threader.number = 11;
    threader.use = ToolUse::Thread;
    Job job = jobWith({row(2, 20, 24), row(25, 24, 24), row(5, 19, 19), row(30, 32, 32)}, 36, 90,
                      {roughD55(), finishD55(), backV35(), blade(8, ToolUse::Groove, 3, 0.2, 18), threader});
    job.shaft->segments[1].thread = "M24x2";
    return job;
}

}  // namespace lathelier::cam
