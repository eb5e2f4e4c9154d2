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

/// What a detail is called; one that this program does not know, by its key with spaces.
QString keyInWords(const QString& key)
{
    static constexpr std::pair<const char*, const char*> words[] = {
        {"active", QT_TRANSLATE_NOOP("Words", "may sign in")},
        {"address", QT_TRANSLATE_NOOP("Words", "address")},
        {"approval_void", QT_TRANSLATE_NOOP("Words", "its approval is void")},
        {"as_expected", QT_TRANSLATE_NOOP("Words", "as expected")},
        {"baseline", QT_TRANSLATE_NOOP("Words", "m, b, k of the empty gripper")},
        {"basis", QT_TRANSLATE_NOOP("Words", "measured by")},
        {"batch", QT_TRANSLATE_NOOP("Words", "batch")},
        {"by_itself", QT_TRANSLATE_NOOP("Words", "by itself, to make room")},
        {"bytes", QT_TRANSLATE_NOOP("Words", "bytes")},
        {"certificate", QT_TRANSLATE_NOOP("Words", "certificate")},
        {"centre", QT_TRANSLATE_NOOP("Words", "centre")},
        {"channel", QT_TRANSLATE_NOOP("Words", "channel")},
        {"chart", QT_TRANSLATE_NOOP("Words", "chart")},
        {"confidence", QT_TRANSLATE_NOOP("Words", "confidence")},
        {"chains", QT_TRANSLATE_NOOP("Words", "ends of its ledger")},
        {"conflicts", QT_TRANSLATE_NOOP("Words", "decided apart")},
        {"degree", QT_TRANSLATE_NOOP("Words", "degree")},
        {"due", QT_TRANSLATE_NOOP("Words", "holds until")},
        {"early_end", QT_TRANSLATE_NOOP("Words", "ends when decided")},
        {"false_reject", QT_TRANSLATE_NOOP("Words", "false reject")},
        {"file", QT_TRANSLATE_NOOP("Words", "file")},
        {"files", QT_TRANSLATE_NOOP("Words", "files")},
        {"first_inspection", QT_TRANSLATE_NOOP("Words", "from inspection")},
        {"force_lag_s", QT_TRANSLATE_NOOP("Words", "lag of the force in s")},
        {"force_lag_uncertainty_s", QT_TRANSLATE_NOOP("Words", "its standard uncertainty in s")},
        {"force_noise", QT_TRANSLATE_NOOP("Words", "noise of the force")},
        {"force_scale_uncertainty", QT_TRANSLATE_NOOP("Words", "uncertainty of the force's scale")},
        {"format", QT_TRANSLATE_NOOP("Words", "format")},
        {"frame_compliance", QT_TRANSLATE_NOOP("Words", "compliance of the frame")},
        {"frame_compliance_uncertainty", QT_TRANSLATE_NOOP("Words", "uncertainty of the frame's compliance")},
        {"friction", QT_TRANSLATE_NOOP("Words", "friction of the empty gripper")},
        {"from", QT_TRANSLATE_NOOP("Words", "from")},
        {"idle", QT_TRANSLATE_NOOP("Words", "after nothing was done")},
        {"inspections", QT_TRANSLATE_NOOP("Words", "inspections")},
        {"interval_h", QT_TRANSLATE_NOOP("Words", "hours that a check holds for")},
        {"kept_as", QT_TRANSLATE_NOOP("Words", "the library before is kept as")},
        {"kind", QT_TRANSLATE_NOOP("Words", "kind")},
        {"known_type", QT_TRANSLATE_NOOP("Words", "of a known type")},
        {"last_fixed_inspection", QT_TRANSLATE_NOOP("Words", "to inspection")},
        {"last_inspection", QT_TRANSLATE_NOOP("Words", "newest inspection of before")},
        {"last_version", QT_TRANSLATE_NOOP("Words", "newest enrolled squeeze of before, by its version")},
        {"name_there", QT_TRANSLATE_NOOP("Words", "name at the plant")},
        {"names", QT_TRANSLATE_NOOP("Words", "names")},
        {"operator", QT_TRANSLATE_NOOP("Words", "operator")},
        {"other", QT_TRANSLATE_NOOP("Words", "other type")},
        {"parts", QT_TRANSLATE_NOOP("Words", "parts")},
        {"points", QT_TRANSLATE_NOOP("Words", "points")},
        {"position_scale_uncertainty", QT_TRANSLATE_NOOP("Words", "uncertainty of the position's scale")},
        {"preload_n", QT_TRANSLATE_NOOP("Words", "preload")},
        {"push_n", QT_TRANSLATE_NOOP("Words", "push and release")},
        {"reference", QT_TRANSLATE_NOOP("Words", "reference")},
        {"robust", QT_TRANSLATE_NOOP("Words", "robust")},
        {"role", QT_TRANSLATE_NOOP("Words", "role")},
        {"row", QT_TRANSLATE_NOOP("Words", "squeeze of the plan")},
        {"rows", QT_TRANSLATE_NOOP("Words", "rows")},
        {"sigma", QT_TRANSLATE_NOOP("Words", "sigma")},
        {"squeezes", QT_TRANSLATE_NOOP("Words", "squeezes")},
        {"state", QT_TRANSLATE_NOOP("Words", "state")},
        {"stranger_accept", QT_TRANSLATE_NOOP("Words", "stranger accept")},
        {"to", QT_TRANSLATE_NOOP("Words", "to")},
        {"tolerance", QT_TRANSLATE_NOOP("Words", "may differ by")},
        {"type", QT_TRANSLATE_NOOP("Words", "type")},
        {"uncertainty", QT_TRANSLATE_NOOP("Words", "standard uncertainty")},
        {"value", QT_TRANSLATE_NOOP("Words", "stated")},
        {"verdict", QT_TRANSLATE_NOOP("Words", "verdict")},
        {"version", QT_TRANSLATE_NOOP("Words", "version")},
        {"wrong_type", QT_TRANSLATE_NOOP("Words", "wrong type")},
    };
    for (const auto& [id, text] : words)
        if (key == QLatin1String(id))
            return Words::tr(text);
    return QString(key).replace(u'_', u' ');
}

/// Texts that stand for one of a few things, as they are stored.
QString textInWords(const QString& text)
{
    static constexpr std::pair<const char*, const char*> words[] = {
        {"command line", QT_TRANSLATE_NOOP("Words", "command line")},
        {"signed_in", QT_TRANSLATE_NOOP("Words", "everybody who has signed in")},
        {"abandoned", QT_TRANSLATE_NOOP("Words", "abandoned")},
        {"finished", QT_TRANSLATE_NOOP("Words", "finished")},
        {"gauge", QT_TRANSLATE_NOOP("Words", "gauge repeatability and reproducibility")},
        {"type1", QT_TRANSLATE_NOOP("Words", "type-1 study")},
        {"linearity", QT_TRANSLATE_NOOP("Words", "linearity")},
        {"transfer", QT_TRANSLATE_NOOP("Words", "types on another gripper")},
        {"attributes", QT_TRANSLATE_NOOP("Words", "attribute agreement")},
        {"force", QT_TRANSLATE_NOOP("Words", "force")},
        {"failed", QT_TRANSLATE_NOOP("Words", "failed")},
        {"not_valid", QT_TRANSLATE_NOOP("Words", "not valid")},
        {"one_person", QT_TRANSLATE_NOOP("Words", "one person")},
        {"operator", QT_TRANSLATE_NOOP("Words", "operator")},
        {"passed", QT_TRANSLATE_NOOP("Words", "passed")},
        {"position", QT_TRANSLATE_NOOP("Words", "position")},
        {"second_person", QT_TRANSLATE_NOOP("Words", "a second person")},
        {"supervisor", QT_TRANSLATE_NOOP("Words", "supervisor")},
        {"supervisors", QT_TRANSLATE_NOOP("Words", "supervisors")},
        {"window", QT_TRANSLATE_NOOP("Words", "window")},
    };
    for (const auto& [id, said] : words)
        if (text == QLatin1String(id))
            return Words::tr(said);
    return text.isEmpty() ? u"–"_s : text;
}

bool isRate(const QString& key)
{
    return key == u"false_reject" || key == u"wrong_type" || key == u"stranger_accept" ||
           key == u"confidence";
}

QString objectInWords(const QJsonObject& details);

QString valueInWords(const QString& key, const QJsonValue& value)
{
    if (value.isString())
        return textInWords(value.toString());
    if (value.isBool())
        return value.toBool() ? Words::tr("yes") : Words::tr("no");
    if (value.isDouble())
        return isRate(key) ? Words::number(100 * value.toDouble(), 'g', 6) + QChar::Nbsp + u'%'
                           : Words::number(value.toDouble(), 'g', 15);
    if (value.isArray()) {
        QStringList parts;
        for (const auto& one : value.toArray())
            parts += valueInWords(key, one);
        return parts.join(u", "_s);
    }
    const QJsonObject object = value.toObject();
    if (object.size() == 2 && object.contains(u"from") && object.contains(u"to"))
        return Words::tr("%1 before, %2 now")
            .arg(valueInWords(key, object[u"from"]), valueInWords(key, object[u"to"]));
    return value.isObject() ? objectInWords(object) : u"–"_s;
}

QString objectInWords(const QJsonObject& details)
{
    QStringList parts;
    for (auto it = details.begin(); it != details.end(); ++it)
        parts += u"%1: %2"_s.arg(keyInWords(it.key()), valueInWords(it.key(), it.value()));
    return parts.join(u"; "_s);
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
        {"person.taken", QT_TRANSLATE_NOOP("Words", "Person as at the plant")},
        {"rates.changed", QT_TRANSLATE_NOOP("Words", "Rates changed")},
        {"setting.changed", QT_TRANSLATE_NOOP("Words", "Setting changed")},
        {"calibration.accepted", QT_TRANSLATE_NOOP("Words", "Calibration accepted")},
        {"calibration.reference", QT_TRANSLATE_NOOP("Words", "Reference object stated")},
        {"calibration.checked", QT_TRANSLATE_NOOP("Words", "Checked on the reference object")},
        {"chain.measured", QT_TRANSLATE_NOOP("Words", "Gripper's channels measured")},
        {"policy.arming", QT_TRANSLATE_NOOP("Words", "Who may arm changed")},
        {"policy.approval", QT_TRANSLATE_NOOP("Words", "Who may approve changed")},
        {"gripper.armed", QT_TRANSLATE_NOOP("Words", "Gripper armed")},
        {"inspection.voided", QT_TRANSLATE_NOOP("Words", "Inspection voided")},
        {"batch.begun", QT_TRANSLATE_NOOP("Words", "Batch begun")},
        {"batch.ended", QT_TRANSLATE_NOOP("Words", "Batch ended")},
        {"study.begun", QT_TRANSLATE_NOOP("Words", "Study begun")},
        {"study.ended", QT_TRANSLATE_NOOP("Words", "Study ended")},
        {"study.undone", QT_TRANSLATE_NOOP("Words", "Measurement of a study taken back")},
        {"adjustment.accepted", QT_TRANSLATE_NOOP("Words", "Gripper adjusted to types of another")},
        {"adjustment.withdrawn", QT_TRANSLATE_NOOP("Words", "Adjustment of a gripper withdrawn")},
        {"export.made", QT_TRANSLATE_NOOP("Words", "Exported")},
        {"library.backed_up", QT_TRANSLATE_NOOP("Words", "Library backed up")},
        {"library.restore_begun", QT_TRANSLATE_NOOP("Words", "Library put aside for a backup")},
        {"library.restored", QT_TRANSLATE_NOOP("Words", "Backup put back")},
        {"library.merged", QT_TRANSLATE_NOOP("Words", "Library of another station merged")},
        {"conflicts.seen", QT_TRANSLATE_NOOP("Words", "Conflicts between stations seen")},
        {"captures.pruned", QT_TRANSLATE_NOOP("Words", "Kept sessions removed")},
        {"profile.installed", QT_TRANSLATE_NOOP("Words", "Profile of a gripper installed")},
        {"charts.fixed", QT_TRANSLATE_NOOP("Words", "Limits of control charts fixed")},
        {"charts.released", QT_TRANSLATE_NOOP("Words", "Limits of control charts released")},
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
        {"type.limits", QT_TRANSLATE_NOOP("Words", "Tolerance limits changed")},
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
    return details.isEmpty() ? QString() : valueInWords({}, details);
}

} // namespace gripscope
