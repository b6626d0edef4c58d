// Layout of the views of a panel: one large (the primary view), the others small beside it. A click on a small one or
// 1…9 exchanges them, a double click on a caption shows all; in a narrow panel the small ones become tabs.
#pragma once

#include <QString>
#include <QStringList>
#include <QTabBar>
#include <QWidget>
#include <vector>

namespace lathelier {

/// A view with its caption; small ones handle only the click that enlarges them.
class ViewFrame;

class PrimaryViews : public QWidget {
    Q_OBJECT
public:
    explicit PrimaryViews(QWidget* parent = nullptr);

    /// Takes ownership of `view`. `key` is saved in the project and must be stable. The first view is large initially.
    void add(const QString& key, QWidget* view);
    void setTitle(const QString& key, const QString& title);
    void setAvailable(const QString& key, bool available);  ///< false: hidden, takes no space

    QString primary() const;
    QStringList keys() const;                 ///< keys of the available views in their order
    QString title(const QString& key) const;  ///< title of a view; empty: no such view
    void setPrimary(const QString& key);      ///< ignored for an unknown or unavailable view
    void setBeside(const QString& key);       ///< of a second large view before the primary one; empty: none
    bool showsAll() const { return all_; }
    void setShowsAll(bool all);
    void setPresenting(bool presenting);  ///< the large view alone; arrow keys go through all
    void step(int by);                    ///< moves to the next or a previous view, cyclically

    QSize minimumSizeHint() const override;

signals:
    void primaryChanged(const QString& key);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void arrange();
    std::vector<ViewFrame*> shown() const;
    bool isPair() const;
    void placeLarge(const QRect& room);
    ViewFrame* find(const QString& key) const;

    std::vector<ViewFrame*> frames_;  ///< in order of addition
    ViewFrame* primary_ = nullptr;
    ViewFrame* beside_ = nullptr;  ///< a second large view; null: none
    QTabBar* tabs_;
    bool all_ = false;
    bool presenting_ = false;
};

}  // namespace lathelier
