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
      decision_(new QComboBox)
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
    for (const DecisionRule rule : {DecisionRule::Simple, DecisionRule::Guarded})
        decision_->addItem(screenText(name(rule)),
                           QString::fromUtf8(key(rule).data(), static_cast<int>(key(rule).size())));
    decision_->setCurrentIndex(std::max(0, decision_->findData(settings.decision)));
    decision_->setToolTip(tr("What new evaluations begin with; each can be changed"));

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("Language"), language_);
    layout->addRow(tr("Theme"), theme_);
    layout->addRow(tr("Presenter type size"), presenter_);
    layout->addRow(tr("Decision rule of new evaluations"), decision_);
    layout->addRow(buttons);
}

Settings SettingsDialog::settings() const
{
    return {language_->currentData().toString(), theme_->currentData().toString(), presenter_->value(),
            decision_->currentData().toString()};
}

}  // namespace lathelier
