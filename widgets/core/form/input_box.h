// One input of a panel: which file or files, what was understood of them, and how to read them.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "engine/io/import.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

class Form;

/// Shows the Sources of a role and lets the user choose, drop, clear them, and settle what the files leave open.
/// Changes nothing by itself: the panel does, through the session.
class InputBox : public QWidget {
    Q_OBJECT
public:
    explicit InputBox(const InputRole& role, QWidget* parent = nullptr);

    void setSources(const std::vector<project::Source>& sources);
    /// The items of the project that may be taken, and which of them have an origin that changed.
    struct ItemOffer {
        QString name;           ///< of the item
        QString origin;         ///< title or id of the panel that made it; empty: none
        bool outdated = false;  ///< isOutdated(): the panel that made it has another state by now
    };
    void setItems(const std::vector<ItemOffer>& items);

    void setUnderstood(const QString& text);  ///< empty: not read (yet)
    void setProblem(const Error* error);      ///< of this file; unfolds the reading options when they settle it

signals:
    void openWanted();
    void clearWanted();
    void itemWanted(const QString& name);
    void filesDropped(const QStringList& paths);
    void importChanged(const lathelier::Values& import);

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void retranslate();
    void refresh();

    InputRole role_;
    std::vector<project::Source> sources_;
    std::vector<ItemOffer> items_;
    QString understood_;
    bool problem_ = false;
    QLabel* title_;
    QLabel* file_;
    QLabel* facts_;
    QToolButton* open_;
    QToolButton* clear_;
    QToolButton* item_;
    QToolButton* how_;
    Form* import_;
};

/// "PLY binary · 732 000 points · unit mm": format, `amount`, and how the file was read.
QString understoodText(const io::FileFacts& facts, const QString& amount);

}  // namespace lathelier
