#include "app/gui/title_block_dialog.h"

#include <QBuffer>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QSettings>
#include <QVBoxLayout>
#include <array>

#include "engine/core/error.h"
#include "engine/io/io_codes.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/typing.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

constexpr std::array kept{"company", "instrument", "calibration_date", "inspector", report::logoKey};
constexpr int mostWide_px = 640;  // printed at most 60 mm wide: 270 dpi
constexpr int mostHigh_px = 200;
constexpr int shownHigh_px = 48;

std::vector<FieldInfo> wordFields()
{
    std::vector<FieldInfo> fields = infos<report::TitleBlock>();
    std::erase_if(fields, [](const FieldInfo& info) { return info.key == report::logoKey; });
    return fields;
}

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

std::string readLogo(const QString& path)
{
    QImageReader reader(path);
    QImage image = reader.read();
    if (image.isNull())
        throw Error(errors::malformed, {{"path", path.toStdString()},
                                        {"found", reader.errorString().toStdString()},
                                        {"expected", LT_TEXT("Engine", "a picture")}});
    if (image.width() > mostWide_px || image.height() > mostHigh_px)
        image = image.scaled(mostWide_px, mostHigh_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes.toBase64().toStdString();
}

TitleBlockDialog::TitleBlockDialog(const report::TitleBlock& block, QWidget* parent)
    : QDialog(parent),
      form_(new Form(wordFields())),
      logo_(new QLabel),
      remove_(new QPushButton(tr("Without logo"))),
      problem_(new QLabel),
      logoPngBase64_(block.logo_png_base64)
{
    setWindowTitle(tr("Title block"));
    auto* about = new QLabel(tr("What is filled in stands on the first page of every report of this project."));
    about->setWordWrap(true);
    form_->setValues(toValues(block));
    auto* choose = new QPushButton(tr("Logo…"));
    choose->setObjectName("logo");
    logo_->setObjectName("logoPicture");
    remove_->setObjectName("withoutLogo");
    problem_->setWordWrap(true);
    problem_->hide();
    connect(choose, &QPushButton::clicked, this, [this] {
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Logo"), {}, tr("Pictures (*.png *.jpg *.jpeg *.svg *.bmp)"));
        if (path.isEmpty()) return;
        try {
            logoPngBase64_ = readLogo(path);
            problem_->hide();
        } catch (const Error& error) {
            problem_->setText(screenText(error));
            problem_->show();
        }
        showLogo();
    });
    connect(remove_, &QPushButton::clicked, this, [this] {
        logoPngBase64_.clear();
        showLogo();
    });
    auto* picture = new QHBoxLayout;
    picture->addWidget(choose);
    picture->addWidget(logo_, 1);
    picture->addWidget(remove_);
    showLogo();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(about);
    layout->addWidget(form_);
    layout->addLayout(picture);
    layout->addWidget(problem_);
    layout->addStretch(1);
    layout->addWidget(buttons);
    resize(fontMetrics().averageCharWidth() * 70, sizeHint().height());
}

report::TitleBlock TitleBlockDialog::block() const
{
    takeOverTyping(this);
    auto result = fromValues<report::TitleBlock>(form_->values());
    result.logo_png_base64 = logoPngBase64_;
    return result;
}

void TitleBlockDialog::showLogo()
{
    const QImage image = QImage::fromData(QByteArray::fromBase64(QByteArray::fromStdString(logoPngBase64_)));
    logo_->setPixmap(image.isNull() ? QPixmap()
                                    : QPixmap::fromImage(image.scaledToHeight(shownHigh_px, Qt::SmoothTransformation)));
    remove_->setEnabled(!image.isNull());
}

void TitleBlockDialog::keep(const report::TitleBlock& block)
{
    const Values values = toValues(block);
    for (const char* key : kept)
        QSettings().setValue(settingOf(key),
                             QString::fromStdString(std::get<std::string>(*lathelier::find(values, key))));
}

}  // namespace lathelier
