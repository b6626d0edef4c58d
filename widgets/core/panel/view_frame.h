// A view with its caption, laid out by PrimaryViews.
#pragma once

#include <QLabel>
#include <QWidget>
#include <optional>

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
    /// A small one handles only the click that enlarges it, has a smaller font, and hides children with the property
    /// onlyLarge.
    void setSmall(bool small);

    static constexpr const char* onlyLarge = "onlyLarge";
    static constexpr const char* smallView = "smallView";  ///< property of views that draw less when they are small
    void setCaptionVisible(bool visible);
    int captionHeight() const;

signals:
    void enlargeRequested();
    void allRequested();  ///< double click on the caption: show all views

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void arrange();
    void setTypeSize();

    QString key_;
    QWidget* view_;
    QLabel* caption_;
    QWidget* cover_;  ///< overlay of a small view that receives the click
    bool available_ = true;
    std::optional<bool> small_;
};

}  // namespace lathelier
