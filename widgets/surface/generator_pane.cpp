#include "widgets/surface/generator_pane.h"

#include <QGridLayout>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "widgets/core/language.h"

namespace lathelier::surface_panel {
namespace {

constexpr int sliderPlaces = 400;  // of a slider
constexpr int readableDigits = 3;  // of a number that a slider gives

struct Reach {
    const char* key;
    double from, to;
    bool logarithmic;
};

/// What a class tries out.
constexpr Reach reaches[] = {{"feed_mm_rev", 0.05, 0.5, true},   {"diameter_mm", 10, 100, true},
                             {"nose_radius_mm", 0.2, 2.4, true}, {"speed_rpm", 300, 6000, true},
                             {"frequency_hz", 50, 2000, true},   {"amplitude_um", 0, 60, false},
                             {"mm_per_px", 0.002, 0.05, true},   {"feed_direction_deg", -45, 45, false},
                             {"irregular", 0, 0.5, false},       {"noise", 0, 0.15, false}};

double rounded(double value)
{
    if (value == 0) return 0;
    const double power = std::pow(10, readableDigits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * power) / power;
}

}  // namespace

GeneratorPane::GeneratorPane(QWidget* parent)
    : QWidget(parent),
      quiz_(new QuizPane),
      cut_(new QWidget),
      light_(new QComboBox),
      lightName_(new QLabel),
      cylinder_(new QCheckBox),
      title_(new QLabel),
      waves_(new QLabel),
      found_(new QLabel)
{
    light_->setObjectName("made_light");
    cylinder_->setObjectName("made_cylinder");
    waves_->setObjectName("made_waves");
    found_->setObjectName("made_found");
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    auto* grid = new QGridLayout(cut_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    const std::vector<FieldInfo> all = infos<surface::SyntheticParameters>();
    for (const Reach& reach : reaches)
        for (const FieldInfo& info : all)
            if (info.key == reach.key) addRow(info, reach.from, reach.to, reach.logarithmic, grid);
    const int row = grid->rowCount();
    grid->addWidget(lightName_, row, 0);
    grid->addWidget(light_, row, 1, 1, 2);
    grid->addWidget(cylinder_, row + 1, 0, 1, 3);
    for (QLabel* label : {waves_, found_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->addWidget(title_);
    column->addWidget(quiz_);
    column->addWidget(cut_);
    column->addWidget(waves_);
    column->addWidget(found_);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(content);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    setMinimumWidth(fontMetrics().averageCharWidth() * 40);
    connect(light_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        emit valueRequested("light", light_->itemData(index).toString().toStdString(), ++gesture_);
    });
    connect(cylinder_, &QCheckBox::clicked, this, [this](bool on) { emit valueRequested("cylinder", on, ++gesture_); });
    retranslate();
}

void GeneratorPane::addRow(const FieldInfo& info, double from, double to, bool logarithmic, QGridLayout* grid)
{
    auto* label = new QLabel;
    auto* slider = new QSlider(Qt::Horizontal);
    auto* edit = new NumberEdit(info.minimum, info.maximum);
    slider->setObjectName(QString::fromStdString("madeSlider_" + info.key));
    edit->setObjectName(QString::fromStdString("made_" + info.key));
    slider->setRange(0, sliderPlaces);
    slider->setMinimumWidth(60);
    edit->setMaximumWidth(fontMetrics().averageCharWidth() * 11);
    label->setBuddy(edit);
    const int row = grid->rowCount();
    grid->addWidget(label, row, 0);
    grid->addWidget(slider, row, 1);
    grid->addWidget(edit, row, 2);
    rows_.push_back({info, from, to, logarithmic, label, slider, edit});
    const std::string key = info.key;
    connect(slider, &QSlider::sliderPressed, this, [this] { ++gesture_; });
    connect(slider, &QSlider::valueChanged, this, [=, this](int place) {
        const double share = double(place) / sliderPlaces;
        const double value = logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
        emit valueRequested(key, rounded(value), gesture_);
    });
    connect(slider, &QSlider::sliderReleased, this, [this] { ++gesture_; });
    connect(edit, &NumberEdit::numberChanged, this, [this, key, edit] {
        if (edit->number()) emit valueRequested(key, *edit->number(), gesture_);
    });
    connect(edit, &NumberEdit::finished, this, [this] { ++gesture_; });
}

QSlider* GeneratorPane::slider(const std::string& key) const
{
    for (const Row& row : rows_)
        if (row.info.key == key) return row.slider;
    return nullptr;
}

NumberEdit* GeneratorPane::number(const std::string& key) const
{
    for (const Row& row : rows_)
        if (row.info.key == key) return row.edit;
    return nullptr;
}

void GeneratorPane::setQuestion(const surface::SurfaceQuestion& question)
{
    quiz_->setQuestion(question);
    cut_->setVisible(!question.quiz);
    waves_->setVisible(!isAsking(question));
    found_->setVisible(!isAsking(question));
    setParameters(pictureOf(question));
}

void GeneratorPane::setParameters(const surface::SyntheticParameters& parameters)
{
    parameters_ = parameters;
    const Values values = toValues(parameters);
    for (Row& row : rows_) {
        const Value* const value = lathelier::find(values, row.info.key);
        const double number = value ? std::get<double>(*value) : 0;
        const double share = row.logarithmic
                                 ? std::log(std::max(number, row.from) / row.from) / std::log(row.to / row.from)
                                 : (number - row.from) / (row.to - row.from);
        const QSignalBlocker quiet(row.slider);
        if (!row.slider->isSliderDown())
            row.slider->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * sliderPlaces)));
        row.edit->setNumber(number);
        // The scale follows from the whole width.
        if (row.info.key == "mm_per_px") {
            row.slider->setEnabled(!parameters.cylinder);
            row.edit->setEnabled(!parameters.cylinder);
        }
    }
    const QSignalBlocker quiet(cylinder_);
    cylinder_->setChecked(parameters.cylinder);
    light_->setCurrentIndex(static_cast<int>(parameters.light));
    showWaves();
}

/// What the numbers above mean for the marks, by the formulas.
void GeneratorPane::showWaves()
{
    const surface::SyntheticParameters& p = parameters_;
    const surface::Waves waves = surface::wavesPerRevolution(p.frequency_hz, p.speed_rpm);
    QString words = tr("f_c / n = %1 Hz / %2 Hz = m + ν = %3 %4 %5")
                        .arg(screenNumber(p.frequency_hz, 1), screenNumber(p.speed_rpm / 60, 2))
                        .arg(waves.m)
                        .arg(waves.nu < 0 ? QStringLiteral("−") : QStringLiteral("+"))
                        .arg(screenNumber(std::abs(waves.nu), 3));
    words += "\n" + tr("ε = %1°").arg(screenNumber(surface::phase_deg(waves.nu), 0));
    if (waves.nu != 0)
        words += "\n" + tr("Bands along the axis every f / |ν| = %1")
                            .arg(screenQuantity(p.feed_mm_rev / std::abs(waves.nu), unit::mm, 3));
    if (waves.m > 0) {
        words += "\n" + tr("Waves round the part every πD / m = %1")
                            .arg(screenQuantity(M_PI * p.diameter_mm / waves.m, unit::mm, 2));
        words +=
            "\n" + tr("Crests to the axis: %1°")
                       .arg(screenNumber(surface::inclination_deg(waves.nu, waves.m, p.diameter_mm, p.feed_mm_rev), 1));
    }
    words +=
        "\n" + tr("Depth of a feed mark f² / 8r = %1")
                   .arg(screenQuantity(1000 * p.feed_mm_rev * p.feed_mm_rev / (8 * p.nose_radius_mm), unit::um, 2));
    waves_->setText(words);
}

void GeneratorPane::setFound(const QString& words)
{
    found_->setText(words);
}

void GeneratorPane::retranslate()
{
    title_->setText(tr("Picture that is made"));
    quiz_->retranslate();
    for (Row& row : rows_) {
        const QString unit = screenText(row.info.unit);
        const QString name = screenText(row.info.label);
        row.label->setText(unit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, unit));
        for (QWidget* widget : {static_cast<QWidget*>(row.slider), static_cast<QWidget*>(row.label)})
            widget->setToolTip(screenText(row.info.help));
        row.slider->setAccessibleName(name);
        row.edit->setAccessibleName(name);
        row.edit->setHelp(screenText(row.info.help));
    }
    const QSignalBlocker quiet(light_);
    light_->clear();
    for (const FieldInfo& info : infos<surface::SyntheticParameters>()) {
        if (info.key == "light") {
            lightName_->setText(screenText(info.label));
            light_->setAccessibleName(screenText(info.label));
            light_->setToolTip(screenText(info.help));
            for (const FieldChoice& choice : info.choices)
                light_->addItem(screenText(choice.label), QString::fromStdString(choice.key));
        } else if (info.key == "cylinder") {
            cylinder_->setText(screenText(info.label));
            cylinder_->setToolTip(screenText(info.help));
        }
    }
    setParameters(parameters_);
}

}  // namespace lathelier::surface_panel
