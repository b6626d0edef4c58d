// What lies under the pointer, beside the pointer: the value large, its place below.
#pragma once

#include <QWidget>

namespace lathelier::plot {

class PointerTag : public QWidget {
    Q_OBJECT
public:
    /// The value that a person asks for by pointing, and where it is; no value: no tag.
    struct Words {
        QString value;
        QString place;
    };

    /// Takes no pointer events.
    explicit PointerTag(QWidget* parent);

    /// Beside `pointer`, in coordinates of the parent, whole within it.
    void say(const Words& words, const QPoint& pointer);
    const Words& words() const { return words_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QFont large() const;

    Words words_;
};

}  // namespace lathelier::plot
