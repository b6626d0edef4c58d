// Theme of the program: one style and two palettes, light and dark, following the system.
#pragma once

#include <QDBusVariant>
#include <QObject>

class QApplication;

namespace lathelier {

/// Sets Fusion with our palette: dark when the desktop asks for dark (freedesktop's colour-scheme, else the palette
/// the platform started with), and changes with the desktop while the program runs, unless the user chose one.
class Theme : public QObject {
    Q_OBJECT
public:
    explicit Theme(QApplication& application);

    /// "light" or "dark" whatever the desktop asks for; empty: as the desktop does.
    void choose(const QString& wanted);

private slots:
    void desktopChanged(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void apply();

    QString wanted_;
    bool desktopDark_ = false;
};

}  // namespace lathelier
