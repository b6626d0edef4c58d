// A bar of buttons and fields that wraps into further rows.
#pragma once

#include <QLayout>
#include <vector>

namespace lathelier {

/// Items are placed from left to right at their preferred width and wrap into further rows. The widget of setTrailing()
/// is at the right end of the first row with space for it.
class FlowRow : public QLayout {
    Q_OBJECT
public:
    explicit FlowRow(QWidget* parent = nullptr);
    ~FlowRow() override;

    void setTrailing(QWidget* widget);

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(items_.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override { return place({0, 0, width, 0}, false); }
    QSize sizeHint() const override;
    QSize minimumSize() const override;  ///< size of the widest item
    void setGeometry(const QRect& room) override;

private:
    int place(const QRect& room, bool move) const;

    std::vector<QLayoutItem*> items_;
    QWidget* trailing_ = nullptr;
};

}  // namespace lathelier
