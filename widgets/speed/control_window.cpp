#include "widgets/speed/control_window.h"

#include <QCloseEvent>
#include <QGridLayout>

#include "engine/core/units.h"
#include "engine/stability/task/speed_entry.h"
#include "engine/stability/task/speed_task.h"
#include "widgets/core/language.h"

namespace lathelier::speed_panel {
namespace {

constexpr int lookEvery_ms = 100;
constexpr int largeType_px = 44;
constexpr double highestTyped = 99999;
constexpr int typedDecimals = 1;

/// Values of a part that a class can begin with.
const std::map<std::string, double>& firstValues()
{
    static const std::map<std::string, double> all{{link::diameterName, 32},
                                                   {link::lengthName, 250},
                                                   {link::speedName, 290},
                                                   {link::lowestName, 200},
                                                   {link::highestName, 400}};
    return all;
}

}  // namespace

ControlWindow::ControlWindow(QWidget* parent)
    : QWidget(parent, Qt::Window),
      running_(new QCheckBox),
      ask_(new QPushButton),
      corrected_(new QLabel),
      stateLine_(new QLabel),
      linkLine_(new QLabel),
      look_(new QTimer(this))
{
    setObjectName("controlWindow");
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QGridLayout(this);
    int row = 0;
    for (const FieldInfo& info : stability::screenFields()) {
        auto* name = new QLabel;
        auto* field = new QDoubleSpinBox;
        field->setObjectName(QString::fromStdString(info.key));
        field->setRange(0, highestTyped);
        field->setDecimals(typedDecimals);
        field->setValue(firstValues().at(info.key));
        name->setBuddy(field);
        layout->addWidget(name, row, 0);
        layout->addWidget(field, row++, 1);
        names_[info.key] = name;
        fields_[info.key] = field;
    }
    running_->setObjectName("controlRunning");
    ask_->setObjectName("controlAsk");
    corrected_->setObjectName("controlCorrected");
    stateLine_->setObjectName("controlState");
    stateLine_->setWordWrap(true);
    QFont large = corrected_->font();
    large.setPixelSize(largeType_px);
    large.setBold(true);
    corrected_->setFont(large);
    corrected_->setAlignment(Qt::AlignCenter);
    layout->addWidget(running_, row++, 0, 1, 2);
    layout->addWidget(ask_, row++, 0, 1, 2);
    layout->addWidget(corrected_, row++, 0, 1, 2);
    layout->addWidget(stateLine_, row++, 0, 1, 2);
    layout->addWidget(linkLine_, row++, 0, 1, 2);
    layout->setRowStretch(row, 1);
    connect(ask_, &QPushButton::clicked, this, &ControlWindow::ask);
    connect(running_, &QCheckBox::toggled, this, [this](bool runs) { control_.set(link::runningName, runs ? 1 : 0); });
    connect(look_, &QTimer::timeout, this, &ControlWindow::showState);
    look_->start(lookEvery_ms);
    retranslate();
}

/// The values as they stand, then the request.
void ControlWindow::ask()
{
    for (const auto& [key, field] : fields_) control_.set(key, field->value());
    control_.request();
    showState();
}

void ControlWindow::showState()
{
    const link::ControlValues now = control_.values();
    const double request = now.at(link::requestName);
    const bool is_answered = request != 0 && now.at(link::answeredName) == request;
    const auto state = link::stateOfNumber(static_cast<std::int64_t>(now.at(link::stateName)));
    const std::optional<double> corrected = control_.correctedRpm();
    corrected_->setText(corrected ? QString("N %1 %2").arg(screenNumber(*corrected, 0), screenText(unit::rpm))
                                  : QString("–"));
    const bool is_linked = control_.isLinked();
    if (request == 0)
        stateLine_->setText(tr("Nothing was asked yet."));
    else if (!is_answered)
        stateLine_->setText(is_linked ? tr("Asked …") : tr("Asked; no assistant is linked."));
    else
        stateLine_->setText(
            tr("State %1: %2")
                .arg(screenNumber(now.at(link::stateName), 0), state ? screenText(link::textOf(*state)) : QString()));
    linkLine_->setText(is_linked
                           ? tr("Assistant linked · heartbeat %1").arg(screenNumber(now.at(link::heartbeatName), 0))
                           : tr("No assistant on port %1").arg(port()));
}

void ControlWindow::retranslate()
{
    setWindowTitle(tr("Control (simulated)"));
    for (const FieldInfo& info : stability::screenFields()) {
        names_.at(info.key)->setText(screenText(info.label));
        fields_.at(info.key)->setLocale(QLocale());
        // The registers of a control hold the engine's units, whatever the screen shows elsewhere.
        fields_.at(info.key)->setSuffix(" " + screenText(info.unit));
    }
    running_->setText(tr("The machine runs"));
    ask_->setText(tr("Ask for a stable speed"));
    showState();
}

void ControlWindow::closeEvent(QCloseEvent* event)
{
    emit closed();
    QWidget::closeEvent(event);
}

void ControlWindow::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier::speed_panel
