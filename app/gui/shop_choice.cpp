#include "app/gui/shop_choice.h"

#include <QCoreApplication>
#include <QSettings>
#include <optional>

#include "widgets/core/session.h"

namespace lathelier {
namespace {

constexpr const char* shopKey = shop::shopTextKey;  ///< in the settings too

std::optional<shop::StatedShop> read(const std::string& text)
{
    if (text.empty()) return std::nullopt;
    try {
        Notes notes;
        shop::StatedShop found = shop::readShop(text, notes);
        (void)found.shop();  // every entry that it names is there
        return found;
    } catch (const Error&) {
        return std::nullopt;
    }
}

shop::StatedShop shopOfSettings()
{
    return read(QSettings().value(shopKey).toString().toStdString()).value_or(shop::StatedShop{});
}

}  // namespace

shop::StatedShop shopOf(const project::Project& project)
{
    const Value* const kept = find(project.shop, shopKey);
    const auto* const text = kept ? std::get_if<std::string>(kept) : nullptr;
    if (text)
        if (auto own = read(*text)) return *std::move(own);
    return shopOfSettings();
}

Values startingShop()
{
    return {{shopKey, shop::shopText(shopOfSettings())}};
}

void keepShop(Session& session, const shop::StatedShop& shop)
{
    const std::string text = shop::shopText(shop);
    QSettings().setValue(shopKey, QString::fromStdString(text));
    session.setStartingShop(startingShop());
    session.edit(QCoreApplication::translate("lathelier::ShopDialog", "Choose the shop"),
                 [&](project::Project& project) { set(project.shop, shopKey, text); });
}

}  // namespace lathelier
