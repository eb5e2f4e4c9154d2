// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/authorize.h"

#include "core/library/audit/audit_trail.h"
#include "core/people/audit_entry.h"
#include "ui/context/sign_in.h"
#include "ui/context/workbench.h"
#include "ui/people/sign_in_dialog.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

void answerForPeople(Workbench& bench)
{
    QObject::connect(&bench, &Workbench::signInNeeded, &bench,
                     [&bench](QWidget* parent) { (new SignInDialog(bench, std::nullopt, parent))->open(); });
    QObject::connect(&bench, &Workbench::consentNeeded, &bench,
                     [&bench](QWidget* parent, Permission permission, const std::function<void()>& then) {
                         authorize(bench, parent, permission, then);
                     });
}

void authorize(Workbench& bench, QWidget* parent, Permission permission, std::function<void()> then)
{
    if (bench.signIn().may(permission)) {
        then();
        return;
    }
    auto* dialog = new SignInDialog(bench, permission, parent);
    QObject::connect(
        dialog, &SignInDialog::authorised, parent,
        [&bench, then = std::move(then)](const Grant& grant) { bench.signIn().withGrant(grant, then); });
    dialog->open();
}

void authorizeRecorded(Workbench& bench, QWidget* parent, Permission permission, const QString& action,
                       const QString& subject, const QJsonObject& details, std::function<void()> then)
{
    authorize(bench, parent, permission, [=, &bench, then = std::move(then)] {
        // While nobody can refuse it, it need not wait for the disk.
        const bool first = !bench.signIn().inForce();
        if (first)
            then();
        bench.background().ask<void>(
            parent,
            [=](Library& library) {
                return library.auditTrail().record(permission, action, subject, details);
            },
            [&bench, first, then](const Expected<void>& told) {
                if (!told)
                    bench.messages().report(told.error().describe());
                else if (!first)
                    then();
            });
    });
}

void changeSettings(Workbench& bench, QWidget* parent, const std::vector<SettingChange>& changes,
                    std::function<void()> apply)
{
    QJsonObject details;
    for (const SettingChange& change : changes)
        if (const Setting* one = findSetting(change.key); one && one->needsSupervisor)
            details.insert(change.key, QJsonObject{{u"from"_s, QJsonValue::fromVariant(change.before)},
                                                   {u"to"_s, QJsonValue::fromVariant(change.after)}});
    if (details.isEmpty())
        return apply();
    const QStringList keys = details.keys();
    const bool rates =
        std::all_of(keys.begin(), keys.end(), [](const QString& key) { return key.startsWith("rates/"_L1); });
    authorizeRecorded(bench, parent, rates ? Permission::ChangeRates : Permission::ChangeSettings,
                      QString::fromUtf16(rates ? audit_action::ratesChanged : audit_action::settingChanged),
                      keys.join(u", "_s), details, std::move(apply));
}

std::vector<SettingChange> changesOfReset(const Settings& settings)
{
    std::vector<SettingChange> changes;
    for (const Setting& one : allSettings())
        if (const QString key = QString::fromLatin1(one.key); one.shown && !settings.isDefault(key))
            changes.push_back({key, settings.value(key), one.fallback});
    return changes;
}

namespace {

QJsonObject toJson(const StoredRates& stored)
{
    const VerdictOptions& rates = stored.rates;
    return {{u"false_reject"_s, rates.falseReject},
            {u"wrong_type"_s, rates.wrongType},
            {u"stranger_accept"_s, rates.strangerAccept},
            {u"confidence"_s, rates.confidence ? QJsonValue(*rates.confidence) : QJsonValue()},
            {u"robust"_s, rates.robust},
            {u"early_end"_s, stored.earlyEnd}};
}

} // namespace

void changeRates(Workbench& bench, QWidget* parent, const StoredRates& rates)
{
    const QJsonObject before = toJson(bench.rates());
    const QJsonObject after = toJson(rates);
    if (before == after)
        return;
    QJsonObject details; // only what differs, so that it can be read
    for (auto it = after.begin(); it != after.end(); ++it)
        if (before.value(it.key()) != it.value())
            details.insert(it.key(), QJsonObject{{u"from"_s, before.value(it.key())}, {u"to"_s, it.value()}});
    authorizeRecorded(bench, parent, Permission::ChangeRates, QString::fromUtf16(audit_action::ratesChanged),
                      {}, details, [&bench, rates] { bench.setRates(rates); });
}

} // namespace gripscope
