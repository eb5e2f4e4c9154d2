// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/values/settings.h"

#include <QCoreApplication>
#include <QSettings>

#include <utility>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

const QString windowKey = QStringLiteral("window/state");
const QString importKey = QStringLiteral("import/layouts");
const QString librariesKey = QStringLiteral("library/recent");

} // namespace

struct Settings::Private {
    explicit Private(std::unique_ptr<QSettings> file) : store(std::move(file)) {}
    std::unique_ptr<QSettings> store; ///< none: kept nowhere
    QVariantMap stored;               ///< accepted ones only
    QVariantMap overrides;            ///< for this run
    QByteArray window, imports;
    QStringList libraries;
    QStringList problems, damaged; ///< sentences and keys
};

Settings::Settings(const QString& file, QObject* parent)
    : QObject(parent),
      d(std::make_unique<Private>(file.isEmpty() ? nullptr
                                                 : std::make_unique<QSettings>(file, QSettings::IniFormat)))
{
    if (d->store)
        read();
}

Settings::~Settings() = default;

QString Settings::userFile()
{
    return QSettings(QSettings::IniFormat, QSettings::UserScope, QCoreApplication::organizationName(),
                     QCoreApplication::applicationName())
        .fileName();
}

void Settings::read()
{
    if (d->store->status() != QSettings::NoError)
        d->problems << tr("The settings in %1 cannot be read. The defaults are used; what you change now may "
                          "not be kept. Check that file.")
                           .arg(d->store->fileName());
    for (const Setting& one : allSettings()) {
        const QString key = QString::fromLatin1(one.key);
        if (!d->store->contains(key))
            continue;
        const QVariant raw = d->store->value(key);
        if (const std::optional<QVariant> good = one.accepted(raw)) {
            d->stored.insert(key, *good);
            continue;
        }
        d->problems
            << tr("The setting \"%1\" was stored as \"%2\", which cannot be used: expected %3. It is back at "
                  "its default, %4.")
                   .arg(one.shownName(), raw.toString().left(40), one.expected(),
                        one.shownValue(one.fallback));
        d->damaged << key;
    }
}

QVariant Settings::value(const QString& key) const
{
    const Setting* one = findSetting(key);
    if (!one)
        return {};
    if (const auto found = d->overrides.constFind(key); found != d->overrides.constEnd())
        return *found;
    return d->stored.value(key, one->fallback);
}

void Settings::change(const QString& key, const std::function<void()>& how)
{
    const QVariant before = value(key);
    how();
    if (value(key) != before)
        emit changed(key);
}

bool Settings::setValue(const QString& key, const QVariant& value)
{
    const Setting* one = findSetting(key);
    const std::optional<QVariant> good = one ? one->accepted(value) : std::nullopt;
    if (!good)
        return false;
    change(key, [&] {
        d->overrides.remove(key);
        d->stored.insert(key, *good);
        if (d->store)
            d->store->setValue(key, *good);
    });
    return true;
}

bool Settings::setForThisRun(const QString& key, const QVariant& value)
{
    const Setting* one = findSetting(key);
    const std::optional<QVariant> good = one ? one->accepted(value) : std::nullopt;
    if (!good)
        return false;
    change(key, [&] { d->overrides.insert(key, *good); });
    return true;
}

bool Settings::isDefault(const QString& key) const
{
    const Setting* one = findSetting(key);
    return one && value(key) == one->fallback;
}

void Settings::reset(const QString& key)
{
    change(key, [&] {
        d->overrides.remove(key);
        d->stored.remove(key);
        if (d->store)
            d->store->remove(key);
    });
}

void Settings::resetAll()
{
    for (const Setting& one : allSettings())
        if (one.shown)
            reset(QString::fromLatin1(one.key));
}

QStringList Settings::takeProblems()
{
    for (const QString& key : std::exchange(d->damaged, {}))
        if (!d->stored.contains(key)) // nobody set it since
            d->store->remove(key);
    return std::exchange(d->problems, {});
}

QByteArray Settings::windowState() const
{
    return d->store ? d->store->value(windowKey).toByteArray() : d->window;
}

void Settings::setWindowState(const QByteArray& state)
{
    if (d->store)
        d->store->setValue(windowKey, state);
    d->window = state;
}

QByteArray Settings::importLayouts() const
{
    return d->store ? d->store->value(importKey).toByteArray() : d->imports;
}

void Settings::setImportLayouts(const QByteArray& layouts)
{
    if (d->store)
        d->store->setValue(importKey, layouts);
    d->imports = layouts;
}

QStringList Settings::recentLibraries() const
{
    return d->store ? d->store->value(librariesKey).toStringList() : d->libraries;
}

void Settings::setRecentLibraries(const QStringList& files)
{
    if (d->store)
        d->store->setValue(librariesKey, files);
    d->libraries = files;
}

} // namespace gripscope
