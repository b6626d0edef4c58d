#include "app/gui/parts_box.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/project/parts.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

constexpr int mostRows = 6;  // of the list; beyond it scrolls

QToolButton* button(const char* name, const char* picture)
{
    auto* result = new QToolButton;
    result->setObjectName(name);
    result->setIcon(icon(picture));
    result->setAutoRaise(true);
    result->setFocusPolicy(Qt::StrongFocus);
    return result;
}

}  // namespace

PartsBox::PartsBox(Session& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      title_(new QLabel),
      list_(new QListWidget),
      add_(button("addPart", "add")),
      rename_(button("renamePart", "program")),
      remove_(button("removePart", "remove"))
{
    setObjectName("parts");
    list_->setObjectName("partList");
    list_->setFrameShape(QFrame::NoFrame);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideMiddle);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    auto* head = new QHBoxLayout;
    head->setSpacing(2);
    head->addWidget(title_, 1);
    for (QToolButton* one : {add_, rename_, remove_}) head->addWidget(one);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 2, 2, 4);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(list_);
    connect(add_, &QToolButton::clicked, this, &PartsBox::addPart);
    connect(rename_, &QToolButton::clicked, this, &PartsBox::renameCurrent);
    connect(remove_, &QToolButton::clicked, this, &PartsBox::removeCurrent);
    connect(list_, &QListWidget::itemClicked, this, &PartsBox::show);
    connect(list_, &QListWidget::itemActivated, this, &PartsBox::show);
    connect(list_, &QListWidget::itemChanged, this, &PartsBox::takeName);
    connect(list_, &QListWidget::customContextMenuRequested, this, &PartsBox::askAt);
    connect(&session_, &Session::changed, this, &PartsBox::fill);
    retranslate();
}

QString PartsBox::nameOf(std::size_t index) const
{
    const std::vector<std::string> names = project::partNames(session_.project());
    const QString name = index < names.size() ? QString::fromStdString(names[index]) : QString();
    return name.isEmpty() ? tr("Part %1").arg(index + 1) : name;
}

void PartsBox::fill()
{
    const auto count = static_cast<int>(session_.project().others.size() + 1);
    const auto shown = static_cast<int>(session_.project().place);
    const QSignalBlocker quiet(list_);
    while (list_->count() > count) delete list_->takeItem(list_->count() - 1);
    while (list_->count() < count) list_->addItem(new QListWidgetItem);
    for (int i = 0; i < count; ++i) {
        QListWidgetItem* row = list_->item(i);
        const QString name = nameOf(static_cast<std::size_t>(i));
        QFont font = list_->font();
        font.setBold(i == shown);
        row->setFont(font);
        row->setText(name);
        row->setIcon(i == shown ? icon("choose") : QIcon());
        row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
        row->setToolTip(i == shown ? tr("%1: its data are shown").arg(name) : tr("Show %1").arg(name));
        row->setData(Qt::AccessibleTextRole, i == shown ? tr("%1, shown").arg(name) : name);
    }
    list_->setCurrentRow(shown);
    remove_->setEnabled(count > 1);
    fitHeight();
}

void PartsBox::fitHeight()
{
    const int row = std::max(list_->sizeHintForRow(0), fontMetrics().height());
    list_->setFixedHeight(row * std::clamp(list_->count(), 1, mostRows) + 2 * list_->frameWidth());
}

void PartsBox::show(QListWidgetItem* row)
{
    session_.showPart(static_cast<std::size_t>(list_->row(row)));
}

void PartsBox::addPart()
{
    const QString name = nameOf(session_.project().others.size() + 1);
    session_.edit(tr("Add “%1”").arg(name),
                  [&](project::Project& project) { project::addPart(project, name.toStdString()); });
}

void PartsBox::renameCurrent()
{
    if (QListWidgetItem* row = list_->currentItem()) list_->editItem(row);
}

void PartsBox::removeCurrent()
{
    const int row = list_->currentRow();
    if (row < 0 || list_->count() < 2) return;
    session_.edit(tr("Remove “%1”").arg(nameOf(static_cast<std::size_t>(row))),
                  [row](project::Project& project) { project::removePart(project, static_cast<std::size_t>(row)); });
}

/// An empty name gives the number back.
void PartsBox::takeName(QListWidgetItem* row)
{
    const auto index = static_cast<std::size_t>(list_->row(row));
    const QString name = row->text().trimmed();
    if (name != nameOf(index))
        session_.edit(tr("Rename to “%1”").arg(name),
                      [&](project::Project& project) { project::renamePart(project, index, name.toStdString()); });
    fill();
}

void PartsBox::askAt(const QPoint& place)
{
    QListWidgetItem* row = list_->itemAt(place);
    QMenu menu(this);
    if (row) {
        list_->setCurrentItem(row);
        menu.addAction(tr("Show"), this, [this, row] { show(row); });
        menu.addAction(tr("Rename…"), this, &PartsBox::renameCurrent);
        QAction* remove = menu.addAction(tr("Remove from the project"), this, &PartsBox::removeCurrent);
        remove->setEnabled(list_->count() > 1);
        menu.addSeparator();
    }
    menu.addAction(tr("Add a part"), this, &PartsBox::addPart);
    menu.exec(list_->viewport()->mapToGlobal(place));
}

void PartsBox::retranslate()
{
    title_->setText(tr("Parts"));
    list_->setAccessibleName(tr("Parts of the project"));
    const auto name = [](QToolButton* one, const QString& text) {
        one->setToolTip(text);
        one->setAccessibleName(text);
    };
    name(add_, tr("Add a part"));
    name(rename_, tr("Rename the part"));
    name(remove_, tr("Remove the part from the project"));
    fill();
}

void PartsBox::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
    if (event->type() == QEvent::FontChange) fitHeight();
}

void PartsBox::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitHeight();
}

QWidget* underParts(Session& session, QWidget* below)
{
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(new PartsBox(session));
    layout->addWidget(below, 1);
    return page;
}

}  // namespace lathelier
