// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/audit_entry.h"

#include "core/base/byte_writer.h"
#include "core/base/words.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>

#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString valueInWords(const QJsonValue& value)
{
    if (value.isString())
        return value.toString();
    if (value.isBool())
        return value.toBool() ? Words::tr("on") : Words::tr("off");
    if (value.isDouble())
        return QString::number(value.toDouble(), 'g', 6);
    if (value.isNull())
        return u"–"_s;
    QJsonDocument document;
    if (value.isArray())
        document.setArray(value.toArray());
    else
        document.setObject(value.toObject());
    return QString::fromUtf8(document.toJson(QJsonDocument::Compact));
}

} // namespace

QString firstPreviousHash()
{
    return QString(64, u'0');
}

QString auditHash(const AuditEntry& entry)
{
    ByteWriter out;
    out.text(u"gripscope-audit-1"_s);
    for (const QString& text :
         {entry.previousHash, QString::number(entry.number), entry.utc, entry.station, entry.person,
          entry.role, entry.action, entry.subject, entry.reason, entry.details})
        out.text(text);
    return QString::fromLatin1(QCryptographicHash::hash(out.bytes(), QCryptographicHash::Sha256).toHex());
}

QString actionInWords(const QString& action)
{
    static constexpr std::pair<const char*, const char*> words[] = {
        {"sign_in", QT_TRANSLATE_NOOP("Words", "Signed in")},
        {"sign_out", QT_TRANSLATE_NOOP("Words", "Signed out")},
        {"sign_in.failed", QT_TRANSLATE_NOOP("Words", "Wrong PIN or password")},
        {"authorised", QT_TRANSLATE_NOOP("Words", "Authorised")},
        {"person.added", QT_TRANSLATE_NOOP("Words", "Person added")},
        {"person.role", QT_TRANSLATE_NOOP("Words", "Role changed")},
        {"person.secret", QT_TRANSLATE_NOOP("Words", "PIN or password changed")},
        {"person.deactivated", QT_TRANSLATE_NOOP("Words", "Person deactivated")},
        {"person.reactivated", QT_TRANSLATE_NOOP("Words", "Person reactivated")},
        {"rates.changed", QT_TRANSLATE_NOOP("Words", "Rates changed")},
        {"setting.changed", QT_TRANSLATE_NOOP("Words", "Setting changed")},
        {"calibration.accepted", QT_TRANSLATE_NOOP("Words", "Calibration accepted")},
        {"calibration.reference", QT_TRANSLATE_NOOP("Words", "Reference object stated")},
        {"chain.measured", QT_TRANSLATE_NOOP("Words", "Gripper's channels measured")},
        {"policy.arming", QT_TRANSLATE_NOOP("Words", "Who may arm changed")},
        {"gripper.armed", QT_TRANSLATE_NOOP("Words", "Gripper armed")},
        {"clock.back", QT_TRANSLATE_NOOP("Words", "Clock was set back")},
        {"type.new_type", QT_TRANSLATE_NOOP("Words", "Type added")},
        {"type.squeeze", QT_TRANSLATE_NOOP("Words", "Squeeze enrolled")},
        {"type.drop", QT_TRANSLATE_NOOP("Words", "Squeeze dropped")},
        {"type.undrop", QT_TRANSLATE_NOOP("Words", "Squeeze put back")},
        {"type.recipe", QT_TRANSLATE_NOOP("Words", "Recipe changed")},
        {"type.approve", QT_TRANSLATE_NOOP("Words", "Type approved")},
        {"type.rename", QT_TRANSLATE_NOOP("Words", "Type renamed")},
        {"type.merge", QT_TRANSLATE_NOOP("Words", "Types merged")},
        {"type.split", QT_TRANSLATE_NOOP("Words", "Type split")},
        {"type.retire", QT_TRANSLATE_NOOP("Words", "Type retired")},
        {"type.reinstate", QT_TRANSLATE_NOOP("Words", "Type put back")},
        {"type.restore", QT_TRANSLATE_NOOP("Words", "Version restored")},
        {"type.examples", QT_TRANSLATE_NOOP("Words", "Example types added")},
    };
    for (const auto& [id, text] : words)
        if (action == QLatin1String(id))
            return Words::tr(text);
    return action;
}

QString detailsInWords(const AuditEntry& entry)
{
    const QJsonObject details = QJsonDocument::fromJson(entry.details.toUtf8()).object();
    QStringList parts;
    for (auto it = details.begin(); it != details.end(); ++it)
        parts += u"%1: %2"_s.arg(it.key(), valueInWords(it.value()));
    return parts.join(u", "_s);
}

} // namespace gripscope
