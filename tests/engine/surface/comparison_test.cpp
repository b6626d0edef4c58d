// Two pictures of one surface are registered; those of two cuts are not. Equal results from 16 bits and from a reduced
// picture.
#include "engine/surface/picture_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/surface/surface_words.h"
#include "tests/engine/surface/pictures.h"

namespace lathelier::surface {
namespace {

using namespace test;

io::Image cutOut(const io::Image& image, int left, int top, int width, int height)
{
    io::Image part = image;
    part.width = width;
    part.height = height;
    part.grey.clear();
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x) part.grey.push_back(image.at(x, y));
    return part;
}

double difference(const Grid& a, const Grid& b)
{
    double sum = 0;
    int count = 0;
    for (int y = a.rows / 4; y < 3 * a.rows / 4; ++y)
        for (int x = a.columns / 4; x < 3 * a.columns / 4; ++x, ++count)
            sum += std::pow(double(a.at(x, y)) - double(b.at(x, y)), 2);
    return std::sqrt(sum / count);
}

TEST(Comparison, OneSurfaceIsLaidOverItself)
{
    SyntheticParameters truth = smallField(3);
    truth.feed_direction_deg = 0;
    truth.irregular = 0.2;
    truth.grooves = 0.3;
    const io::Image whole = syntheticPicture(truth);
    const NamedImage first{"a", cutOut(whole, 0, 0, 600, 450)}, second{"b", cutOut(whole, 37, 12, 600, 450)};
    const SurfaceResult result = findSurfaceMarks({first, second}, known(truth));
    ASSERT_TRUE(result.comparison && result.comparison->registered);
    // What lies at x in the first lies at x - 37 in the second.
    EXPECT_NEAR(result.comparison->shift.x, -37, 1);
    EXPECT_NEAR(result.comparison->shift.y, -12, 1);
    const AlignedPictures apart = aligned(result.images), laid = aligned(result.images, result.comparison->shift);
    EXPECT_LT(difference(laid.pictures[0], laid.pictures[1]), 0.4 * difference(apart.pictures[0], apart.pictures[1]));
}

io::Image smaller(const io::Image& image, double factor)
{
    Grid grid(image.width, image.height);
    grid.values = image.grey;
    Grid out(static_cast<int>(image.width * factor), static_cast<int>(image.height * factor));
    for (int y = 0; y < out.rows; ++y)
        for (int x = 0; x < out.columns; ++x) {  // linear between the pixels
            const double sx = (x + 0.5) / factor - 0.5, sy = (y + 0.5) / factor - 0.5;
            const int x0 = std::min(static_cast<int>(sx), image.width - 2);
            const int y0 = std::min(static_cast<int>(sy), image.height - 2);
            const double u = sx - x0, v = sy - y0;
            out.row(y)[x] =
                static_cast<float>((1 - v) * ((1 - u) * double(grid.at(x0, y0)) + u * double(grid.at(x0 + 1, y0))) +
                                   v * ((1 - u) * double(grid.at(x0, y0 + 1)) + u * double(grid.at(x0 + 1, y0 + 1))));
        }
    io::Image result = image;
    result.width = out.columns;
    result.height = out.rows;
    result.grey = out.values;
    return result;
}

TEST(SameAnswer, OfAPictureMadeSmaller)
{
    SyntheticParameters truth = overview(6);
    truth.mm_per_px = 0.02;  // 10 px for a feed
    truth.height = 1320;
    truth.amplitude_um = 2.5 * theoreticalDepth_um(truth);
    const io::Image picture = syntheticPicture(truth);
    const ImageMarks plain = marksOf(picture, known(truth));
    SurfaceParameters p = known(truth);
    *p.mm_per_px /= 0.7;
    const ImageMarks small = marksOf(smaller(picture, 0.7), p);
    ASSERT_TRUE(plain.chatter_marks && small.chatter_marks);
    EXPECT_NEAR(*small.chatter_marks->frequency_hz, *plain.chatter_marks->frequency_hz, 0.2);
    EXPECT_EQ(small.chatter_marks->m_certain, plain.chatter_marks->m_certain);
    EXPECT_NEAR(*small.feed_marks->pitch_mm, *plain.feed_marks->pitch_mm, 1e-3 * *plain.feed_marks->pitch_mm);
}

TEST(SameAnswer, OfChatterInSixteenBits)
{
    SyntheticParameters truth = smallField(5);
    truth.amplitude_um = 2.5 * theoreticalDepth_um(truth);
    const ImageMarks eight = marksOf(syntheticPicture(truth), known(truth));
    truth.bits = 16;
    const io::Image fine = syntheticPicture(truth);
    const io::Image read = io::readImage("a.png", syntheticPng(fine));  // and through the file
    EXPECT_EQ(read.bits, 16);
    const ImageMarks sixteen = marksOf(read, known(truth));
    ASSERT_TRUE(eight.chatter_marks && sixteen.chatter_marks);
    EXPECT_EQ(sixteen.bits, 16);
    EXPECT_NEAR(sixteen.chatter_marks->nu, eight.chatter_marks->nu, 1e-3);
    EXPECT_EQ(sixteen.verdict, eight.verdict);
    EXPECT_EQ(sixteen.chatter_marks->m, eight.chatter_marks->m);
}

}  // namespace
}  // namespace lathelier::surface
