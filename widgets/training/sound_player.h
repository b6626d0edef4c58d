// Plays a cut while it is simulated, sample by sample. Without a device the samples are made and thrown away, so that
// meter and seconds go on.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "engine/stability/simulation/cut_stream.h"

namespace lathelier::training_panel {

class SoundPlayer : public QObject {
    Q_OBJECT

public:
    static constexpr double loudest = 0.7;  ///< volume at most: a class sits before it

    explicit SoundPlayer(QObject* parent = nullptr);
    ~SoundPlayer() override;

    static bool hasDevice();

    /// Another part: fades over. Nothing is played before the first one.
    void setCut(const std::vector<stability::Mode>& modes, const stability::StreamParameters& parameters);
    void moveTo(double speed_rpm, double depth_mm);

    bool isOn() const { return on_; }
    void setOn(bool on);    ///< off at first
    double volume() const;  ///< of 0 to `loudest`
    void setVolume(double volume);
    double level() const;    ///< largest size of the last samples, of 0 to 1
    double heard_s() const;  ///< seconds that were played since the part was set or resetHeard()
    void resetHeard();

signals:
    void levelChanged(double level);

private:
    class Source;
    void pull();

    std::unique_ptr<Source> source_;
    struct Device;
    std::unique_ptr<Device> device_;  ///< null: none, or off
    QTimer beat_;
    bool on_ = false;
};

}  // namespace lathelier::training_panel
