// One step of the strip: its title over its state, shown by symbol, text and colour.
#pragma once

#include <QAbstractButton>

#include "engine/chain/dossier.h"

namespace lathelier::chain_panel {

/// "✓", "?", "!", "✗", "○", "–".
QString signOf(const chain::StepStanding& standing);

/// In the language of the screen: "done", "out of tolerance", "not decided", "out of date", "failed", "not made yet",
/// "missing".
QString wordOf(const chain::StepStanding& standing);

class StepTile : public QAbstractButton {
    Q_OBJECT

public:
    explicit StepTile(QWidget* parent = nullptr);

    void say(const QString& title, const chain::StepStanding& standing);
    const chain::StepStanding& standing() const { return standing_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    chain::StepStanding standing_;
};

}  // namespace lathelier::chain_panel
