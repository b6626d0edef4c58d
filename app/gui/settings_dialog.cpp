#include "app/gui/settings_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>

#include "engine/core/conformity.h"
#include "widgets/core/language.h"

namespace lathelier {

SettingsDialog::SettingsDialog(const Settings& settings, QWidget* parent)
    : QDialog(parent),
      language_(new QComboBox),
      theme_(new QComboBox),
      presenter_(new QSpinBox),
      decision_(new QComboBox),
      length_(new QComboBox),
      form_(new QComboBox)
{
    setWindowTitle(tr("Settings"));
    language_->setObjectName("language");
    language_->addItem(tr("As the system"), QString());
    for (const QString& code : Languages::codes()) language_->addItem(Languages::name(code), code);
    language_->setCurrentIndex(std::max(0, language_->findData(settings.language)));
    theme_->setObjectName("theme");
    theme_->addItem(tr("As the system"), QString());
    theme_->addItem(tr("Light"), QString("light"));
    theme_->addItem(tr("Dark"), QString("dark"));
    theme_->setCurrentIndex(std::max(0, theme_->findData(settings.theme)));
    presenter_->setObjectName("presenter");
    presenter_->setRange(100, 300);
    presenter_->setSingleStep(10);
    presenter_->setSuffix(tr(" %"));
    presenter_->setValue(settings.presenter_percent);
    presenter_->setToolTip(tr("Type size in presenter mode"));

    decision_->setObjectName("decision");
    decision_->addItem(tr("the one each panel begins with"), QString());
    for (const DecisionRule rule : decisionRules)
        decision_->addItem(screenText(name(rule)),
                           QString::fromUtf8(key(rule).data(), static_cast<int>(key(rule).size())));
    decision_->setCurrentIndex(std::max(0, decision_->findData(settings.decision)));
    decision_->setToolTip(tr("What new evaluations begin with; each can be changed"));

    length_->setObjectName("length_unit");
    length_->addItem(tr("millimetre (mm)"), static_cast<int>(ScreenUnits::Length::Millimetre));
    length_->addItem(tr("inch (in)"), static_cast<int>(ScreenUnits::Length::Inch));
    length_->setCurrentIndex(length_->findData(static_cast<int>(settings.units.length)));
    form_->setObjectName("form_unit");
    form_->addItem(tr("micrometre (µm)"), static_cast<int>(ScreenUnits::Form::Micrometre));
    form_->addItem(tr("millimetre (mm)"), static_cast<int>(ScreenUnits::Form::Millimetre));
    form_->addItem(tr("microinch (µin)"), static_cast<int>(ScreenUnits::Form::Microinch));
    form_->setCurrentIndex(form_->findData(static_cast<int>(settings.units.form)));
    for (QComboBox* unit : {length_, form_})
        unit->setToolTip(tr("On screen and in reports; files with numbers and the command line keep mm and µm"));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("Language"), language_);
    layout->addRow(tr("Theme"), theme_);
    layout->addRow(tr("Presenter type size"), presenter_);
    layout->addRow(tr("Decision rule of new evaluations"), decision_);
    layout->addRow(tr("Lengths and deviations in"), length_);
    layout->addRow(tr("Form and run-out in"), form_);
    layout->addRow(buttons);
}

Settings SettingsDialog::settings() const
{
    return {language_->currentData().toString(),
            theme_->currentData().toString(),
            presenter_->value(),
            decision_->currentData().toString(),
            {static_cast<ScreenUnits::Length>(length_->currentData().toInt()),
             static_cast<ScreenUnits::Form>(form_->currentData().toInt())}};
}

}  // namespace lathelier
