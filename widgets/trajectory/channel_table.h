// What was understood of a record, channel by channel, and which of them is which signal.
#pragma once

#include <QTableWidget>

#include "engine/io/probe/probe_record.h"

namespace lathelier::trajectory_panel {

/// Place, name, unit, range and gain of each channel, and the signal it carries, to be chosen. Writes nothing itself.
class ChannelTable : public QTableWidget {
    Q_OBJECT

public:
    explicit ChannelTable(QWidget* parent = nullptr);

    /// `map`: as TrajectoryParameters::channels.
    void setRecord(const io::ProbeRecord* record, const std::string& map);

signals:
    void mapEdited(const std::string& map);

private:
    void choose(int channel, const QString& signal);

    std::vector<std::pair<QString, QString>> entries_;  ///< signal with its sign, place or name of a channel
    int channels_ = 0;
};

}  // namespace lathelier::trajectory_panel
