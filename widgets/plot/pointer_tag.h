// Tag beside the pointer: the value in large type, its place below.
#pragma once

#include <QWidget>

namespace lathelier::plot {

class PointerTag : public QWidget {
    Q_OBJECT
public:
    /// Texts of the tag: value and place; no value: no tag.
    struct Words {
        QString value;
        QString place;
    };

    /// Transparent for pointer events.
    explicit PointerTag(QWidget* parent);

    /// Placed beside `pointer` (coordinates of the parent), fully inside the parent.
    void say(const Words& words, const QPoint& pointer);
    const Words& words() const { return words_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QFont large() const;

    Words words_;
};

}  // namespace lathelier::plot
