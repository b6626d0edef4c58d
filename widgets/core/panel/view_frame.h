// A view with its caption, as HeroViews lays it out.
#pragma once

#include <QLabel>
#include <QWidget>

namespace lathelier {

class ViewFrame : public QWidget {
    Q_OBJECT
public:
    ViewFrame(const QString& key, QWidget* view, QWidget* parent);

    const QString& key() const { return key_; }
    QWidget* view() const { return view_; }
    QString title() const { return caption_->text(); }
    void setTitle(const QString& title);
    bool isAvailable() const { return available_; }
    void setAvailable(bool available) { available_ = available; }
    void setSmall(bool small);  ///< a small one takes no pointer but the click that enlarges it
    void setCaptionVisible(bool visible);
    int captionHeight() const;

signals:
    void enlargeWanted();
    void allWanted();  ///< a double click on the caption

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void arrange();

    QString key_;
    QWidget* view_;
    QLabel* caption_;
    QWidget* cover_;  ///< over a small view: takes the click
    bool available_ = true;
    bool small_ = false;
};

}  // namespace lathelier
