#include "widgets/trajectory/channel_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <algorithm>
#include <cmath>

#include "engine/trajectory/channel_map.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/copy_table.h"

namespace lathelier::trajectory_panel {
namespace {

const QStringList signalKeys{"", "marker", "angle", "X3", "-X3", "Y3", "-Y3", "Xp", "-Xp", "Yp", "-Yp"};

constexpr int signalColumn = 5;
constexpr int sensitivityColumn = 6;
constexpr int calibratedColumn = 7;

QString bare(const QString& signal)
{
    return signal.startsWith('-') ? signal.mid(1) : signal;
}

QString unitText(io::ProbeChannel::Unit unit)
{
    switch (unit) {
        case io::ProbeChannel::Unit::Micrometre: return QStringLiteral("µm");
        case io::ProbeChannel::Unit::Millimetre: return QStringLiteral("mm");
        case io::ProbeChannel::Unit::Volt: return QStringLiteral("V");
        case io::ProbeChannel::Unit::Degree: return QStringLiteral("°");
        case io::ProbeChannel::Unit::Unknown: return ChannelTable::tr("not stated");
    }
    return {};
}

QString signalText(const QString& key)
{
    if (key.isEmpty()) return ChannelTable::tr("not used");
    if (key == "marker") return ChannelTable::tr("revolution marker");
    if (key == "angle") return ChannelTable::tr("angle of an encoder");
    const QString sign = key.startsWith('-') ? QStringLiteral("−") : QString();
    const QString name = bare(key);
    return sign + name + (name.endsWith('3') ? ChannelTable::tr(" (workpiece axis)") : ChannelTable::tr(" (tool)"));
}

}  // namespace

ChannelTable::ChannelTable(QWidget* parent) : QTableWidget(parent)
{
    setObjectName("channels");
    setColumnCount(8);
    verticalHeader()->hide();
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::NoSelection);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setEditTriggers(AllEditTriggers);
    connect(this, &QTableWidget::cellChanged, this, [this](int row, int column) {
        if (column >= sensitivityColumn) takeCalibration(row);
    });
}

void ChannelTable::setRecord(const io::ProbeRecord* record, const trajectory::TrajectoryParameters& parameters)
{
    const QSignalBlocker quiet(this);
    const std::string& map = parameters.channels;
    calibrations_ = parameters.probes;
    setAccessibleName(tr("Channels of the record"));
    setHorizontalHeaderLabels({tr("No."), tr("Name"), tr("Unit"), tr("Range"), tr("Gain"), tr("Signal"),
                               tr("Sensitivity (µm/V)"), tr("Calibrated")});
    horizontalHeaderItem(sensitivityColumn)
        ->setToolTip(tr("By the certificate of the probe; empty: the sensitivity of all probes"));
    horizontalHeaderItem(calibratedColumn)->setToolTip(tr("Date of the calibration, for the report"));
    setRowCount(0);
    entries_.clear();
    for (const QString& entry : QString::fromStdString(map).split(',', Qt::SkipEmptyParts)) {
        const QStringList halves = entry.trimmed().split('=');
        if (halves.size() == 2) entries_.emplace_back(halves[0].trimmed(), halves[1].trimmed());
    }
    if (!record) return;
    channels_ = static_cast<int>(record->channels.size());
    setRowCount(channels_);
    for (int row = 0; row < channels_; ++row) {
        const io::ProbeChannel& channel = record->channels[static_cast<std::size_t>(row)];
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const double value : channel.values)
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        setItem(row, 0, tableCell(QString::number(row), true));
        setItem(row, 1, tableCell(QString::fromStdString(channel.name), false));
        setItem(row, 2, tableCell(unitText(channel.unit), false));
        const QString range = low <= high ? screenNumber(low, 3) + " … " + screenNumber(high, 3) : QStringLiteral("–");
        setItem(row, 3, tableCell(range, true));
        setItem(row, 4, tableCell(QString::number(channel.gain), true));
        auto* box = new QComboBox;
        for (const QString& key : signalKeys) box->addItem(signalText(key), key);
        const auto used = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
            return entry.second == QString::number(row) || entry.second == QString::fromStdString(channel.name);
        });
        box->setCurrentIndex(used == entries_.end() ? 0 : std::max(0, box->findData(used->first)));
        box->setAccessibleName(tr("Signal of channel %1").arg(row));
        connect(box, qOverload<int>(&QComboBox::activated), this,
                [this, row, box] { choose(row, box->currentData().toString()); });
        setCellWidget(row, signalColumn, box);
        showCalibration(row, channel, parameters);
        setRowHeight(row, box->sizeHint().height() + 2);
    }
}

QString ChannelTable::signalOf(int row) const
{
    return bare(static_cast<const QComboBox*>(cellWidget(row, signalColumn))->currentData().toString());
}

/// Cells of a probe in volts are editable; assumed values are grey.
void ChannelTable::showCalibration(int row, const io::ProbeChannel& channel,
                                   const trajectory::TrajectoryParameters& parameters)
{
    const QString signal = signalOf(row);
    const bool probe = !signal.isEmpty() && signal != "marker" && signal != "angle";
    if (!probe || channel.unit != io::ProbeChannel::Unit::Volt) {
        for (const int column : {sensitivityColumn, calibratedColumn})
            setItem(row, column, tableCell(QStringLiteral("–"), false));
        return;
    }
    const auto own = std::find_if(calibrations_.begin(), calibrations_.end(), [&](const auto& calibration) {
        return signal == trajectory::name(calibration.probe);
    });
    auto* sensitivity = new QTableWidgetItem;
    auto* calibrated = new QTableWidgetItem;
    if (own != calibrations_.end()) {
        sensitivity->setText(screenText(Value(own->sensitivity_um_per_V)));
        calibrated->setText(QString::fromStdString(own->calibrated));
    } else {
        const auto& common = parameters.sensitivity_um_per_V;
        const QString value = screenText(Value(common.value_or(trajectory::assumedSensitivity_um_per_V)));
        sensitivity->setText(value);
        sensitivity->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
        sensitivity->setToolTip(common ? tr("The sensitivity of all probes") : tr("Assumed: nobody has stated it"));
    }
    sensitivity->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setItem(row, sensitivityColumn, sensitivity);
    setItem(row, calibratedColumn, calibrated);
}

void ChannelTable::takeCalibration(int row)
{
    const QString signal = signalOf(row);
    std::vector<trajectory::ProbeCalibration> probes = calibrations_;
    std::erase_if(probes, [&](const auto& calibration) { return signal == trajectory::name(calibration.probe); });
    bool understood = false;
    const double typed = QLocale().toDouble(item(row, sensitivityColumn)->text().trimmed(), &understood);
    for (int i = 0; understood && typed > 0 && i < 4; ++i) {
        const auto probe = static_cast<trajectory::Probe>(i);
        if (signal == trajectory::name(probe))
            probes.push_back({probe, typed, item(row, calibratedColumn)->text().trimmed().toStdString()});
    }
    emit calibrationsEdited(probes);
}

void ChannelTable::choose(int channel, const QString& signal)
{
    const QString name = item(channel, 1)->text();
    // Exchanges the assignment: the signal's earlier channel gets the channel's earlier signal.
    QString freed;
    for (const auto& [key, place] : entries_)
        if (place == QString::number(channel) || place == name) freed = key;
    QString left;
    for (const auto& [key, place] : entries_)
        if (!signal.isEmpty() && bare(key) == bare(signal)) left = place;
    std::erase_if(entries_, [&](const auto& entry) {
        return entry.second == QString::number(channel) || entry.second == name ||
               (!signal.isEmpty() && bare(entry.first) == bare(signal));
    });
    if (!signal.isEmpty()) entries_.emplace_back(signal, QString::number(channel));
    const bool swaps = !freed.isEmpty() && !left.isEmpty() && bare(freed) != bare(signal);
    if (swaps) entries_.emplace_back(freed, left);
    QStringList map;
    for (const auto& [key, place] : entries_) map << key + "=" + place;
    emit mapEdited(map.join(',').toStdString());
}

}  // namespace lathelier::trajectory_panel
