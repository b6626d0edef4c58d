#include "app/gui/data_column.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMimeData>
#include <QUrl>
#include <algorithm>

#include "engine/project/input_key.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

// Data roles of a row.
enum Role { PathRole = Qt::UserRole, PanelRole, ItemRole };

}  // namespace

DataColumn::DataColumn(Session& session, std::vector<PanelFacts> panels, QWidget* parent)
    : QTreeWidget(parent), session_(session), panels_(std::move(panels))
{
    setObjectName("data");
    setColumnCount(1);
    setHeaderHidden(true);
    setRootIsDecorated(true);
    setIndentation(fontMetrics().height());
    setDragEnabled(true);
    setDragDropMode(QAbstractItemView::DragOnly);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setUniformRowHeights(false);
    setTextElideMode(Qt::ElideMiddle);
    connect(&session_, &Session::changed, this, &DataColumn::fill);
    connect(&session_, &Session::pathChanged, this, &DataColumn::fill);
    connect(this, &QTreeWidget::itemActivated, this, &DataColumn::open);
    fill();
}

void DataColumn::fill()
{
    clear();
    addFiles();
    addItems();
    expandAll();
    if (topLevelItemCount() > 0) return;
    auto* nothing = new QTreeWidgetItem(this, {tr("Nothing yet: drop files anywhere.")});
    nothing->setFlags(Qt::NoItemFlags);
}

/// Each file once, and under it every input that it stands in. Panels with a common state appear once.
void DataColumn::addFiles()
{
    std::map<std::string, QTreeWidgetItem*> rows;
    std::vector<std::pair<std::string, std::string>> named;  // state and input
    for (const PanelFacts& facts : panels_) {
        for (const auto& [place, source] : session_.panel(facts.stateKey()).inputs) {
            if (source.path.empty()) continue;
            const std::string& key = place;
            const auto role = std::find_if(facts.roles.begin(), facts.roles.end(),
                                           [&](const InputRole& r) { return project::belongsTo(key, r.role); });
            const std::pair<std::string, std::string> input(facts.stateKey(), key);
            if (role == facts.roles.end() || std::find(named.begin(), named.end(), input) != named.end()) continue;
            named.push_back(input);
            QTreeWidgetItem*& row = rows[source.path];
            if (!row) {
                const QString path = QString::fromStdString(source.path);
                row = new QTreeWidgetItem(this, {screenFileName(path)});
                row->setIcon(0, icon("open"));
                row->setData(0, PathRole, path);
                row->setData(0, PanelRole, QString::fromStdString(facts.id));
                QString about = path;
                if (!source.sha256.empty()) about += "\nSHA-256 " + QString::fromStdString(source.sha256);
                if (source.synthetic) about += "\n" + tr("Synthetic data: made by a program, not measured");
                row->setToolTip(0, about);
            }
            auto* use = new QTreeWidgetItem(row, {screenText(facts.title) + " · " + screenText(role->label)});
            use->setIcon(0, icon(facts.icon));
            use->setData(0, PathRole, QString::fromStdString(source.path));
            use->setData(0, PanelRole, QString::fromStdString(facts.id));
        }
    }
}

void DataColumn::addItems()
{
    for (const auto& [name, made] : session_.project().items) {
        const project::Item& item = made;
        const QString words = QString::fromStdString(name);
        auto* row = new QTreeWidgetItem(this, {words});
        row->setIcon(0, icon("item"));
        row->setData(0, ItemRole, words);
        const auto maker = std::find_if(panels_.begin(), panels_.end(),
                                        [&](const PanelFacts& facts) { return facts.id == item.origin.panel; });
        QStringList about;
        if (maker != panels_.end()) about << tr("made in %1").arg(screenText(maker->title));
        if (isOutdated(session_.project(), item)) about << tr("its origin has changed since");
        if (!about.isEmpty()) {
            auto* origin = new QTreeWidgetItem(row, {about.join(", ")});
            origin->setFlags(Qt::ItemIsEnabled);
        }
        row->setToolTip(0, words + (about.isEmpty() ? QString() : "\n" + about.join(", ")));
    }
}

void DataColumn::open(QTreeWidgetItem* row)
{
    if (const QString name = row->data(0, ItemRole).toString(); !name.isEmpty()) emit itemRequested(name.toStdString());
    if (const QString panel = row->data(0, PanelRole).toString(); !panel.isEmpty())
        emit panelRequested(panel.toStdString());
}

QStringList DataColumn::mimeTypes() const
{
    return {"text/uri-list"};
}

QMimeData* DataColumn::mimeData(const QList<QTreeWidgetItem*> items) const
{
    QList<QUrl> urls;
    for (const QTreeWidgetItem* row : items)
        if (const QString path = row->data(0, PathRole).toString(); !path.isEmpty()) {
            const QUrl url = QUrl::fromLocalFile(path);
            if (!urls.contains(url)) urls << url;
        }
    if (urls.isEmpty()) return nullptr;
    auto* dragged = new QMimeData;
    dragged->setUrls(urls);
    return dragged;
}

void DataColumn::contextMenuEvent(QContextMenuEvent* event)
{
    QTreeWidgetItem* row = itemAt(event->pos());
    if (!row) return;
    QMenu menu(this);
    const QString path = row->data(0, PathRole).toString();
    const QString item = row->data(0, ItemRole).toString();
    if (!path.isEmpty() || !item.isEmpty()) menu.addAction(tr("Show"), this, [this, row] { open(row); });
    if (!path.isEmpty())
        menu.addAction(tr("Copy the path"), this, [path] { QApplication::clipboard()->setText(path); });
    if (!item.isEmpty()) menu.addAction(tr("Remove from the project"), this, [this, item] { removeItem(item); });
    if (!menu.isEmpty()) menu.exec(event->globalPos());
}

/// With the inputs that it stands in.
void DataColumn::removeItem(const QString& name)
{
    session_.edit(tr("Remove “%1”").arg(name), [key = name.toStdString()](project::Project& project) {
        project.items.erase(key);
        for (auto& [id, panel] : project.panels)
            for (auto input = panel.inputs.begin(); input != panel.inputs.end();)
                input = input->second.item == key ? panel.inputs.erase(input) : std::next(input);
    });
}

void DataColumn::retranslate()
{
    setAccessibleName(tr("Data of the project"));
    fill();
}

void DataColumn::changeEvent(QEvent* event)
{
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier
