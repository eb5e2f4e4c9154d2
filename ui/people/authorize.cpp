// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/authorize.h"

#include "core/library/audit/audit_trail.h"
#include "core/people/audit_entry.h"
#include "core/recognition/verdict/rates_json.h"
#include "ui/context/sign_in.h"
#include "ui/context/workbench.h"
#include "ui/people/sign_in_dialog.h"
#include "ui/windows/question.h"

#include <QCoreApplication>
#include <QLineEdit>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct AuthorizeWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::AuthorizeWords)
};

} // namespace

void answerForPeople(Workbench& bench, QObject* window)
{
    QObject::connect(&bench, &Workbench::signInNeeded, window,
                     [&bench](QWidget* parent) { (new SignInDialog(bench, std::nullopt, parent))->open(); });
    QObject::connect(&bench, &Workbench::consentNeeded, window,
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

void askWhy(QWidget* parent, const QString& change, std::function<void(const QString& reason)> then)
{
    constexpr int longestReason = 200;
    auto* question = new TextQuestion(change, AuthorizeWords::tr("Why? The reason is kept with the change."),
                                      {}, AuthorizeWords::tr("Continue"), parent);
    question->setObjectName("whyQuestion");
    question->field()->setMaxLength(longestReason);
    question->requireText();
    QObject::connect(question, &TextQuestion::answered, parent,
                     [then = std::move(then)](const QString& reason) { then(reason.trimmed()); });
    question->open();
}

void authorizeRecorded(Workbench& bench, QWidget* parent, Permission permission, const QString& action,
                       const QString& subject, const QJsonObject& details, std::function<void()> then,
                       const QString& reason)
{
    authorize(bench, parent, permission, [=, &bench, then = std::move(then)] {
        // While nobody can refuse it, it need not wait for the disk.
        const bool first = !bench.signIn().inForce();
        if (first)
            then();
        bench.background().ask<void>(
            parent,
            [=](Library& library) {
                return library.auditTrail().record(permission, action, subject, details, reason);
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
    const auto change = [=, &bench, apply = std::move(apply)](const QString& reason) {
        authorizeRecorded(
            bench, parent, rates ? Permission::ChangeRates : Permission::ChangeSettings,
            QString::fromUtf16(rates ? audit_action::ratesChanged : audit_action::settingChanged),
            keys.join(u", "_s), details, apply, reason);
    };
    if (std::any_of(keys.begin(), keys.end(),
                    [](const QString& key) { return findSetting(key)->needsReason; }))
        askWhy(parent, AuthorizeWords::tr("Change these settings"), change);
    else
        change({});
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
    QJsonObject document = gripscope::toJson(stored.rates);
    document.insert(u"early_end"_s, stored.earlyEnd);
    return document;
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
    askWhy(parent, AuthorizeWords::tr("Change the rates"), [=, &bench](const QString& reason) {
        authorizeRecorded(
            bench, parent, Permission::ChangeRates, QString::fromUtf16(audit_action::ratesChanged), {},
            details, [&bench, rates] { bench.setRates(rates); }, reason);
    });
}

} // namespace gripscope
