#include "widgets/speed/link_bar.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QSignalBlocker>

#include "engine/core/units.h"
#include "engine/link/transports.h"
#include "engine/stability/modes.h"
#include "engine/stability/task/speed_entry.h"
#include "engine/stability/task/speed_task.h"
#include "widgets/core/language.h"

namespace lathelier::speed_panel {
namespace {

constexpr char lostInk[] = "color: #d0463b;";
constexpr const char* simulatedKind = "loopback";

}  // namespace

LinkBar::LinkBar(QWidget* parent)
    : QWidget(parent),
      switch_(new QPushButton),
      kinds_(new QComboBox),
      configuration_(new QPushButton),
      simulator_(new QPushButton),
      line_(new QLabel)
{
    // Until a configuration states them: those of a simulated control.
    config_.limits.highest_rpm = stability::usualHighestSpeed_rpm;
    config_.loopback = link::LoopbackSettings{};
    switch_->setObjectName("linkSwitch");
    switch_->setCheckable(true);
    kinds_->setObjectName("linkKind");
    kinds_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    configuration_->setObjectName("linkConfiguration");
    simulator_->setObjectName("linkSimulator");
    line_->setObjectName("linkLine");
    line_->setWordWrap(true);
    line_->setMinimumWidth(1);
    for (const link::TransportKind& kind : link::transportKinds())
        if (kind.is_for_window) kinds_->addItem(screenText(kind.title), kind.key);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(line_, 0, 0, 1, 5);
    layout->addWidget(switch_, 1, 0);
    layout->addWidget(kinds_, 1, 1);
    layout->addWidget(configuration_, 1, 2);
    layout->addWidget(simulator_, 1, 3);
    layout->setColumnStretch(4, 1);
    connect(switch_, &QPushButton::toggled, this, &LinkBar::switchTo);
    connect(configuration_, &QPushButton::clicked, this, &LinkBar::askForConfiguration);
    connect(simulator_, &QPushButton::clicked, this, &LinkBar::openControl);
    connect(&link_, &ControlLink::changed, this, &LinkBar::showState);
    connect(&link_, &ControlLink::exchanged, this, [this] {
        const link::State state = link_.last()->reply.state;
        if (state == link::State::Ok || state == link::State::NoStableSpeed) emit asked(link_.last()->read);
    });
    retranslate();
}

void LinkBar::setQuestion(const std::optional<project::PanelState>& question)
{
    const bool is_other =
        question && question_ && link::machineQuestion(*question) != link::machineQuestion(*question_);
    question_ = question;
    const ControlLink::Status status = link_.status();
    if (is_other && status != ControlLink::Status::Off && status != ControlLink::Status::Refused)
        switchTo(true);  // requests are answered with what the screen shows
    showState();
}

void LinkBar::switchTo(bool on)
{
    if (!on || !question_) return link_.stop();
    config_.question = *question_;
    link_.start(kinds_->currentData().toString().toStdString(), config_);
}

void LinkBar::openControl()
{
    try {
        if (!control_) control_ = new ControlWindow(window());
    } catch (const Error& error) {
        emit refused(error);
        return;
    }
    config_.loopback = link::LoopbackSettings{"127.0.0.1", control_->port()};
    kinds_->setCurrentIndex(kinds_->findData(simulatedKind));
    control_->show();
    control_->raise();
    showState();
}

void LinkBar::askForConfiguration()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open the configuration of a link"), {}, tr("ASSIST.json (*.json)"));
    if (!path.isEmpty()) takeConfiguration(path);
}

void LinkBar::takeConfiguration(const QString& path)
{
    try {
        link::LinkConfig read = link::loadConfig(path.toStdString());
        if (!read.loopback) read.loopback = config_.loopback;
        config_ = std::move(read);
        switch_->setChecked(false);
    } catch (const Error& error) {
        emit refused(error);
    }
}

QString LinkBar::stateText() const
{
    using Status = ControlLink::Status;
    const QString peer = QString::fromStdString(link_.peer());
    switch (link_.status()) {
        case Status::Off:
            return question_ ? tr("Not linked: nothing is written.") : tr("The machine's spindle is needed first.");
        case Status::Connecting: return tr("Linking …");
        case Status::Linked: break;
        case Status::Lost:
        case Status::Refused: return link_.error() ? screenText(*link_.error()) : QString();
    }
    if (link_.error()) return screenText(*link_.error());
    if (!link_.last()) return tr("Linked to %1: waiting for a request.").arg(peer);
    const link::Exchange& last = *link_.last();
    if (last.reply.state != link::State::Ok)
        return tr("Request %1 refused: %2.").arg(last.request).arg(screenText(link::textOf(last.reply.state)));
    return tr("Request %1: %2 → %3 %4, written.")
        .arg(last.request)
        .arg(screenNumber(last.reply.selected_rpm.value_or(notANumber), 0),
             screenNumber(last.written_rpm.value_or(notANumber), 0), screenText(unit::rpm));
}

void LinkBar::showState()
{
    using Status = ControlLink::Status;
    const Status status = link_.status();
    {
        const QSignalBlocker silent(switch_);
        switch_->setChecked(status != Status::Off && status != Status::Refused);
    }
    switch_->setEnabled(question_.has_value() || status != Status::Off);
    kinds_->setEnabled(status == Status::Off || status == Status::Refused);
    configuration_->setEnabled(kinds_->isEnabled());
    const bool is_lost = status == Status::Lost || status == Status::Refused;
    line_->setStyleSheet(is_lost ? lostInk : "");
    QString text = stateText();
    for (const link::TransportKind& kind : link::transportKinds())
        if (status != Status::Off && link_.kind() == kind.key && !kind.is_verified)
            text = tr("Not verified on a real control. %1").arg(text);
    line_->setText(text);
    line_->setToolTip(text);
}

void LinkBar::retranslate()
{
    switch_->setText(tr("Link"));
    switch_->setToolTip(
        tr("Answer the requests of a control: read its values, write the stable speed. Starts nothing."));
    configuration_->setText(tr("Configuration …"));
    configuration_->setToolTip(tr("ASSIST.json: limits of the machine, address and registers of the control"));
    simulator_->setText(tr("Simulator …"));
    simulator_->setToolTip(tr("Open a control in a window of its own, to see both sides of the link"));
    kinds_->setAccessibleName(tr("Kind of the control"));
    for (const link::TransportKind& kind : link::transportKinds())
        if (const int place = kinds_->findData(kind.key); place >= 0)
            kinds_->setItemText(place, screenText(kind.title));
    showState();
}

}  // namespace lathelier::speed_panel
