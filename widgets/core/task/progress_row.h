// Empty state, progress row and dimming of a panel.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

#include "widgets/core/task/worker.h"

namespace lathelier {

/// One sentence on what to drop here, "Open…" and "Open the sample".
class EmptyState : public QWidget {
    Q_OBJECT
public:
    explicit EmptyState(QWidget* parent = nullptr);
    void setInvitation(const QString& sentence, const QString& missing);
    void setWaiting(bool waiting);  ///< for the first result: nothing to be done here

signals:
    void openRequested();
    void sampleRequested();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void retranslate();
    void refresh();

    QString invitation_;
    bool waiting_ = false;
    QLabel* sentence_;
    QLabel* missing_;
    QPushButton* open_;
    QPushButton* sample_;
};

/// Row below the views: progress of the computation, its phase and Cancel; beside it actions on the result. Constant
/// height, so that the layout is stable.
class ProgressRow : public QWidget {
    Q_OBJECT
public:
    explicit ProgressRow(QWidget* parent = nullptr);
    void showState(const Worker::State& state);
    void setResultThere(bool there);
    void setInReport(bool in);
    QMenu* exportMenu() const { return exportMenu_; }

signals:
    void cancelRequested();
    void addToReportToggled(bool in);
    void reportRequested(const QString& suffix);  ///< request for a report, "html" or "pdf"

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QLabel* phase_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QToolButton* export_;
    QMenu* exportMenu_;
    QToolButton* inReport_;
    QToolButton* report_;
    QAction* html_;
    QAction* pdf_;
};

/// Overlay that dims the old result. Transparent for mouse events.
class Shade : public QWidget {
    Q_OBJECT
public:
    explicit Shade(QWidget* covered);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace lathelier
