// What a panel shows before and while there is an answer: the empty state, the progress row, the dimming.
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

signals:
    void openWanted();
    void sampleWanted();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void retranslate();

    QLabel* sentence_;
    QLabel* missing_;
    QPushButton* open_;
    QPushButton* sample_;
};

/// Under the views: how far the computation is, its phase and Cancel; beside it what can be done with the result.
/// It keeps its height, so that nothing jumps.
class ProgressRow : public QWidget {
    Q_OBJECT
public:
    explicit ProgressRow(QWidget* parent = nullptr);
    void showState(const Worker::State& state);
    void setResultThere(bool there);
    void setInReport(bool in);
    QMenu* exportMenu() const { return exportMenu_; }

signals:
    void cancelWanted();
    void addToReportToggled(bool in);
    void reportWanted(const QString& suffix);  ///< "html" or "pdf"

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

/// A veil over its parent: the old picture stays, dimmed. Lets the mouse through.
class Shade : public QWidget {
    Q_OBJECT
public:
    explicit Shade(QWidget* covered);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace lathelier
