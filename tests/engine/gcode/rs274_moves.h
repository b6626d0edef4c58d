// Moves of the LinuxCNC interpreter: runs stand-alone rs274 and parses its output.
#pragma once

#ifdef LATHELIER_RS274

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "engine/gcode/move.h"

namespace lathelier::gcode {

/// Numbers between the brackets of a line like STRAIGHT_FEED(1.0, 0.0, 2.0).
inline std::vector<double> argumentsOf(const std::string& line, std::size_t open)
{
    std::vector<double> found;
    std::istringstream text(line.substr(open + 1));
    text.imbue(std::locale::classic());
    for (double value; text >> value; text.ignore(1)) found.push_back(value);
    return found;
}

/// Cutting and positioning moves from the output of rs274. Its coordinates have the unit of the program.
inline std::vector<Move> movesOf(std::istream& printed)
{
    std::vector<Move> moves;
    double unit_mm = 1;
    for (std::string line; std::getline(printed, line);) {
        const std::size_t open = line.find('(');
        if (open == std::string::npos) continue;
        const std::string name = line.substr(line.rfind(' ', open) + 1, open - line.rfind(' ', open) - 1);
        if (name == "USE_LENGTH_UNITS") unit_mm = line.find("MM") == std::string::npos ? 25.4 : 1;
        Move move;
        const std::vector<double> numbers = argumentsOf(line, open);
        if (name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_FEED") {
            move.kind = name == "STRAIGHT_FEED" ? MoveKind::Feed : MoveKind::Rapid;
            move.x_mm = unit_mm * numbers.at(0);
            move.z_mm = unit_mm * numbers.at(2);
        } else if (name == "ARC_FEED") {  // of the plane XZ: Z first; anticlockwise about Y is clockwise in ours
            move.kind = MoveKind::Arc;
            move.z_mm = unit_mm * numbers.at(0);
            move.x_mm = unit_mm * numbers.at(1);
            move.centre_z_mm = unit_mm * numbers.at(2);
            move.centre_x_mm = unit_mm * numbers.at(3);
            move.clockwise = numbers.at(4) < 0;
        } else {
            continue;
        }
        moves.push_back(move);
    }
    return moves;
}

/// Runs rs274 on a program in a separate folder; expects success.
inline std::vector<Move> movesOfLinuxCnc(const std::string& program, const std::filesystem::path& folder)
{
    std::ofstream(folder / "program.ngc", std::ios::binary) << program;
    // rs274 refuses tools missing in its table. Without INI file the table is in inches: all zeros.
    std::ofstream table(folder / "tools.tbl", std::ios::binary);
    for (int tool = 1; tool <= 20; ++tool) table << fmt::format("T{0} P{0} X0 Z0 D0\n", tool);
    table.close();
    const std::string command = fmt::format("cd '{}' && {} -t tools.tbl -g program.ngc printed.txt >messages.txt 2>&1",
                                            folder.string(), LATHELIER_RS274);
    const int state = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe): a test of our own
    EXPECT_EQ(state, 0) << program;
    std::ifstream printed(folder / "printed.txt");
    return movesOf(printed);
}

}  // namespace lathelier::gcode

#endif
