#include "widgets/trajectory/channel_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <algorithm>
#include <cmath>

#include "widgets/core/language.h"
#include "widgets/core/panel/copy_table.h"

namespace lathelier::trajectory_panel {
namespace {

const QStringList signalKeys{"", "marker", "angle", "X3", "-X3", "Y3", "-Y3", "Xp", "-Xp", "Yp", "-Yp"};

QString bare(QString signal)
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
    setColumnCount(6);
    verticalHeader()->hide();
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::NoSelection);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void ChannelTable::setRecord(const io::ProbeRecord* record, const std::string& map)
{
    setAccessibleName(tr("Channels of the record"));
    setHorizontalHeaderLabels({tr("No."), tr("Name"), tr("Unit"), tr("Range"), tr("Gain"), tr("Signal")});
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
        setCellWidget(row, 5, box);
        setRowHeight(row, box->sizeHint().height() + 2);
    }
    resizeColumnsToContents();
    if (channels_ > 0) setColumnWidth(5, cellWidget(0, 5)->sizeHint().width() + 2);
}

void ChannelTable::choose(int channel, const QString& signal)
{
    const QString name = item(channel, 1)->text();
    // The signal leaves its earlier channel, the channel its earlier signal; what is the other one's goes to it.
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
