// One step of the strip: its title over its state, shown by symbol, text and colour.
#pragma once

#include <QAbstractButton>

#include "engine/chain/dossier.h"

namespace lathelier::chain_panel {

/// "✓", "!", "✗", "○", "–".
QString signOf(chain::StepState state);

/// In the language of the screen: "done", "out of date", "failed", "not made yet", "missing".
QString wordOf(chain::StepState state);

class StepTile : public QAbstractButton {
    Q_OBJECT

public:
    explicit StepTile(QWidget* parent = nullptr);

    void say(const QString& title, chain::StepState state);
    chain::StepState state() const { return state_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    chain::StepState state_ = chain::StepState::Missing;
};

}  // namespace lathelier::chain_panel
