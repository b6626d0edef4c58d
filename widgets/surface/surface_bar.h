// The bar above the views of a surface: selected picture, interpretation of the marks, transfer to the lobes.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "widgets/surface/shown_outcome.h"

class QButtonGroup;

namespace lathelier::surface_panel {

class SurfaceBar : public QWidget {
    Q_OBJECT

public:
    explicit SurfaceBar(QWidget* parent = nullptr);

    /// `chosen`: the picture that is shown, from 0.
    void setOutcome(const ShownOutcome& outcome, int chosen);
    QPushButton* sendButton() const { return send_; }
    void retranslate();

signals:
    void imageChosen(int image);
    void candidateRequested(double frequency_hz);
    void sendRequested();

private:
    void showCandidates(const ShownOutcome& outcome);

    QButtonGroup* images_;
    QWidget* candidates_;
    QPushButton* send_;
    QLabel* synthetic_;
};

}  // namespace lathelier::surface_panel
