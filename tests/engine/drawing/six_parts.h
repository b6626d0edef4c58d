// The six parts that recognition is judged by, as values: stepped, undercut, tapered, with a keyway, bored, threaded.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

inline Shaft table1Part()
{
    Shaft shaft;
    shaft.name = "table1";
    shaft.material = Material{"11SMn30 (1.0715)"};
    shaft.segments = {{98, 30, 30, 0, {}, ""},
                      {10, 37, 37, 0, {}, ""},
                      {70, 33.8, 33.8, 0, {}, ""},
                      {5, 33.8, 23.8, 0, {}, "chamfer"}};
    return shaft;
}

inline Shaft undercutPart()
{
    Shaft shaft;
    shaft.name = "undercut";
    shaft.material = Material{"11SMn30 (1.0715)"};
    shaft.segments = {{1, 18, 20, 0, {}, "chamfer"},
                      {11, 20, 20, 0, {}, ""},
                      {1.3, 19, 19, 0, {}, "groove"},
                      {24.7, 20, 20, 0, {}, ""},
                      {0.746410162, 20, 19.6, 0, {}, "undercut"},
                      {0.653589838, 19.6, 19.6, 0, {}, "undercut"},
                      {0.6, 19.6, 20.8, 0, -0.6, "undercut"},
                      {27.5, 25, 25, 0, {}, ""},
                      {1.119615242, 25, 24.4, 0, {}, "undercut"},
                      {0.780384758, 24.4, 24.4, 0, {}, "undercut"},
                      {0.792214455, 24.4, 26.222676962, 0, -0.8, "undercut"},
                      {-0.192214455, 26.222676962, 28.958030788, 0, {}, "undercut"},
                      {0.5, 33, 34, 0, {}, "chamfer"},
                      {9, 34, 34, 0, {}, ""},
                      {0.5, 34, 33, 0, {}, "chamfer"},
                      {1, 27, 25, 0, -1.0, "fillet"},
                      {37, 25, 25, 0, {}, ""},
                      {22.5, 17, 17, 0, {}, ""},
                      {1.5, 17, 14, 0, {}, "chamfer"}};
    return shaft;
}

inline Shaft taperPart()
{
    Shaft shaft;
    shaft.name = "taper";
    shaft.material = Material{"11SMn30 (1.0715)"};
    shaft.segments = {{1, 14, 16, 0, 1.0, "edge_round"},
                      {19, 16, 16, 0, {}, ""},
                      {0.8, 16, 17.6, 0, -0.8, "fillet"},
                      {20, 24, 24, 0, {}, ""},
                      {40, 24, 28, 0, {}, ""},
                      {4, 28, 28, 0, {}, ""},
                      {2.5, 28, 33.0, 0, -2.5, "fillet"},
                      {8, 42, 42, 0, {}, ""},
                      {24, 42, 42, 0, -60.0, "saddle"},
                      {6, 42, 42, 0, {}, ""},
                      {3, 42, 36, 0, 3.0, "edge_round"},
                      {3.464101615, 30, 26, 0, {}, "taper30"},
                      {12, 26, 26, 0, {}, ""},
                      {1, 26, 24, 0, {}, "chamfer"}};
    return shaft;
}

inline Shaft keywayPart()
{
    Shaft shaft;
    shaft.name = "keyway";
    shaft.material = Material{"11SMn30 (1.0715)"};
    shaft.segments = {{1, 28, 30, 0, {}, "chamfer"}, {59, 30, 30, 0, {}, ""},        {1, 30, 32, 0, -1.0, "fillet"},
                      {25, 40, 40, 0, {}, ""},       {6, 46, 46, 0, {}, ""},         {34, 35.01, 35.01, 0, {}, ""},
                      {30, 35, 35, 0, {}, ""},       {1.5, 35, 32, 0, {}, "chamfer"}};
    ShaftMark mark;
    mark.kind = MarkKind::Keyway;
    mark.angle_deg = 40;
    mark.width_mm = 8;
    mark.floor_mm = 11;
    mark.z_start_mm = 10;
    mark.z_end_mm = 50;
    shaft.marks.push_back(mark);
    return shaft;
}

inline Shaft flangePart()
{
    Shaft shaft;
    shaft.name = "flange";
    shaft.material = Material{"11SMn30 (1.0715)"};
    shaft.segments = {{1, 58, 60, 0, {}, "chamfer"},
                      {29, 60, 60, 0, {}, ""},
                      {1.6, 60, 63.2, 0, -1.6, "fillet"},
                      {14, 110, 110, 0, {}, ""},
                      {2, 110, 106, 0, {}, "chamfer"}};
    shaft.bores = {{ShaftEnd::Free,
                    {{1, 42, 40, {}, "chamfer"},
                     {17, 40, 40, {}, ""},
                     {20.6, 32, 32, {}, ""},
                     {8, 47, 47, {}, ""},
                     {1, 47, 49, {}, "chamfer"}}}};
    return shaft;
}

inline Shaft threadPart()
{
    Shaft shaft;
    shaft.name = "thread";
    shaft.material = Material{"11SMn30 (1.0715)"};
    shaft.segments = {{1.5, 13, 16, 0, {}, "chamfer"},  {26.5, 16, 16, 0, {}, "thread"},
                      {4, 13.2, 13.2, 0, {}, "groove"}, {22, 18, 18, 0, {}, ""},
                      {30, 24, 24, 0, {}, "knurl"},     {1, 24, 22, 0, {}, "chamfer"}};
    ShaftMark mark;
    mark.kind = MarkKind::Thread;
    mark.z_start_mm = 0;
    mark.z_end_mm = 28;
    mark.pitch_mm = 2;
    mark.major_mm = 16;
    mark.starts = 1;
    mark.hand = 1;
    shaft.marks.push_back(mark);
    ShaftMark mark2;
    mark2.kind = MarkKind::Knurl;
    mark2.z_start_mm = 54;
    mark2.z_end_mm = 84;
    mark2.teeth = 60;
    mark2.diameter_mm = 24;
    mark2.depth_mm = 0.45;
    mark2.helix_deg = 30;
    shaft.marks.push_back(mark2);
    return shaft;
}

/// Each part beside its name.
inline std::vector<std::pair<std::string, Shaft>> allParts()
{
    return {{"table1", table1Part()}, {"undercut", undercutPart()}, {"taper", taperPart()},
            {"keyway", keywayPart()}, {"flange", flangePart()},     {"thread", threadPart()}};
}

}  // namespace lathelier::drawing
