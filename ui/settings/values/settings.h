// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/settings/values/setting.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>

class QSettings;

namespace gripscope {

/// What persons set, kept in an INI file from one start to the next. A stored value that cannot be used
/// counts as not set, and is told once. Lives on the screen's thread.
class Settings : public QObject {
    Q_OBJECT
public:
    /// Without a file nothing is kept beyond this run.
    explicit Settings(const QString& file = {}, QObject* parent = nullptr);
    ~Settings() override;

    /// The user's own, by the names of organisation and application.
    [[nodiscard]] static QString userFile();

    template <typename T>
    [[nodiscard]] T get(SettingKey<T> key) const
    {
        return value(QString::fromLatin1(key.key)).template value<T>();
    }
    template <typename T>
    void set(SettingKey<T> key, const T& value)
    {
        (void)setValue(QString::fromLatin1(key.key), value);
    }

    /// In force: what holds for this run, what is stored, or the default.
    [[nodiscard]] QVariant value(const QString& key) const;
    /// Stores it and ends what held for this run; false where the setting does not accept the value.
    bool setValue(const QString& key, const QVariant& value);
    /// For this run only, such as from the command line. Nothing is stored.
    bool setForThisRun(const QString& key, const QVariant& value);
    [[nodiscard]] bool isDefault(const QString& key) const;
    void reset(const QString& key);
    void resetAll(); ///< those that are shown

    /// One sentence for each stored value that could not be used; it and they are then forgotten.
    [[nodiscard]] QStringList takeProblems();

    /// Where the window keeps its state (ui/shell/desktop_session.h): no settings, so neither shown nor
    /// exported.
    [[nodiscard]] QByteArray windowState() const;
    void setWindowState(const QByteArray& state);
    /// What was said of tables of other programs (ui/imports/import_layouts.h); no setting either.
    [[nodiscard]] QByteArray importLayouts() const;
    void setImportLayouts(const QByteArray& layouts);

    /// Files that were opened (ui/library/recent_libraries.h); no setting either.
    [[nodiscard]] QStringList recentLibraries() const;
    void setRecentLibraries(const QStringList& files);

signals:
    void changed(const QString& key); ///< the value in force is another one

private:
    void read();
    void change(const QString& key, const std::function<void()>& how);
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
