// The shop: what parts are made with, chosen by name; entries can be changed and added.
#pragma once

#include <QDialog>

#include "engine/shop/shop_file.h"

class QComboBox;
class QTabWidget;

namespace lathelier {

class ShopDialog : public QDialog {
    Q_OBJECT
public:
    explicit ShopDialog(const shop::StatedShop& stated, QWidget* parent = nullptr);

    const shop::StatedShop& shop() const { return shop_; }

    /// Reads SHOP.json in place of what is shown; an error is shown, and nothing changes.
    void read(const QString& path);

private:
    void fill();
    void askToRead();
    void askToWrite();

    shop::StatedShop shop_;
    QTabWidget* pages_;
    QComboBox* post_;
};

}  // namespace lathelier
