// A button that lets a drawn motion swing.
#pragma once

#include <QTimer>
#include <QToolButton>

namespace lathelier {

class SwingButton : public QToolButton {
    Q_OBJECT

public:
    explicit SwingButton(const char* name);

    double phaseOfSwing() const;  ///< rad; 0 at rest, where a motion stands at its largest
    void setWords(const QString& text, const QString& help);

signals:
    void moved();  ///< another phase is to be drawn

private:
    void play(bool on);

    QTimer clock_;
    int tick_ = 0;
};

}  // namespace lathelier
