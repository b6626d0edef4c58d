#include "app/gui/title_block_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>
#include <array>

#include "widgets/core/form/form.h"
#include "widgets/core/form/number_edit.h"

namespace lathelier {
namespace {

constexpr std::array kept{"company", "instrument", "calibration_date", "inspector"};

QString settingOf(const char* key)
{
    return QString("title_block/") + key;
}

}  // namespace

report::TitleBlock titleBlockOf(const project::Project& project)
{
    if (!project.title_block.empty()) return fromValues<report::TitleBlock>(project.title_block);
    Values values = toValues(report::TitleBlock{});
    for (const char* key : kept)
        lathelier::set(values, key, QSettings().value(settingOf(key)).toString().toStdString());
    return fromValues<report::TitleBlock>(values);
}

TitleBlockDialog::TitleBlockDialog(const report::TitleBlock& block, QWidget* parent)
    : QDialog(parent), form_(new Form(infos<report::TitleBlock>()))
{
    setWindowTitle(tr("Title block"));
    auto* about = new QLabel(tr("What is filled in stands on the first page of every report of this project."));
    about->setWordWrap(true);
    form_->setValues(toValues(block));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(about);
    layout->addWidget(form_);
    layout->addStretch(1);
    layout->addWidget(buttons);
    resize(fontMetrics().averageCharWidth() * 70, sizeHint().height());
}

report::TitleBlock TitleBlockDialog::block() const
{
    takeOverTyping(this);
    return fromValues<report::TitleBlock>(form_->values());
}

void TitleBlockDialog::keep(const report::TitleBlock& block)
{
    const Values values = toValues(block);
    for (const char* key : kept)
        QSettings().setValue(settingOf(key),
                             QString::fromStdString(std::get<std::string>(*lathelier::find(values, key))));
}

}  // namespace lathelier
