#include "widgets/core/shell/empty_place.h"

#include <QVBoxLayout>

namespace lathelier {

EmptyPlace::EmptyPlace(QWidget* parent) : QWidget(parent), sentence_(new QLabel), back_(new QPushButton)
{
    setObjectName("emptyPlace");
    sentence_->setObjectName("emptyPlaceSentence");
    sentence_->setAlignment(Qt::AlignCenter);
    sentence_->setWordWrap(true);
    back_->setObjectName("bringPanelsBack");
    auto* layout = new QVBoxLayout(this);
    layout->addStretch();
    layout->addWidget(sentence_);
    layout->addWidget(back_, 0, Qt::AlignHCenter);
    layout->addStretch();
    connect(back_, &QPushButton::clicked, this, &EmptyPlace::panelsRequested);
}

void EmptyPlace::setQuestion(const QString& title)
{
    sentence_->setText(tr("All panels of “%1” are closed or stand in windows of their own.").arg(title));
    back_->setText(tr("&Bring them back"));
}

}  // namespace lathelier
