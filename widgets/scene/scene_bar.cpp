#include "widgets/scene/scene_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QSlider>
#include <QToolButton>

namespace lathelier::scene {

SceneBar::SceneBar(QWidget* parent) : QWidget(parent)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (const SceneViewpoint viewpoint :
         {SceneViewpoint::Oblique, SceneViewpoint::Side, SceneViewpoint::Top, SceneViewpoint::End}) {
        auto* button = new QToolButton(this);
        button->setAutoRaise(true);
        connect(button, &QToolButton::clicked, this, [this, viewpoint] { emit viewpointRequested(viewpoint); });
        layout->addWidget(button);
        viewpoints_.push_back(button);
    }
    auto* parallel = new QToolButton(this);
    parallel->setAutoRaise(true);
    parallel->setCheckable(true);
    parallel_ = parallel;
    connect(parallel, &QToolButton::toggled, this, &SceneBar::parallelRequested);
    layout->addWidget(parallel);

    section_ = new QComboBox(this);
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setRange(0, 1000);
    slider_->setValue(500);
    slider_->hide();
    layout->addWidget(section_);
    layout->addWidget(slider_, 1);
    layout->addStretch(0);
    for (int i = 0; i < 4; ++i) section_->addItem({});
    const auto tell = [this] {
        slider_->setVisible(section_->currentIndex() > 0);
        emit sectionRequested(section_->currentIndex() - 1, slider_->value() / 1000.0);
    };
    connect(section_, qOverload<int>(&QComboBox::currentIndexChanged), this, tell);
    connect(slider_, &QSlider::valueChanged, this, tell);
    setTexts();
}

void SceneBar::setTexts()
{
    const QStringList names{tr("Oblique"), tr("Side"), tr("Top"), tr("End")};
    for (std::size_t i = 0; i < viewpoints_.size(); ++i) viewpoints_[i]->setText(names[static_cast<int>(i)]);
    parallel_->setText(tr("Parallel"));
    parallel_->setToolTip(tr("Parallel projection: equal lengths look equal at any distance"));
    const QStringList cuts{tr("Whole"), tr("Cut along X"), tr("Cut along Y"), tr("Cut along Z")};
    for (int i = 0; i < cuts.size(); ++i) section_->setItemText(i, cuts[i]);
    section_->setToolTip(tr("Cut away one side of the part"));
    section_->setAccessibleName(tr("Section"));
    slider_->setAccessibleName(tr("Place of the section"));
}

void SceneBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) setTexts();
}

}  // namespace lathelier::scene
