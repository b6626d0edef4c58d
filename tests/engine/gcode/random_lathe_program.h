// Random lathe programs of LinuxCNC, the same for the same seed: straight moves and arcs in all modes, shifts of the
// zero, threads, contour cycles, subroutines, loops, conditions, variables.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace lathelier::gcode {

class RandomLatheProgram {
public:
    explicit RandomLatheProgram(std::uint32_t seed) : random_(seed), hasCycles_(seed % 3 == 0) {}

    /// Do its moves include those of G70 to G72?
    bool hasCycles() const { return hasCycles_; }

    std::string text()
    {
        unit_mm_ = chance(0.3) ? 25.4 : 1;
        text_ = fmt::format("G18 {} G7 G90 G91.1 G95\nF0.1\nG97 S1000 M3\n", unit_mm_ > 1 ? "G20" : "G21");
        subroutines();
        for (int offset = 1; offset <= 6; ++offset)
            text_ += fmt::format("G10 L2 P{} X{} Z{}\n", offset, number(between(-3, 3)), number(between(-5, 5)));
        positionAnew();
        for (int i = 0; i < 30; ++i) block();
        if (hasCycles_)
            for (int i = 0; i < 2; ++i) contourCycle();
        line("G1", 40, 2);
        return text_ + "M2\n";
    }

private:
    // The standard distributions differ from library to library; the engine does not.
    double between(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(random_() % 1000003U) / 1000003.0);
    }
    bool chance(double share) { return between(0, 1) < share; }
    int choice(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    /// Rounded to the resolution of a program.
    double rounded(double mm) const { return std::round(mm / unit_mm_ * 1e5) / 1e5 * unit_mm_; }
    double wordOfX(double x_mm) const
    {
        return ((isIncremental_ ? x_mm - x_mm_ : x_mm) * (isDiameter_ ? 2 : 1)) / unit_mm_;
    }
    double wordOfZ(double z_mm) const { return (isIncremental_ ? z_mm - z_mm_ : z_mm) / unit_mm_; }
    static std::string number(double value) { return fmt::format("{:.7f}", value); }

    void block()
    {
        mode();
        const double x_mm = rounded(between(5, 60)), z_mm = rounded(between(-100, 5));
        switch (choice(18)) {
            case 0:
            case 1: return line("G0", x_mm, z_mm);
            case 2:
            case 3: return line("G1", x_mm, z_mm);
            case 4: return line(chance(0.5) ? "g1" : "", x_mm, z_mm);
            case 5: return expression(x_mm, z_mm);
            case 6: return repeated();
            case 7: return whileLoop();
            case 8: return condition(x_mm, z_mm);
            case 9: return call();
            case 10: return arcByRadius(x_mm, z_mm);
            case 11:
            case 12: return arcByCentre();
            case 13: text_ += fmt::format("G4 P{:.2f}\n", between(0, 3)); return;
            case 14: return thread();
            case 15: return shift();
            case 16: return position(x_mm, z_mm);
            default: return manyThreads();
        }
    }

    /// Modal words.
    void mode()
    {
        if (chance(0.12)) text_ += (isDiameter_ = !isDiameter_) ? "G7\n" : "G8\n";
        if (chance(0.12)) text_ += (isIncremental_ = !isIncremental_) ? "G91\n" : "G90\n";
        if (chance(0.06)) {
            unit_mm_ = unit_mm_ > 1 ? 1 : 25.4;
            text_ += unit_mm_ > 1 ? "G20\n" : "G21\n";
        }
        if (chance(0.1)) text_ += fmt::format("F{:.3f}\n", between(0.05, 0.4));
        if (chance(0.08)) text_ += fmt::format("{} F{:.3f}\n", chance(0.5) ? "G94" : "G95", between(0.1, 0.5));
        if (chance(0.08)) text_ += fmt::format("G97 S{:.0f}\n", between(100, 3000));
        if (chance(0.08)) text_ += fmt::format("G96 S{:.0f} D{:.0f}\n", between(80, 300), between(1000, 3000));
    }

    void line(const char* word, double x_mm, double z_mm)
    {
        const bool isModal = *word == '\0';  // the motion before, which is straight
        if (isModal && !isStraight_) word = "G1";
        const bool hasX = chance(0.8), hasZ = !hasX || chance(0.8);
        text_ += word;
        if (hasX) text_ += fmt::format(" X{}", number(wordOfX(x_mm)));
        if (hasZ) text_ += fmt::format(" Z{}", number(wordOfZ(z_mm)));
        text_ += chance(0.1) ? " (a remark)\n" : "\n";
        if (hasX) x_mm_ = x_mm;
        if (hasZ) z_mm_ = z_mm;
        isStraight_ = true;
    }

    /// A rapid move in absolute coordinates, after which the position is known whatever was shifted.
    void positionAnew()
    {
        const bool wasIncremental = isIncremental_;
        isIncremental_ = false;
        x_mm_ = rounded(between(20, 60));
        z_mm_ = rounded(between(-50, 5));
        text_ += fmt::format("G90 G0 X{} Z{}\n", number(wordOfX(x_mm_)), number(wordOfZ(z_mm_)));
        isIncremental_ = wasIncremental;
        if (isIncremental_) text_ += "G91\n";
        isStraight_ = true;
    }

    void expression(double x_mm, double z_mm)
    {
        constexpr std::array functions = {
            "sin[180]",       "[cos[60]-0.5]", "[abs[-2]-2]",         "[sqrt[9]-3]",      "[round[2.4]-2]",
            "[fix[-1.2]+2]",  "[fup[1.2]-2]",  "[7 mod 7]",           "[atan[1]/[1]-45]", "[2**3-8.0]",
            "[exp[0]-1]",     "ln[1]",         "[[1 lt 2] - 1]",      "[[3 ge 3] and 0]", "[asin[1]-90]",
            "[#<share>*6-2]", "[acos[1]]",     "[exists[#<nosuch>]]", "[[1 eq 1] xor 1]", "[8/4/2-1]"};
        text_ += fmt::format("#1={} #<share>=[1/3]\n", number(wordOfZ(z_mm)));
        text_ += fmt::format("G1 X[{}*#<share>*3+{}] Z[#1 - {}]\n", number(wordOfX(x_mm)),
                             functions[static_cast<std::size_t>(choice(20))],
                             functions[static_cast<std::size_t>(choice(20))]);
        x_mm_ = x_mm;
        z_mm_ = z_mm;
        isStraight_ = true;
    }

    /// The position by its variables, which hold a radius.
    void position(double x_mm, double z_mm)
    {
        const double dx_mm = rounded(between(-2, 2)), dz_mm = rounded(between(-2, 2));
        if (isIncremental_) return line("G1", x_mm, z_mm);
        const bool isNamed = chance(0.5);
        text_ += fmt::format("G1 X[{}*{}+{}] Z[{}+{}]\n", isDiameter_ ? 2 : 1, isNamed ? "#<_x>" : "#5420",
                             number(dx_mm * (isDiameter_ ? 2 : 1) / unit_mm_), isNamed ? "#<_z>" : "#5422",
                             number(dz_mm / unit_mm_));
        x_mm_ += dx_mm;
        z_mm_ += dz_mm;
        isStraight_ = true;
    }

    double step_mm() const { return std::round(0.5 / unit_mm_ * 1e5) / 1e5 * unit_mm_; }
    void stepInX()
    {
        text_ += fmt::format("G1 X{}\n", number(step_mm() / unit_mm_ * (isDiameter_ ? 2 : 1)));
        isStraight_ = true;
    }

    void repeated()
    {
        const int times = choice(4), label = ++labels_;
        text_ += fmt::format("G91\no{} repeat [{}]\n", label, times);
        stepInX();
        text_ += fmt::format("o{} endrepeat\n{}\n", label, isIncremental_ ? "G91" : "G90");
        x_mm_ += times * step_mm();
        isStraight_ = false;  // it may have run no move
    }

    void whileLoop()
    {
        const int times = 1 + choice(4), label = ++labels_;
        // rs274 leaves a do loop that follows a break after its first pass, against its manual.
        const int kind = hasBroken_ ? 2 + choice(2) : choice(4);
        hasBroken_ = hasBroken_ || kind == 2;
        text_ += "G91\n#2=0\n";
        text_ += kind == 1 ? fmt::format("o{} do\n", label) : fmt::format("o{} while [#2 lt {}]\n", label, times);
        text_ += "#2=[#2+1]\n";
        if (kind == 2) text_ += fmt::format("o{0} if [#2 eq 3]\no{1} break\no{0} endif\n", ++labels_, label);
        if (kind == 3) text_ += fmt::format("o{0} if [#2 eq 2]\no{1} continue\no{0} endif\n", ++labels_, label);
        stepInX();
        text_ += kind == 1 ? fmt::format("o{} while [#2 lt {}]\n", label, times) : fmt::format("o{} endwhile\n", label);
        text_ += isIncremental_ ? "G91\n" : "G90\n";
        x_mm_ += (kind == 2 ? std::min(times, 2) : kind == 3 && times >= 2 ? times - 1 : times) * step_mm();
    }

    void condition(double x_mm, double z_mm)
    {
        const int label = ++labels_, which = choice(3);
        const std::string good = fmt::format("G1 X{} Z{}\n", number(wordOfX(x_mm)), number(wordOfZ(z_mm)));
        const std::string bad = "G1 X1 Z1\n";
        text_ += fmt::format("#3={}\no{} if [#3 eq 0]\n{}", which, label, which == 0 ? good : bad);
        text_ += fmt::format("o{} elseif [#3 eq 1]\n{}", label, which == 1 ? good : bad);
        text_ += fmt::format("o{0} else\n{1}o{0} endif\n", label, which == 2 ? good : bad);
        x_mm_ = x_mm;
        z_mm_ = z_mm;
        isStraight_ = true;
    }

    void subroutines()
    {
        text_ += "o1 sub\nG91\nG1 X#1 Z[#2*2]\no2 if [#3 gt 0]\no1 return\no2 endif\nG1 Z[0-#2]\no1 endsub\n";
        text_ += "o<out> sub\n#4=[#1+1]\no1 call [#1] [#2] [0]\n#<_times>=[#<_times>+1]\no<out> endsub\n#<_times>=0\n";
    }

    /// Moves by X and 2·Z, and back by Z unless it returns at once.
    void call()
    {
        const double dx_mm = rounded(between(-1, 1)), dz_mm = rounded(between(-2, 2));
        const bool isDirect = chance(0.6), returns = isDirect && chance(0.5);
        text_ += fmt::format("{} call [{}] [{}] [{}]\n{}\n", isDirect ? "o1" : "o<out>",
                             number(dx_mm * (isDiameter_ ? 2 : 1) / unit_mm_), number(dz_mm / unit_mm_),
                             returns ? 1 : 0, isIncremental_ ? "G91" : "G90");
        x_mm_ += dx_mm;
        z_mm_ += (returns ? 2 : 1) * dz_mm;
        isStraight_ = true;
    }

    void arcByRadius(double x_mm, double z_mm)
    {
        const double chord_mm = std::hypot(x_mm - x_mm_, z_mm - z_mm_);
        if (chord_mm < 0.5) return line("G1", x_mm, z_mm);
        const double radius_mm = chord_mm * between(0.51, 3) * (chance(0.3) ? -1 : 1);
        text_ += fmt::format("{} X{} Z{} R{}\n", chance(0.5) ? "G2" : "G3", number(wordOfX(x_mm)),
                             number(wordOfZ(z_mm)), number(radius_mm / unit_mm_));
        x_mm_ = x_mm;
        z_mm_ = z_mm;
        isStraight_ = false;
    }

    /// I along X as a radius, K along Z, from the start; now and then as coordinates.
    void arcByCentre()
    {
        const double radius_mm = between(1, 20), start = between(-3, 3), sweep = between(-3, 3);
        const double centre_x_mm = x_mm_ - radius_mm * std::sin(start);
        const double centre_z_mm = z_mm_ - radius_mm * std::cos(start);
        const double x_mm = centre_x_mm + radius_mm * std::sin(start + sweep);
        const double z_mm = centre_z_mm + radius_mm * std::cos(start + sweep);
        const bool isAbsolute = chance(0.3);
        text_ += fmt::format("{}{} X{} Z{} I{} K{}\n", isAbsolute ? "G90.1\n" : "", chance(0.5) ? "G2" : "G3",
                             number(wordOfX(x_mm)), number(wordOfZ(z_mm)),
                             number((isAbsolute ? centre_x_mm : centre_x_mm - x_mm_) / unit_mm_),
                             number((isAbsolute ? centre_z_mm : centre_z_mm - z_mm_) / unit_mm_));
        if (isAbsolute) text_ += "G91.1\n";
        x_mm_ = x_mm;
        z_mm_ = z_mm;
        isStraight_ = false;
    }

    void thread()
    {
        const double z_mm = rounded(z_mm_ - between(2, 10));
        text_ += fmt::format("G33 Z{} K{:.3f}\n", number(wordOfZ(z_mm)), between(0.5, 3) / unit_mm_);
        z_mm_ = z_mm;
        isStraight_ = false;
    }

    void manyThreads()
    {
        const double z_mm = rounded(z_mm_ - between(8, 20)), side = chance(0.7) ? -1 : 1;
        text_ += fmt::format("G76 P{:.3f} Z{} I{} J{} K{} R{:.1f} Q{:.1f} H{} E{} L{}\n", between(0.5, 3) / unit_mm_,
                             number(wordOfZ(z_mm)), number(side * between(1, 3) / unit_mm_),
                             number(between(0.1, 0.4) / unit_mm_), number(between(0.9, 1.5) / unit_mm_), between(1, 2),
                             between(0, 30), choice(3), number(between(0.5, 2) / unit_mm_), choice(4));
        z_mm_ = z_mm;
        positionAnew();
    }

    void shift()
    {
        const double x = between(-2, 2) / unit_mm_, z = between(-3, 3) / unit_mm_;
        switch (choice(8)) {
            case 0: text_ += fmt::format("G52 X{} Z{}\n", number(x), number(z)); break;
            case 1: text_ += fmt::format("G92 X{} Z{}\n", number(20 / unit_mm_ + x), number(z)); break;
            case 2: text_ += fmt::format("G10 L2 P{} X{} Z{}\n", 1 + choice(6), number(x), number(z)); break;
            case 3: text_ += fmt::format("G10 L20 P{} X{}\n", chance(0.5) ? 0 : 1 + choice(6), number(30 + x)); break;
            case 4: text_ += "G92.1\n"; break;
            case 5: text_ += "G92.2\n"; break;
            case 6: text_ += chance(0.5) ? "G92.3\n" : "G52 X0 Z0\n"; break;
            default: text_ += fmt::format("G{}\n", 54 + choice(6)); break;
        }
        positionAnew();
    }

    /// A contour and one of its cycles.
    void contourCycle()
    {
        isIncremental_ = false;
        text_ += "G90\n";
        const int label = ++labels_;
        const bool isFace = chance(0.4), isBore = chance(0.3), isFlat = chance(0.3);
        // Along the passes falling, across them mostly rising.
        double along_mm = 0, across_mm = rounded(between(4, 12));
        std::string contour = contourBlock("G1", along_mm, across_mm, isFace, isBore, "");
        const int pieces = 2 + choice(5);
        double highest_mm = across_mm;
        for (int i = 0; i < pieces; ++i) {
            const double from_along = along_mm, from_across = across_mm;
            along_mm = rounded(along_mm - (isFlat && i % 2 == 1 ? 0 : between(1, 8)));
            across_mm =
                rounded(std::max(1.0, across_mm + between(chance(0.3) ? -4 : 0, 6) * (isFlat && i % 2 == 0 ? 0 : 1)));
            highest_mm = std::max(highest_mm, across_mm);
            const double chord = std::hypot(along_mm - from_along, across_mm - from_across);
            const bool isArc = chord > 0.5 && along_mm != from_along && chance(0.3);
            const std::string end =
                isArc ? fmt::format(" R{}", number(chord * between(0.75, 2) / unit_mm_)) : std::string();
            contour +=
                contourBlock(isArc ? (chance(0.5) ? "G2" : "G3") : "G1", along_mm, across_mm, isFace, isBore, end);
        }
        text_ += fmt::format("o{0} sub\n{1}o{0} endsub\n", label, contour);
        const auto [x_mm, z_mm] = place(2, highest_mm + 2, isFace, isBore);
        text_ += fmt::format("G0 X{} Z{}\n", number(x_mm * (isDiameter_ ? 2 : 1) / unit_mm_), number(z_mm / unit_mm_));
        const char* pockets = std::array{"", ".1", ".2"}[static_cast<std::size_t>(choice(3))];
        const double left_mm = chance(0.4) ? 0 : between(0.1, 1);
        text_ += fmt::format("G{}{} Q{} D{} I{} R{}", isFace ? 72 : 71, pockets, label, number(left_mm / unit_mm_),
                             number(between(0.5, 3) / unit_mm_), number(between(0.2, 1) / unit_mm_));
        if (chance(0.3))
            text_ += fmt::format(" X{} Z{}", number(x_mm * (isDiameter_ ? 2 : 1) / unit_mm_), number(z_mm / unit_mm_));
        text_ += "\n";
        if (chance(0.5))
            text_ +=
                fmt::format("G70 Q{} X{} Z{} D{} E{} P{}\n", label, number(x_mm * (isDiameter_ ? 2 : 1) / unit_mm_),
                            number(z_mm / unit_mm_), number(between(0.2, 0.8) / unit_mm_),
                            number(chance(0.5) ? 0 : 0.1 / unit_mm_), 1 + choice(3));
        isStraight_ = false;
    }

    /// From along and across the passes to X and Z: a bore lies within, a face along X.
    static std::pair<double, double> place(double along_mm, double across_mm, bool isFace, bool isBore)
    {
        if (isFace) return {along_mm + 60, isBore ? -across_mm : across_mm};
        return {isBore ? 60 - across_mm : across_mm, along_mm};
    }
    std::string contourBlock(const char* word, double along_mm, double across_mm, bool isFace, bool isBore,
                             const std::string& end) const
    {
        const auto [x_mm, z_mm] = place(along_mm, across_mm, isFace, isBore);
        return fmt::format("{} X{} Z{}{}\n", word, number(x_mm * (isDiameter_ ? 2 : 1) / unit_mm_),
                           number(z_mm / unit_mm_), end);
    }

    std::mt19937 random_;
    std::string text_;
    double unit_mm_ = 1, x_mm_ = 0, z_mm_ = 0;
    bool isDiameter_ = true, isIncremental_ = false, isStraight_ = true, hasCycles_ = false, hasBroken_ = false;
    int labels_ = 100;
};

}  // namespace lathelier::gcode
