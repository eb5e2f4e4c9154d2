// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/settings/values/setting.h"

#include "core/base/words.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr qsizetype longestText = 1000;

struct SettingWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::Setting)
};

/// Words of the table, which holds them untranslated.
QString settingWord(const char* text)
{
    return QCoreApplication::translate("gripscope::Setting", text);
}

QString withUnit(double value, const Setting& setting)
{
    const QString number = Words::number(value * setting.factor, 'g', 8);
    const QString unit = QString::fromUtf8(setting.unit);
    return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unit;
}

std::optional<QVariant> asSwitch(const QVariant& value)
{
    if (value.typeId() == QMetaType::Bool)
        return value;
    const QString text = value.toString();
    if (text == "true"_L1 || text == "1"_L1)
        return true;
    if (text == "false"_L1 || text == "0"_L1)
        return false;
    return {};
}

std::optional<QVariant> asNumber(const QVariant& value, const Setting& setting)
{
    bool isNumber = value.typeId() != QMetaType::Bool;
    const double number = isNumber ? value.toDouble(&isNumber) : 0;
    if (!isNumber || !std::isfinite(number))
        return {};
    if (number == 0 && setting.zeroMeans)
        return 0.0;
    const double slack = 1e-9 * setting.most; // what a decimal fraction loses
    if (number < setting.least - slack || number > setting.most + slack)
        return {};
    return number;
}

std::optional<QVariant> asText(const QVariant& value)
{
    if (value.typeId() != QMetaType::QString)
        return {};
    const QString text = value.toString();
    const bool clean = std::all_of(text.begin(), text.end(),
                                   [](QChar c) { return c.isPrint() || c == QChar(QChar::Space); });
    return clean && text.size() <= longestText ? std::optional<QVariant>(text) : std::nullopt;
}

} // namespace

QString Setting::shownName() const
{
    return settingWord(name);
}

QString Setting::shownExplanation() const
{
    const QString said = settingWord(explanation);
    switch (applies) {
    case SettingApplies::NextConnection:
        return SettingWords::tr("%1 From the next connection on.").arg(said);
    case SettingApplies::NextStart:
        return SettingWords::tr("%1 From the next start on.").arg(said);
    case SettingApplies::AtOnce:
        break;
    }
    return said;
}

QString Setting::shownValue(const QVariant& value) const
{
    switch (kind) {
    case SettingKind::Switch:
        return value.toBool() ? SettingWords::tr("on") : SettingWords::tr("off");
    case SettingKind::Choice:
        for (const SettingChoice& choice : choices)
            if (value.toString() == QLatin1String(choice.value))
                return choicesAreNames ? QString::fromLatin1(choice.words) : settingWord(choice.words);
        break;
    case SettingKind::Number:
        return value.toDouble() == 0 && zeroMeans ? settingWord(zeroMeans)
                                                  : withUnit(value.toDouble(), *this);
    case SettingKind::Text:
    case SettingKind::Folder:
    case SettingKind::Picture:
    case SettingKind::File:
        return value.toString().isEmpty() ? SettingWords::tr("empty") : value.toString();
    }
    return value.toString();
}

std::optional<QVariant> Setting::accepted(const QVariant& value) const
{
    switch (kind) {
    case SettingKind::Switch:
        return asSwitch(value);
    case SettingKind::Choice:
        for (const SettingChoice& choice : choices)
            if (value.toString() == QLatin1String(choice.value))
                return value.toString();
        return {};
    case SettingKind::Number:
        return asNumber(value, *this);
    case SettingKind::Text:
    case SettingKind::Folder:
    case SettingKind::Picture:
    case SettingKind::File:
        return refuses && refuses(value.toString()) ? std::nullopt : asText(value);
    }
    return {};
}

QString Setting::whyNot(const QVariant& value) const
{
    if (refuses)
        if (const std::optional<QString> why = refuses(value.toString()))
            return *why;
    return SettingWords::tr("%1 takes %2.").arg(shownName(), expected());
}

QString Setting::expected() const
{
    switch (kind) {
    case SettingKind::Switch:
        return SettingWords::tr("true or false");
    case SettingKind::Choice: {
        QStringList values;
        for (const SettingChoice& choice : choices)
            values << QLatin1String(choice.value);
        return SettingWords::tr("one of %1").arg(values.join(u", "_s));
    }
    case SettingKind::Number: {
        const QString from = QLocale::c().toString(least), to = QLocale::c().toString(most);
        return zeroMeans ? SettingWords::tr("0, or a number from %1 to %2").arg(from, to)
                         : SettingWords::tr("a number from %1 to %2").arg(from, to);
    }
    case SettingKind::Text:
    case SettingKind::Folder:
    case SettingKind::Picture:
    case SettingKind::File:
        return SettingWords::tr("a text of up to %1 letters").arg(longestText);
    }
    return {};
}

const Setting* findSetting(const QString& key)
{
    const std::vector<Setting>& all = allSettings();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&key](const Setting& one) { return key == QLatin1String(one.key); });
    return found == all.end() ? nullptr : &*found;
}

QString settingGroupName(SettingGroup group)
{
    switch (group) {
    case SettingGroup::Appearance:
        return SettingWords::tr("Appearance");
    case SettingGroup::Inspecting:
        return SettingWords::tr("Inspecting");
    case SettingGroup::Rates:
        return SettingWords::tr("Rates");
    case SettingGroup::Studies:
        return SettingWords::tr("Studies of the gripper");
    case SettingGroup::Sessions:
        return SettingWords::tr("Kept sessions");
    case SettingGroup::Start:
        return SettingWords::tr("At the start");
    case SettingGroup::People:
        return SettingWords::tr("People");
    case SettingGroup::Reports:
        return SettingWords::tr("Reports and certificates");
    case SettingGroup::Line:
        return SettingWords::tr("Line");
    case SettingGroup::Broker:
        return SettingWords::tr("Results to a broker (MQTT)");
    case SettingGroup::Plant:
        return SettingWords::tr("Library of the plant");
    }
    return {};
}

} // namespace gripscope
