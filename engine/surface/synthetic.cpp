#include "engine/surface/synthetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/report/png.h"
#include "engine/surface/picture_kernel.h"

namespace lathelier::surface {
namespace {

using std::numbers::pi;
enum Stream : std::uint64_t { TrackDepth = 1, GrooveLight = 2, PixelNoise = 3 };

using Direction = std::array<double, 3>;  // along the axis, across it, toward the camera

Direction normalized(const Direction& v)
{
    const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / size, v[1] / size, v[2] / size};
}

double scalarProduct(const Direction& a, const Direction& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

constexpr double largestDeviate = 9;  // of a normal generator with 53 bits

/// Normal deviates of one seed. Neighbouring pixels ask for the same ones: the last of each slot is kept. For one
/// thread.
class Deviates {
public:
    explicit Deviates(std::uint64_t seed) : seed_(seed), kept_(4096) {}

    /// Deviates at integer `place`, smoothly interpolated; one sequence per `index`.
    double smooth(std::uint64_t stream, std::int64_t index, double place)
    {
        const double cell = std::floor(place);
        const double t = place - cell, weight = t * t * (3 - 2 * t);
        const std::uint64_t sequence = stream * 1000003 + static_cast<std::uint64_t>(index + 500000);
        const auto at = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell) + 500000);
        return (1 - weight) * deviate(sequence, at) + weight * deviate(sequence, at + 1);
    }

private:
    struct Kept {
        std::uint64_t sequence = ~std::uint64_t{0}, at = 0;
        double deviate = 0;
    };

    double deviate(std::uint64_t sequence, std::uint64_t at)
    {
        Kept& kept = kept_[(sequence * 64 + at) % kept_.size()];
        if (kept.sequence != sequence || kept.at != at) kept = {sequence, at, randomNormal(seed_, sequence, at)};
        return kept.deviate;
    }

    std::uint64_t seed_;
    std::vector<Kept> kept_;
};

/// Slopes and groove brightness of the surface.
class TurnedSurface {
public:
    explicit TurnedSurface(const SyntheticParameters& p)
        : p_(p),
          round_mm_(pi * p.diameter_mm),
          amplitude_mm_(p.amplitude_um * 1e-3),
          depth_mm_(p.feed_mm_rev * p.feed_mm_rev / (8 * p.nose_radius_mm) * p.irregular),
          waves_(p.frequency_hz / (p.speed_rpm / 60)),
          reach_(2 + static_cast<int>(
                         std::sqrt(1 + 2 * amplitude_mm_ * 8 * p.nose_radius_mm / (p.feed_mm_rev * p.feed_mm_rev))))
    {
    }

    /// dh/dz and dh/dy of the lowest track at (z, y), both in mm.
    std::array<double, 2> slopes(double z, double y, Deviates& deviates) const
    {
        const double turn = y / round_mm_;
        const auto middle = static_cast<std::int64_t>(std::lround(z / p_.feed_mm_rev - turn));
        double lowest = 1e300;
        std::array<double, 2> found{};
        for (std::int64_t step = 0; step <= 2 * reach_; ++step) {  // the nearest tracks first
            const std::int64_t track = middle + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
            const double revolutions = static_cast<double>(track) + turn;
            const double from_nose = z - p_.feed_mm_rev * revolutions;
            const double nose = from_nose * from_nose / (2 * p_.nose_radius_mm);
            if (nose - amplitude_mm_ - largestDeviate * depth_mm_ >= lowest) continue;
            const double phase = 2 * pi * waves_ * revolutions;
            const double smooth = nose + amplitude_mm_ * std::sin(phase);
            if (smooth - largestDeviate * depth_mm_ >= lowest) continue;
            const double height = smooth + depth_mm_ * deviates.smooth(TrackDepth, track, 4 * turn);
            if (height >= lowest) continue;
            lowest = height;
            const double along_z = from_nose / p_.nose_radius_mm;
            found = {along_z, -along_z * p_.feed_mm_rev / round_mm_ +
                                  amplitude_mm_ * std::cos(phase) * 2 * pi * waves_ / round_mm_};
        }
        return found;
    }

    double grooves(double z, double y, Deviates& deviates) const
    {
        if (p_.grooves <= 0) return 0;
        const double across = (z - p_.feed_mm_rev * y / round_mm_) / (1.5 * p_.mm_per_px);
        const auto cell = static_cast<std::int64_t>(std::floor(across));
        const double t = across - static_cast<double>(cell);
        const double along = y / 3.0;
        return p_.grooves * ((1 - t) * deviates.smooth(GrooveLight, cell, along) +
                             t * deviates.smooth(GrooveLight, cell + 1, along));
    }

private:
    const SyntheticParameters& p_;
    double round_mm_, amplitude_mm_, depth_mm_, waves_;
    std::int64_t reach_;
};

/// Brightness of a surface element under all light sources.
class Lamps {
public:
    explicit Lamps(const SyntheticParameters& p)
    {
        const double e = p.elevation_deg * pi / 180;
        const auto add = [&](double azimuth_deg) {
            const double a = azimuth_deg * pi / 180;
            const Direction lamp{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
            lamps_.push_back(lamp);
            halves_.push_back(normalized({lamp[0], lamp[1], lamp[2] + 1}));
        };
        switch (p.light) {
            case Light::AlongFeed: add(0); break;
            case Light::AcrossFeed: add(90); break;
            case Light::Oblique: add(40); break;
            case Light::Ring:
                for (int i = 0; i < 8; ++i) add(45.0 * i);
                break;
        }
    }

    double brightness(const Direction& normal) const
    {
        constexpr double ambient = 0.08, diffuse = 0.25, gloss = 0.75, sharpness = 30;
        double sum = 0;
        for (std::size_t i = 0; i < lamps_.size(); ++i)
            sum += diffuse * std::max(0.0, scalarProduct(normal, lamps_[i])) +
                   gloss * std::pow(std::max(0.0, scalarProduct(normal, halves_[i])), sharpness);
        return ambient + sum / static_cast<double>(lamps_.size());
    }

private:
    std::vector<Direction> lamps_, halves_;
};

constexpr int sub = 2;  // samples of a pixel in each direction

/// The picture before optics and camera.
Grid renderedPicture(const SyntheticParameters& p, const Progress& progress)
{
    const TurnedSurface surface(p);
    const Lamps lamps(p);
    const double radius = 0.5 * p.diameter_mm;
    const double hand = p.cut == CutDirection::Up ? -1 : 1;
    const Vector along = turned({1, 0}, p.feed_direction_deg), across = turned({0, hand}, p.feed_direction_deg);
    Grid picture(p.width, p.height);
    const auto brightness = [&](double x, double y, Deviates& deviates) {
        const Vector from{(x - 0.5 * p.width) * p.mm_per_px, (y - 0.5 * p.height) * p.mm_per_px};
        const double z = dot(from, along);
        double round = dot(from, across), tilt = 0;
        if (p.cylinder) {
            if (std::abs(round) >= radius) return 0.02;
            tilt = std::asin(round / radius);
            round = radius * tilt;
        }
        const auto [slope_z, slope_y] = surface.slopes(z, round, deviates);
        const Direction normal = normalized(
            {-slope_z, -slope_y * std::cos(tilt) + std::sin(tilt), std::cos(tilt) + slope_y * std::sin(tilt)});
        return lamps.brightness(normal) * std::max(0.2, 1 + surface.grooves(z, round, deviates));
    };
    parallelFor(static_cast<std::size_t>(p.height), 8, progress, [&](std::size_t begin, std::size_t end) {
        Deviates deviates(static_cast<std::uint64_t>(p.seed));
        for (std::size_t y = begin; y < end; ++y)
            for (int x = 0; x < p.width; ++x) {
                double sum = 0;
                for (int i = 0; i < sub; ++i)
                    for (int k = 0; k < sub; ++k)
                        sum += brightness(x + (i + 0.5) / sub, static_cast<double>(y) + (k + 0.5) / sub, deviates);
                picture.row(static_cast<int>(y))[x] = static_cast<float>(sum / (sub * sub));
            }
    });
    return picture;
}

/// Draws the word in a 5 × 7 bitmap font; each row of a letter is five bits.
void stamp(io::Image& image)
{
    constexpr std::string_view word = "SYNTHETIC";
    constexpr std::array<std::array<std::uint8_t, 7>, 9> letters{{{15, 16, 16, 14, 1, 1, 30},
                                                                  {17, 17, 10, 4, 4, 4, 4},
                                                                  {17, 25, 21, 19, 17, 17, 17},
                                                                  {31, 4, 4, 4, 4, 4, 4},
                                                                  {17, 17, 17, 31, 17, 17, 17},
                                                                  {31, 16, 16, 30, 16, 16, 31},
                                                                  {31, 4, 4, 4, 4, 4, 4},
                                                                  {14, 4, 4, 4, 4, 4, 14},
                                                                  {15, 16, 16, 16, 16, 16, 15}}};
    const int dot_px = std::max(1, static_cast<int>(std::sqrt(double(image.width) * image.height) / 400));
    const int height_px = 9 * dot_px, width_px = static_cast<int>(word.size() * 6 + 1) * dot_px;
    for (int y = 0; y < height_px; ++y)
        for (int x = 0; x < width_px && x < image.width; ++x) {
            const int letter = (x / dot_px - 1) / 6, column = (x / dot_px - 1) % 6, row = y / dot_px - 1;
            const bool inside = x >= dot_px && row >= 0 && row < 7 && column < 5 && letter < 9;
            const bool lit =
                inside &&
                (letters[static_cast<std::size_t>(letter)][static_cast<std::size_t>(row)] >> (4 - column) & 1) != 0;
            const auto at =
                static_cast<std::size_t>(image.height - height_px + y) * static_cast<std::size_t>(image.width);
            image.grey[at + static_cast<std::size_t>(x)] = lit ? 1.0F : 0.0F;
        }
}

}  // namespace

io::Image syntheticPicture(const SyntheticParameters& p, const Progress& progress)
{
    Grid picture = renderedPicture(p, progress);
    if (p.blur_px > 0) pictureKernel().blur(picture, p.blur_px);
    io::Image image;
    image.format = "png";
    image.width = p.width;
    image.height = p.height;
    image.bits = p.bits;
    const double levels = p.bits == 16 ? 65535 : 255;
    image.grey.resize(static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height));
    for (std::size_t i = 0; i < image.grey.size(); ++i) {
        const double clean = double(picture.values[i]);
        const double noisy = clean + p.noise * randomNormal(static_cast<std::uint64_t>(p.seed), PixelNoise, i);
        image.grey[i] = static_cast<float>(std::round(std::clamp(noisy, 0.0, 1.0) * levels) / levels);
    }
    if (p.stamped) stamp(image);
    return image;
}

std::string syntheticPng(const io::Image& image)
{
    report::GreyImage grey{image.width, image.height, image.bits > 8 ? 16 : 8, {}, "SYNTHETIC"};
    const float levels = grey.bits == 16 ? 65535.0F : 255.0F;
    grey.samples.reserve(image.grey.size());
    for (const float value : image.grey)
        grey.samples.push_back(static_cast<std::uint16_t>(std::lround(value * levels)));
    return report::encodePng(grey);
}

const std::vector<Field<SyntheticParameters>>& fieldsOf(const SyntheticParameters*)
{
    using P = SyntheticParameters;
    static const std::vector<Field<P>> all{
        field("diameter_mm", &P::diameter_mm, {1, 1000},
              {LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "Of the turned part."), unit::mm}),
        field("feed_mm_rev", &P::feed_mm_rev, {0.005, 2},
              {LT_TEXT("Engine", "Feed"), LT_TEXT("Engine", "Of the tool in a revolution."), unit::mm_rev}),
        field("nose_radius_mm", &P::nose_radius_mm, {0.05, 10},
              {LT_TEXT("Engine", "Nose radius"), LT_TEXT("Engine", "Of the tool."), unit::mm}),
        field("speed_rpm", &P::speed_rpm, {10, 20000},
              {LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "While the surface was cut."),
               LT_TEXT("Engine", "rpm")}),
        field("frequency_hz", &P::frequency_hz, {1, 10000},
              {LT_TEXT("Engine", "Vibration"), LT_TEXT("Engine", "Its frequency."), unit::hz}),
        field("amplitude_um", &P::amplitude_um, {0, 200},
              {LT_TEXT("Engine", "Amplitude"), LT_TEXT("Engine", "Of the vibration; 0: none."), unit::um}),
        field("feed_direction_deg", &P::feed_direction_deg, {-180, 180},
              {LT_TEXT("Engine", "Direction of feed"), LT_TEXT("Engine", "In the picture, from right toward down."),
               unit::deg}),
        field("mm_per_px", &P::mm_per_px, {0.0005, 1},
              {LT_TEXT("Engine", "Scale"), LT_TEXT("Engine", "Of the picture."), LT_TEXT("Engine", "mm/px")}),
        field("cylinder", &P::cylinder,
              {LT_TEXT("Engine", "Whole width"), LT_TEXT("Engine", "The part is seen as a cylinder.")}),
        field("light", &P::light,
              {{"along_feed", LT_TEXT("Engine", "along the feed")},
               {"across_feed", LT_TEXT("Engine", "along the grooves")},
               {"oblique", LT_TEXT("Engine", "oblique")},
               {"ring", LT_TEXT("Engine", "all round")}},
              {LT_TEXT("Engine", "Light"), LT_TEXT("Engine", "Where it comes from.")}),
        field("irregular", &P::irregular, {0, 1},
              {LT_TEXT("Engine", "Irregular tracks"),
               LT_TEXT("Engine", "Spread of their depths as a share of the depth of a feed mark.")}),
        field("noise", &P::noise, {0, 0.5},
              {LT_TEXT("Engine", "Noise"), LT_TEXT("Engine", "Of the camera, as a share of full scale.")}),
        field("seed", &P::seed, {0, 1000000},
              {LT_TEXT("Engine", "Seed"), LT_TEXT("Engine", "Start of the random numbers.")}),
    };
    return all;
}

}  // namespace lathelier::surface
