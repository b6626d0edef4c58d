// One input of a panel: its files, their facts and reading options.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "engine/io/import.h"
#include "engine/walk/walk.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

class Form;

/// Shows the Sources of a role and lets the user choose, drop and clear them and set reading options. Changes go
/// through the panel and the session.
class InputBox : public QWidget {
    Q_OBJECT
public:
    explicit InputBox(const InputRole& role, QWidget* parent = nullptr);

    void setSources(const std::vector<project::Source>& sources);
    /// The project's items of the accepted kind, and whether their origin has changed.
    struct ItemOffer {
        QString name;           ///< name of the item
        QString origin;         ///< title or id of the panel that made it; empty: none
        bool outdated = false;  ///< isOutdated(): the state of the panel that made it has changed
    };
    void setItems(const std::vector<ItemOffer>& items);

    void setTaken(const walk::Taken* taken);  ///< nullptr: given here, or not at all
    void setUnderstood(const QString& text);  ///< empty: not read (yet)
    void setProblem(const Error* error);      ///< error of this file; unfolds the reading options that can resolve it

signals:
    void openRequested();
    void clearRequested();
    void itemRequested(const QString& name);
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
    std::optional<walk::Taken> taken_;
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

/// Whether one of the reading options settles this error of a reader, such as a unit that is not stated.
bool asksHowToRead(const ErrorCode& code);

/// "PLY binary · 732 000 points · unit mm": format, `amount`, and how the file was read.
QString understoodText(const io::FileFacts& facts, const QString& amount);

}  // namespace lathelier
