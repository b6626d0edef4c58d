// The bar above the views of a surface: which picture, which reading of the marks, on to the lobes.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "widgets/surface/surface_picture.h"

class QButtonGroup;

namespace lathelier::surface_panel {

class SurfaceBar : public QWidget {
    Q_OBJECT

public:
    explicit SurfaceBar(QWidget* parent = nullptr);

    /// `chosen`: the picture that is shown, from 0.
    void setPicture(const SurfacePicture& picture, int chosen);
    QPushButton* sendButton() const { return send_; }
    void retranslate();

signals:
    void imageChosen(int image);
    void candidateWanted(double frequency_hz);
    void sendWanted();

private:
    void showCandidates(const SurfacePicture& picture);

    QButtonGroup* images_;
    QWidget* candidates_;
    QPushButton* send_;
    QLabel* synthetic_;
};

}  // namespace lathelier::surface_panel
