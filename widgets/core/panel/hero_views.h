// The views of a panel: one large, which tells the story, and the others small beside it. A click on a small one or
// 1…9 swaps, a double click on a caption shows all; where there is little room the small ones become tabs.
#pragma once

#include <QString>
#include <QStringList>
#include <QTabBar>
#include <QWidget>
#include <vector>

namespace lathelier {

/// A view with its caption; small ones take no pointer but a click that enlarges them.
class ViewFrame;

class HeroViews : public QWidget {
    Q_OBJECT
public:
    explicit HeroViews(QWidget* parent = nullptr);

    /// Takes `view` over. `key` is stable: the project keeps it. The first one is large at first.
    void add(const QString& key, QWidget* view);
    void setTitle(const QString& key, const QString& title);
    void setAvailable(const QString& key, bool available);  ///< false: has nothing to show, and takes no room

    QString hero() const;
    QStringList keys() const;                 ///< of the views that have something to show, in their order
    QString title(const QString& key) const;  ///< empty: no such view
    void setHero(const QString& key);         ///< no such view, or none to show: nothing happens
    bool showsAll() const { return all_; }
    void setShowsAll(bool all);
    void setPresenting(bool presenting);  ///< the large view alone; arrow keys go through all
    void step(int by);                    ///< to the next or an earlier view, round about

    QSize minimumSizeHint() const override;

signals:
    void heroChanged(const QString& key);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void arrange();
    std::vector<ViewFrame*> shown() const;
    ViewFrame* find(const QString& key) const;

    std::vector<ViewFrame*> frames_;  ///< in the order they were added
    ViewFrame* hero_ = nullptr;
    QTabBar* tabs_;
    bool all_ = false;
    bool presenting_ = false;
};

}  // namespace lathelier
