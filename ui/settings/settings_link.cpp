// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/settings_link.h"

#include "devices/replay/capture_folder.h"
#include "ui/context/workbench.h"
#include "ui/settings/values/settings.h"
#include "ui/theme/theme.h"

using namespace Qt::StringLiterals;

namespace gripscope {

SettingsLink::SettingsLink(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(&workbench)
{
    Settings& settings = workbench.settings();
    for (const Setting& one : allSettings())
        apply(QString::fromLatin1(one.key));
    connect(&settings, &Settings::changed, this, &SettingsLink::apply);
    // What is set elsewhere; not what apply() itself set off.
    const auto store = [this](auto how) {
        return [this, how] {
            if (m_applying)
                return;
            m_applying = true;
            how(*m_workbench, m_workbench->settings());
            m_applying = false;
        };
    };
    connect(&workbench, &Workbench::operatorChanged, this, store([](Workbench& bench, Settings& kept) {
        kept.set(setting::operatorName, bench.operatorName());
    }));
    connect(&workbench, &Workbench::ratesChanged, this,
            store([](Workbench& bench, Settings& kept) { writeRates(kept, bench.rates()); }));
    connect(&workbench, &Workbench::keepingChanged, this, store([](Workbench& bench, Settings& kept) {
        kept.set(setting::keepSessions, bench.keepsSessions());
    }));
    connect(&workbench, &Workbench::connectionChanged, this, &SettingsLink::rememberGripper);
}

void SettingsLink::apply(const QString& key)
{
    if (m_applying)
        return;
    m_applying = true;
    const Settings& settings = m_workbench->settings();
    if (key == QLatin1String(setting::theme.key))
        Theme::instance().apply(themeKindFromString(settings.get(setting::theme)).value_or(ThemeKind::Light));
    else if (key == QLatin1String(setting::operatorName.key))
        m_workbench->setOperatorName(settings.get(setting::operatorName));
    else if (key.startsWith("rates/"_L1))
        m_workbench->setRates(readRates(settings));
    else if (key == QLatin1String(setting::refuseOverdue.key) ||
             key == QLatin1String(setting::mostLostShare.key) ||
             key == QLatin1String(setting::onlySignedIn.key))
        m_workbench->setJudgingPolicy(
            {settings.get(setting::refuseOverdue), settings.get(setting::mostLostShare), false},
            settings.get(setting::onlySignedIn));
    else if (key.startsWith("captures/"_L1))
        applyKeeping();
    m_applying = false;
}

void SettingsLink::applyKeeping()
{
    const Settings& settings = m_workbench->settings();
    KeepSessions keep;
    keep.folder = settings.get(setting::captureFolder);
    if (keep.folder.isEmpty())
        keep.folder = CaptureFolder::defaultPath();
    keep.limits.totalBytes = static_cast<qint64>(1e6 * settings.get(setting::captureMegabytes));
    m_workbench->setKeeping(keep, settings.get(setting::keepSessions));
}

void SettingsLink::rememberGripper()
{
    const ConnectSession& connection = m_workbench->connection();
    if (connection.state() != ConnectSession::State::Connected)
        return;
    const QString address = connection.identity().address;
    if (address.startsWith("hid:"_L1)) // by its serial number
        m_workbench->settings().set(setting::lastGripper, address);
    else if (address.startsWith("virtual:"_L1))
        m_workbench->settings().set(setting::lastGripper, u"virtual:"_s);
}

QString SettingsLink::addressAtStart(Workbench& workbench)
{
    const Settings& settings = workbench.settings();
    const QString what = settings.get(setting::connectAtStart);
    if (what == "nothing"_L1)
        return {};
    const QString last = settings.get(setting::lastGripper);
    return what == "last"_L1 && !last.isEmpty() ? last : u"virtual:"_s;
}

} // namespace gripscope
