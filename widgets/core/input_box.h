// One input file of a panel: which file, what was understood of it, and how to read it.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "widgets/core/panel_facts.h"
#include "widgets/core/scan_store.h"

namespace lathelier {

class Form;

/// Shows a Source and lets the user choose, drop, clear it, and settle what its file leaves open. Changes nothing by
/// itself: the panel does, through the session.
class InputBox : public QWidget {
    Q_OBJECT
public:
    explicit InputBox(const InputRole& role, QWidget* parent = nullptr);

    void setSource(const std::optional<Source>& source);
    void setUnderstood(const LoadedScanPtr& scan);  ///< nullptr: not read (yet)
    void setProblem(const Error* error);            ///< of this file; unfolds the reading options when they settle it

signals:
    void openWanted();
    void clearWanted();
    void fileDropped(const QString& path);
    void importChanged(const lathelier::Values& import);

protected:
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void retranslate();
    void refresh();
    QString understoodText() const;

    InputRole role_;
    std::optional<Source> source_;
    LoadedScanPtr scan_;
    bool problem_ = false;
    QLabel* title_;
    QLabel* file_;
    QLabel* facts_;
    QToolButton* open_;
    QToolButton* clear_;
    QToolButton* how_;
    Form* import_;
};

}  // namespace lathelier
