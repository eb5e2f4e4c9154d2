// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/values/settings_exchange.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr int version = 1;
const QString format = QStringLiteral("gripscope-settings");

struct ExchangeWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::SettingsExchange)
};

/// A value as it stands in the document.
QString asWritten(const QJsonValue& value)
{
    if (value.isString())
        return value.toString().left(40);
    if (value.isObject() || value.isArray())
        return ExchangeWords::tr("a list or an object");
    return value.isNull() ? u"null"_s : value.toVariant().toString();
}

void take(SettingsImport& import, const QString& key, const QJsonValue& value, const Settings& settings)
{
    const Setting* one = findSetting(key);
    if (!one) {
        import.notes << ExchangeWords::tr("\"%1\" is no setting of this version and is passed over.")
                            .arg(key.left(60));
        return;
    }
    if (!one->portable) {
        import.notes << ExchangeWords::tr("\"%1\" belongs to one computer and is passed over.").arg(key);
        return;
    }
    const std::optional<QVariant> good = one->accepted(value.toVariant());
    if (!good)
        import.errors << ExchangeWords::tr("\"%1\" (%2) is %3; expected %4.")
                             .arg(key, one->shownName(), asWritten(value), one->expected());
    else if (const QVariant before = settings.value(key); before != *good)
        import.changes.push_back({key, before, *good});
}

} // namespace

QByteArray exportedSettings(const Settings& settings)
{
    QJsonObject values;
    for (const Setting& one : allSettings())
        if (const QString key = QString::fromLatin1(one.key); one.portable)
            values.insert(key, QJsonValue::fromVariant(settings.value(key)));
    return QJsonDocument(QJsonObject{{u"format"_s, format}, {u"version"_s, version}, {u"settings"_s, values}})
        .toJson();
}

Expected<SettingsImport> readSettings(const QByteArray& document, const QString& file,
                                      const Settings& settings)
{
    QJsonParseError error;
    const QJsonDocument parsed = QJsonDocument::fromJson(document, &error);
    const auto bad = [&file](const QString& found, const QString& expected) {
        return failure(ErrorCode::BadInput, {file, found, expected});
    };
    if (error.error != QJsonParseError::NoError)
        return bad(error.errorString(), ExchangeWords::tr("expected settings that Gripscope exported"));
    const QJsonObject root = parsed.object();
    if (root[u"format"_s] != format || !root[u"settings"_s].isObject())
        return bad(ExchangeWords::tr("a document of another kind"),
                   ExchangeWords::tr("expected settings that Gripscope exported"));
    if (root[u"version"_s].toInt() != version)
        return bad(ExchangeWords::tr("version %1 of the format").arg(asWritten(root[u"version"_s])),
                   ExchangeWords::tr("expected version %1; a newer Gripscope reads newer ones").arg(version));
    SettingsImport import;
    const QJsonObject values = root[u"settings"_s].toObject();
    for (auto value = values.begin(); value != values.end(); ++value)
        take(import, value.key(), value.value(), settings);
    return import;
}

void applyImport(Settings& settings, const SettingsImport& import)
{
    if (!import.errors.isEmpty())
        return;
    for (const SettingChange& change : import.changes)
        (void)settings.setValue(change.key, change.after);
}

} // namespace gripscope
