// Moves of the LinuxCNC interpreter: runs stand-alone rs274 and parses what it prints.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <optional>
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

/// State of the printed moves, which have the unit of the program and count from the zero in force.
class Rs274Reader {
public:
    /// `with_dwells`: dwells too, in the order of the program.
    std::vector<Move> read(std::istream& printed, bool with_dwells)
    {
        std::vector<Move> moves;
        for (std::string line; std::getline(printed, line);)
            if (const std::optional<Move> move = moveOf(line))
                if (with_dwells || move->kind != MoveKind::Dwell) moves.push_back(*move);
        return moves;
    }

private:
    std::optional<Move> moveOf(const std::string& line)
    {
        const std::size_t open = line.find('(');
        if (open == std::string::npos) return std::nullopt;
        const std::string name = line.substr(line.rfind(' ', open) + 1, open - line.rfind(' ', open) - 1);
        const std::vector<double> numbers = argumentsOf(line, open);
        if (name == "STRAIGHT_TRAVERSE") return moveTo(MoveKind::Rapid, numbers.at(0), numbers.at(2));
        if (name == "STRAIGHT_FEED")
            return moveTo(lead_mm_ ? MoveKind::Thread : MoveKind::Feed, numbers.at(0), numbers.at(2));
        if (name == "ARC_FEED") {  // of the plane XZ: Z first; anticlockwise about Y is clockwise in ours
            Move move = moveTo(MoveKind::Arc, numbers.at(1), numbers.at(0));
            move.centre_z_mm = unit_mm_ * numbers.at(2) + shift(1);
            move.centre_x_mm = unit_mm_ * numbers.at(3) + shift(0);
            move.clockwise = numbers.at(4) < 0;
            return move;
        }
        if (name == "DWELL") {
            Move move;
            move.kind = MoveKind::Dwell;
            move.dwell_s = numbers.at(0);
            return move;
        }
        takeState(line, name, numbers, open);
        return std::nullopt;
    }

    void takeState(const std::string& line, const std::string& name, const std::vector<double>& numbers,
                   std::size_t open)
    {
        if (name == "USE_LENGTH_UNITS") unit_mm_ = line.find("MM") == std::string::npos ? 25.4 : 1;
        if (name == "SET_G5X_OFFSET") offset_mm_ = {unit_mm_ * numbers.at(1), unit_mm_ * numbers.at(3)};
        if (name == "SET_G92_OFFSET") stated_mm_ = {unit_mm_ * numbers.at(0), unit_mm_ * numbers.at(2)};
        if (name == "SET_FEED_MODE") isPerRevolution_ = numbers.at(1) == 1;
        if (name == "SET_FEED_RATE") feed_mm_ = unit_mm_ * numbers.at(0);
        if (name == "START_SPEED_FEED_SYNC") lead_mm_ = unit_mm_ * numbers.at(0);
        if (name.starts_with("STOP_SPEED_FEED_SYNC")) lead_mm_.reset();
        // SET_SPINDLE_MODE(0 2500.0): of constant cutting speed, with its limit; 0: speeds.
        if (name == "SET_SPINDLE_MODE") limit_rpm_ = std::stod(line.substr(line.find(' ', open)));
        if (name == "SET_SPINDLE_SPEED") speed_ = numbers.at(1) * (limit_rpm_ > 0 && unit_mm_ > 1 ? 0.3048 : 1);
    }

    Move moveTo(MoveKind kind, double x, double z) const
    {
        Move move;
        move.kind = kind;
        move.x_mm = unit_mm_ * x + shift(0);
        move.z_mm = unit_mm_ * z + shift(1);
        if (kind == MoveKind::Feed || kind == MoveKind::Arc)
            (isPerRevolution_ ? move.feed_mm_rev : move.feed_mm_min) = feed_mm_;
        if (kind == MoveKind::Thread) move.feed_mm_rev = *lead_mm_;
        (limit_rpm_ > 0 ? move.cutting_speed_m_min : move.speed_rpm) = speed_;
        if (limit_rpm_ > 0) move.speed_limit_rpm = limit_rpm_;
        return move;
    }
    double shift(std::size_t axis) const { return offset_mm_.at(axis) + stated_mm_.at(axis); }

    double unit_mm_ = 1, feed_mm_ = 0, limit_rpm_ = 0, speed_ = notANumber;
    bool isPerRevolution_ = false;
    std::optional<double> lead_mm_;
    std::array<double, 2> offset_mm_{}, stated_mm_{};
};

/// What rs274 makes of a program; none: it refuses it, or does not come to an end.
inline std::optional<std::vector<Move>> madeByLinuxCnc(const std::string& program, const std::filesystem::path& folder,
                                                       bool with_dwells)
{
    std::ofstream(folder / "program.ngc", std::ios::binary) << program;
    // rs274 refuses tools missing in its table. Without INI file the table is in inches: all zeros. It keeps its
    // variables from one program to the next.
    std::filesystem::remove(folder / "rs274ngc.var");
    std::filesystem::remove(folder / "printed.txt");
    std::ofstream table(folder / "tools.tbl", std::ios::binary);
    for (int tool = 1; tool <= 20; ++tool) table << fmt::format("T{0} P{0} X0 Z0 D0\n", tool);
    table.close();
    const std::string command =
        fmt::format("cd '{}' && timeout 3 {} -t tools.tbl -g program.ngc printed.txt >messages.txt 2>&1",
                    folder.string(), LATHELIER_RS274);
    const int state = std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe): a test of our own
    std::ifstream file(folder / "printed.txt");
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    const bool isWhole = all.find("PROGRAM_END") != std::string::npos && all.find("nan") == std::string::npos;
    if (state != 0 || !isWhole) return std::nullopt;
    std::istringstream printed(all);
    return Rs274Reader().read(printed, with_dwells);
}

/// Runs rs274 on a program in a separate folder; expects success.
inline std::vector<Move> movesOfLinuxCnc(const std::string& program, const std::filesystem::path& folder)
{
    const std::optional<std::vector<Move>> made = madeByLinuxCnc(program, folder, false);
    EXPECT_TRUE(made) << program;
    return made.value_or(std::vector<Move>{});
}

}  // namespace lathelier::gcode
