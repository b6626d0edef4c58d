// Pictures without anything periodic: none may be found. Three of each kind here; LATHELIER_NOISE=20 makes as many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "tests/engine/surface/jpeg.h"
#include "tests/engine/surface/pictures.h"

namespace lathelier::surface {
namespace {

constexpr int side = 384;

/// Brightness as it is made, mean 0, spread about 1.
using Brightness = std::vector<double>;

Brightness white(std::uint64_t seed, std::uint64_t stream)
{
    Brightness field(side * side);
    for (std::size_t i = 0; i < field.size(); ++i) field[i] = randomNormal(seed, stream, i);
    return field;
}

double& at(Brightness& field, int x, int y)
{
    return field[static_cast<std::size_t>((y + side) % side * side + (x + side) % side)];
}

void normalize(Brightness& field)
{
    double sum = 0, squares = 0;
    for (const double v : field) sum += v, squares += v * v;
    const double mean = sum / double(field.size()), spread = std::sqrt(squares / double(field.size()) - mean * mean);
    for (double& v : field) v = (v - mean) / spread;
}

/// Exponential smoothing forth and back along x or y, twice round.
void smooth(Brightness& field, bool along_x, double length)
{
    const double keep = std::exp(-1 / length);
    for (int line = 0; line < side; ++line)
        for (const int sign : {1, -1}) {
            double value = 0;
            for (int i = 0; i < 2 * side; ++i) {
                const int place = (sign > 0 ? i : 2 * side - 1 - i) % side;
                double& cell = along_x ? at(field, place, line) : at(field, line, place);
                value = keep * value + (1 - keep) * cell;
                if (i >= side) cell = value;
            }
        }
    normalize(field);
}

/// Sums of smooth fields of all widths: about 1/f, or 1/f² with growing weights.
Brightness coloured(std::uint64_t seed, double growth)
{
    Brightness sum(side * side, 0.0);
    double weight = 1;
    for (int octave = 0; octave < 5; ++octave, weight *= growth) {
        Brightness part = white(seed, static_cast<std::uint64_t>(octave) + 10);
        if (octave > 0) {
            smooth(part, true, std::pow(2.2, octave));
            smooth(part, false, std::pow(2.2, octave));
        }
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * part[i];
    }
    normalize(sum);
    return sum;
}

/// Random lines along a direction, each of its own brightness over a width of about a pixel.
Brightness grooves(std::uint64_t seed, double tilt_deg, double length)
{
    Brightness field(side * side);
    const double c = std::cos(tilt_deg * std::numbers::pi / 180), s = std::sin(tilt_deg * std::numbers::pi / 180);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double across = (c * x - s * y + 1000) / 1.6, along = (s * x + c * y + 1000) / length;
            double value = 0;
            for (int i = 0; i < 2; ++i)
                for (int k = 0; k < 2; ++k) {
                    const double u = std::floor(across) + i, v = std::floor(along) + k;
                    value += (1 - std::abs(across - u)) * (1 - std::abs(along - v)) *
                             randomNormal(seed, static_cast<std::uint64_t>(v) + 100, static_cast<std::uint64_t>(u));
                }
            at(field, x, y) = value;
        }
    normalize(field);
    return field;
}

struct Kind {
    const char* name;
    Brightness (*make)(std::uint64_t seed);
    int jpeg_quality = 0;  ///< 0: not through a JPEG file
};

const std::vector<Kind>& kinds()
{
    static const std::vector<Kind> all{
        {"white", [](std::uint64_t s) { return white(s, 1); }},
        {"1/f", [](std::uint64_t s) { return coloured(s, 1.4); }},
        {"1/f2", [](std::uint64_t s) { return coloured(s, 2.5); }},
        {"blurred",
         [](std::uint64_t s) {
             Brightness f = white(s, 1);
             smooth(f, true, 1.5);
             smooth(f, false, 1.5);
             return f;
         }},
        {"grooves", [](std::uint64_t s) { return grooves(s, 0, 300); }},
        {"tilted grooves", [](std::uint64_t s) { return grooves(s, 17, 300); }},
        {"ground",
         [](std::uint64_t s) {
             Brightness f = grooves(s, 3, 40);
             const Brightness w = white(s, 7);
             for (std::size_t i = 0; i < f.size(); ++i) f[i] += 0.5 * w[i];
             return f;
         }},
        {"JPEG 50", [](std::uint64_t s) { return coloured(s, 1.4); }, 50},
        {"JPEG 75", [](std::uint64_t s) { return coloured(s, 1.4); }, 75},
        {"JPEG 90", [](std::uint64_t s) { return coloured(s, 1.4); }, 90},
        {"row noise",
         [](std::uint64_t s) {
             Brightness f = white(s, 1);
             for (int y = 0; y < side; ++y)
                 for (int x = 0; x < side; ++x) at(f, x, y) += 0.5 * randomNormal(s, 8, static_cast<std::uint64_t>(y));
             return f;
         }},
        {"demosaiced",
         [](std::uint64_t s) {
             Brightness f = coloured(s, 1.4);
             const Brightness w = white(s, 9);
             for (int y = 0; y < side; ++y)
                 for (int x = 0; x < side; ++x)  // every second pixel is the mean of its neighbours
                     at(f, x, y) += (x + y) % 2 == 0 ? w[static_cast<std::size_t>(y * side + x)]
                                                     : 0.5 * w[static_cast<std::size_t>(y * side + (x + 1) % side)];
             return f;
         }},
        {"scale bar",
         [](std::uint64_t s) {
             Brightness f = coloured(s, 1.4);
             for (int y = 350; y < 356; ++y)
                 for (int x = 240; x < 350; ++x) at(f, x, y) = 4;
             return f;
         }},
        {"highlight", [](std::uint64_t s) {
             Brightness f = coloured(s, 1.4);
             for (int y = 0; y < side; ++y)
                 for (int x = 0; x < side; ++x) at(f, x, y) += 3 * std::exp(-std::pow((x - 130) / 35.0, 2));
             return f;
         }}};
    return all;
}

TEST(SurfaceNoise, FourteenKindsRaiseNoAlarm)
{
    const char* asked = std::getenv("LATHELIER_NOISE");
    const int count = asked ? std::atoi(asked) : 3;
    ASSERT_GT(count, 0);
    ASSERT_EQ(kinds().size(), 14U);
    for (const Kind& kind : kinds()) {
        double largest = 0;
        for (int i = 0; i < count; ++i) {
            const Brightness field = kind.make(static_cast<std::uint64_t>(1000 + i));
            io::Image image;
            image.width = image.height = side;
            for (const double v : field)
                image.grey.push_back(static_cast<float>(std::round(255 * std::clamp(0.45 + 0.11 * v, 0.0, 1.0)) / 255));
            if (kind.jpeg_quality > 0) image = io::readImage("a.jpg", test::jpegFile(image, kind.jpeg_quality));
            SurfaceParameters p;
            p.feed_mm_rev = 0.1;
            p.diameter_mm = 30;
            p.mm_per_px = 0.006;
            const ImageMarks marks = test::marksOf(image, p);
            EXPECT_EQ(marks.verdict, MarksVerdict::NoPeriodicMarks)
                << kind.name << " " << i << ": S " << marks.largest_significance << " T " << marks.threshold;
            largest = std::max(largest, marks.largest_significance);
        }
        RecordProperty(std::string("largest ") + kind.name, std::to_string(largest));
        if (asked) std::printf("%-15s largest S %.1f\n", kind.name, largest);
    }
}

}  // namespace
}  // namespace lathelier::surface
