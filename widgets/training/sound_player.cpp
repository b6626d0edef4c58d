#include "widgets/training/sound_player.h"

#include <QAudioDeviceInfo>
#include <QAudioFormat>
#include <QAudioOutput>
#include <QIODevice>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <mutex>

namespace lathelier::training_panel {
namespace {

constexpr int rate_hz = 44100;
constexpr int buffer_ms = 60;
constexpr int soundBeat_ms = 40;
constexpr double fullScale = 32767;

QAudioFormat formatOf()
{
    QAudioFormat format;
    format.setSampleRate(rate_hz);
    format.setChannelCount(1);
    format.setSampleSize(16);
    format.setCodec("audio/pcm");
    format.setByteOrder(QAudioFormat::LittleEndian);
    format.setSampleType(QAudioFormat::SignedInt);
    return format;
}

}  // namespace

/// What the device reads: as many samples as it asks for. Some systems ask from a thread of their own.
class SoundPlayer::Source : public QIODevice {
public:
    Source() { open(QIODevice::ReadOnly); }

    std::mutex mutex;
    stability::CutSound sound{rate_hz};
    double volume = 0.3;
    double level = 0;
    double heard_s = 0;

    void make(std::span<float> samples)
    {
        const std::scoped_lock lock(mutex);
        sound.fill(samples, volume);
        double largest = 0;
        for (const float sample : samples) largest = std::max(largest, static_cast<double>(std::abs(sample)));
        level = std::max(largest, 0.7 * level);
        if (sound.hasCut()) heard_s += static_cast<double>(samples.size()) / rate_hz;
    }
    bool isSequential() const override { return true; }
    qint64 bytesAvailable() const override { return qint64{2} * rate_hz + QIODevice::bytesAvailable(); }

protected:
    qint64 readData(char* data, qint64 most) override
    {
        std::array<float, 1024> part{};
        qint64 done = 0;
        while (done + 2 <= most) {
            const auto count = std::min<std::size_t>(part.size(), static_cast<std::size_t>((most - done) / 2));
            make({part.data(), count});
            for (std::size_t i = 0; i < count; ++i, done += 2) {
                const auto value = static_cast<std::int16_t>(std::lround(fullScale * static_cast<double>(part[i])));
                const auto bits = static_cast<std::uint16_t>(value);
                data[done] = static_cast<char>(bits & 0xff);
                data[done + 1] = static_cast<char>(bits >> 8);
            }
        }
        return done;
    }
    qint64 writeData(const char*, qint64) override { return -1; }
};

struct SoundPlayer::Device {
    QAudioOutput output;
};

SoundPlayer::SoundPlayer(QObject* parent) : QObject(parent), source_(std::make_unique<Source>())
{
    beat_.setInterval(soundBeat_ms);
    connect(&beat_, &QTimer::timeout, this, &SoundPlayer::pull);
}

SoundPlayer::~SoundPlayer()
{
    if (device_) device_->output.stop();
}

bool SoundPlayer::hasDevice()
{
    return !QAudioDeviceInfo::defaultOutputDevice().isNull();
}

void SoundPlayer::setCut(const std::vector<stability::Mode>& modes, const stability::StreamParameters& parameters)
{
    const std::scoped_lock lock(source_->mutex);
    source_->sound.take(modes, parameters);
}

void SoundPlayer::moveTo(double speed_rpm, double depth_mm)
{
    const std::scoped_lock lock(source_->mutex);
    source_->sound.moveTo(speed_rpm, depth_mm);
}

void SoundPlayer::setOn(bool on)
{
    if (on == on_) return;
    on_ = on;
    if (on) {
        if (hasDevice()) {
            device_ = std::unique_ptr<Device>(new Device{QAudioOutput(formatOf())});
            device_->output.setBufferSize(2 * rate_hz * buffer_ms / 1000);
            device_->output.start(source_.get());
        }
        beat_.start();
        return;
    }
    if (device_) device_->output.stop();
    device_.reset();
    beat_.stop();
    emit levelChanged(0);
}

double SoundPlayer::volume() const
{
    return source_->volume;
}

void SoundPlayer::setVolume(double volume)
{
    const std::scoped_lock lock(source_->mutex);
    source_->volume = std::clamp(volume, 0.0, loudest);
}

double SoundPlayer::level() const
{
    const std::scoped_lock lock(source_->mutex);
    return source_->level;
}

double SoundPlayer::heard_s() const
{
    const std::scoped_lock lock(source_->mutex);
    return source_->heard_s;
}

void SoundPlayer::resetHeard()
{
    const std::scoped_lock lock(source_->mutex);
    source_->heard_s = 0;
}

/// Nobody asks for samples without a device, or where it does not work: the beat takes them instead.
void SoundPlayer::pull()
{
    const bool plays = device_ && device_->output.error() == QAudio::NoError;
    if (!plays) {
        std::vector<float> samples(static_cast<std::size_t>(rate_hz * soundBeat_ms / 1000));
        source_->make(samples);
    }
    emit levelChanged(level());
}

}  // namespace lathelier::training_panel
