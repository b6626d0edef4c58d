// Channels of a record: their assignment to signals and the calibration of their probes.
#pragma once

#include <QTableWidget>

#include "engine/io/probe/probe_record.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory_panel {

/// Place, name, unit, range and gain of each channel, the signal it carries, to be chosen, and sensitivity and date of
/// calibration of a probe recorded in volts, to be typed. Writes nothing itself.
class ChannelTable : public QTableWidget {
    Q_OBJECT

public:
    explicit ChannelTable(QWidget* parent = nullptr);

    void setRecord(const io::ProbeRecord* record, const trajectory::TrajectoryParameters& parameters);

signals:
    void mapEdited(const std::string& map);
    void calibrationsEdited(const std::vector<trajectory::ProbeCalibration>& probes);

private:
    void choose(int channel, const QString& signal);
    void showCalibration(int row, const io::ProbeChannel& channel, const trajectory::TrajectoryParameters& parameters);
    void takeCalibration(int row);
    QString signalOf(int row) const;

    std::vector<std::pair<QString, QString>> entries_;  ///< signal with its sign, place or name of a channel
    std::vector<trajectory::ProbeCalibration> calibrations_;
    int channels_ = 0;
};

}  // namespace lathelier::trajectory_panel
