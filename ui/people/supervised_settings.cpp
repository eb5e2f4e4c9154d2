// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/supervised_settings.h"

#include "core/people/audit_entry.h"
#include "ui/people/authorize.h"
#include "ui/workbench.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

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

} // namespace gripscope
