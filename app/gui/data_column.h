// Content of the project: files with their uses, and items made by panels. A file can be dragged from here into an
// input.
#pragma once

#include <QTreeWidget>
#include <vector>

#include "widgets/core/panel/panel_facts.h"
#include "widgets/core/session.h"

namespace lathelier {

class DataColumn : public QTreeWidget {
    Q_OBJECT
public:
    DataColumn(Session& session, std::vector<PanelFacts> panels, QWidget* parent = nullptr);

    void retranslate();

    QSize sizeHint() const override { return {fontMetrics().averageCharWidth() * 34, fontMetrics().height() * 20}; }
    QSize minimumSizeHint() const override
    {
        return {fontMetrics().averageCharWidth() * 24, fontMetrics().height() * 6};
    }

signals:
    void panelRequested(const std::string& panel);  ///< a double click on what this panel works on
    void itemRequested(const std::string& name);    ///< a double click on an item: the panel that takes its kind

protected:
    QMimeData* mimeData(const QList<QTreeWidgetItem*> items) const override;
    QStringList mimeTypes() const override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void addFiles();
    void addItems();
    void open(QTreeWidgetItem* row);
    Q_INVOKABLE void removeItem(const QString& name);

    Session& session_;
    std::vector<PanelFacts> panels_;
};

}  // namespace lathelier
