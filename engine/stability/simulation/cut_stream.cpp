#include "engine/stability/simulation/cut_stream.h"

#include <algorithm>
#include <cmath>

namespace lathelier::stability {
namespace {

constexpr double glide_s = 0.03;      ///< time constant of speed and depth
constexpr double crossFade_s = 0.03;  ///< duration of fades between cuts and of the volume
constexpr double steady_s = 0.15;     ///< time constant of the mean deflection
constexpr double loudness_s = 0.05;   ///< time constant of the mean size
constexpr double fullScaleFeeds = 1;  ///< a vibration of this mean size sounds half as loud as the loudest
constexpr double headroom = 0.5;      ///< output level of the loudest pure tone, over full scale

/// Step of a first-order low-pass filter in one sample.
double share(double time_constant_s, double rate_hz)
{
    return -std::expm1(-1 / (time_constant_s * rate_hz));
}

}  // namespace

CutStream::CutStream(const std::vector<Mode>& modes, const StreamParameters& parameters, double sample_rate_hz)
    : wanted_(parameters),
      rate_hz_(sample_rate_hz),
      constants_(modeSteps(modes, 1 / sample_rate_hz, parameters.direction_factor)),
      deflection_(modes.size(), 0.0),
      speed_(modes.size(), 0.0),
      surface_(static_cast<std::size_t>(60 / least_rpm * sample_rate_hz) + 8, 0.0),
      speed_rpm_(std::max(least_rpm, parameters.speed_rpm)),
      depth_mm_(parameters.depth_mm)
{
}

void CutStream::moveTo(double speed_rpm, double depth_mm)
{
    wanted_.speed_rpm = std::max(least_rpm, speed_rpm);
    wanted_.depth_mm = std::max(0.0, depth_mm);
}

/// Approximately normal with standard deviation 1: sum of four uniform numbers.
double CutStream::noise()
{
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        random_ = random_ * 6364136223846793005ULL + 1442695040888963407ULL;
        sum += static_cast<double>(random_ >> 40) / static_cast<double>(1 << 24) - 0.5;
    }
    return sum * std::sqrt(3.0);
}

/// The surface cut `samples` ago, interpolated by a Catmull-Rom spline.
double CutStream::surfaceBefore(double samples) const
{
    const auto size = static_cast<double>(surface_.size());
    const double place = static_cast<double>(now_) + size - std::clamp(samples, 2.0, size - 4);
    const double whole = std::floor(place);
    const double t = place - whole;
    const std::size_t at = static_cast<std::size_t>(whole) + surface_.size() - 1;
    const double a = surface_[at % surface_.size()], b = surface_[(at + 1) % surface_.size()],
                 c = surface_[(at + 2) % surface_.size()], d = surface_[(at + 3) % surface_.size()];
    return b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

void CutStream::fill(std::span<float> samples)
{
    const double glide = share(glide_s, rate_hz_), settle = share(steady_s, rate_hz_);
    const double feed = wanted_.feed_mm_rev;
    const std::size_t modes = deflection_.size();
    for (float& sample : samples) {
        speed_rpm_ += glide * (wanted_.speed_rpm - speed_rpm_);
        depth_mm_ += glide * (wanted_.depth_mm - depth_mm_);
        const double stiffness = wanted_.cutting_coefficient_N_mm2 * depth_mm_;
        double x = 0;
        for (std::size_t m = 0; m < modes; ++m) {
            const ModeStep& c = constants_.modes[m];
            const double q = deflection_[m], u = speed_[m];
            deflection_[m] = c.qq * q + c.qv * u + c.q0 * force_;
            speed_[m] = c.vq * q + c.vv * u + c.v0 * force_;
            x += deflection_[m] + c.lag_s * speed_[m];
        }
        const double wave = surfaceBefore(60 * rate_hz_ / speed_rpm_);
        const double uneven = feed * (1 + 0.01 * wanted_.noise_percent * noise());
        force_ = stiffness * (uneven + wave - x) / (1 + stiffness * constants_.q1);
        const bool cuts = uneven + wave - (x + constants_.q1 * force_) > 0;
        if (!cuts) force_ = 0;
        for (std::size_t m = 0; m < modes; ++m) {
            deflection_[m] += constants_.modes[m].q1 * force_;
            speed_[m] += constants_.modes[m].v1 * force_;
        }
        x += constants_.q1 * force_;
        surface_[now_] = cuts ? x : wave + feed;
        now_ = now_ + 1 == surface_.size() ? 0 : now_ + 1;
        steady_ += settle * (x - steady_);
        sample = static_cast<float>((x - steady_) / feed);
    }
}

void CutSound::take(const std::vector<Mode>& modes, const StreamParameters& parameters)
{
    constexpr std::size_t mostVoices = 4;  // for rapid changes; the oldest voices are nearly silent
    if (streams_.size() == mostVoices) streams_.erase(streams_.begin());
    streams_.push_back({CutStream(modes, parameters, rate_hz_)});
}

void CutSound::moveTo(double speed_rpm, double depth_mm)
{
    if (!streams_.empty()) streams_.back().stream.moveTo(speed_rpm, depth_mm);
}

void CutSound::fill(std::span<float> samples, double volume)
{
    std::fill(samples.begin(), samples.end(), 0.0F);
    const double fade = 1 / (crossFade_s * rate_hz_);
    part_.resize(samples.size());
    for (std::size_t v = 0; v < streams_.size(); ++v) {
        Voice& voice = streams_[v];
        const double step = v + 1 == streams_.size() ? fade : -fade;
        voice.stream.fill(part_);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            voice.share = std::clamp(voice.share + step, 0.0, 1.0);
            samples[i] += static_cast<float>(voice.share) * part_[i];
        }
    }
    while (streams_.size() > 1 && streams_.front().share <= 0) streams_.erase(streams_.begin());
    const double follow = share(loudness_s, rate_hz_);
    volume = std::clamp(volume, 0.0, 1.0);
    for (float& sample : samples) {
        volume_ += std::clamp(volume - volume_, -fade, fade);
        const auto size = static_cast<double>(sample);
        loud_ += follow * (std::abs(size) - loud_);
        const double heard = size / (fullScaleFeeds + loud_);
        sample = static_cast<float>(volume_ * headroom * heard / std::sqrt(1 + 0.25 * heard * heard));
    }
}

}  // namespace lathelier::stability
