// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVariant>

#include <optional>
#include <vector>

namespace gripscope {

enum class SettingKind { Switch, Choice, Number, Text, Folder, Picture, File };
enum class SettingGroup {
    Appearance,
    Inspecting,
    Rates,
    Studies,
    Sessions,
    Start,
    People,
    Reports,
    Line,
    Broker,
    Plant
};
enum class SettingApplies { AtOnce, NextConnection, NextStart };

/// One of what a Choice may be: its stored word and what a person reads.
struct SettingChoice {
    const char* value;
    const char* words; ///< to be translated, unless Setting::choicesAreNames
};

/// One setting, declared once (setting_table.cpp). Typed access, the limits that are held, the Settings
/// window, export and import all come from this.
struct Setting {
    const char* key; ///< as stored and exported; never changed once released
    SettingKind kind;
    QVariant fallback;
    SettingGroup group;
    const char* name;        ///< to be translated
    const char* explanation; ///< to be translated: one sentence
    SettingApplies applies = SettingApplies::AtOnce;
    bool needsSupervisor = false;
    bool shown = true;    ///< in the Settings window; others are set where they are used
    bool portable = true; ///< exported; what belongs to this computer alone is not

    // Of numbers: limits as stored; `factor` leads to the unit that is shown.
    double least = 0, most = 0, factor = 1;
    int decimals = 0;
    const char* unit = "";                   ///< in UTF-8; the same in every language
    const char* zeroMeans = nullptr;         ///< to be translated: shown in place of 0
    std::vector<SettingChoice> choices = {}; ///< of a Choice
    bool choicesAreNames = false;            ///< or numbers: the same in every language
    bool needsReason = false;                ///< asked for where verdicts or squeezes depend on it
    /// Of a text: why it cannot be one, as a sentence. A text with a secret in it is not kept anywhere.
    std::optional<QString> (*refuses)(const QString& text) = nullptr;

    [[nodiscard]] QString shownName() const;
    [[nodiscard]] QString shownExplanation() const;                ///< and when it takes effect
    [[nodiscard]] QString shownValue(const QVariant& value) const; ///< "on", "Dark", "1 %"
    /// The value in the type of this setting, or none where it is not one of its kind or outside its limits.
    [[nodiscard]] std::optional<QVariant> accepted(const QVariant& value) const;
    [[nodiscard]] QString whyNot(const QVariant& value) const; ///< where accepted() has none, as a sentence
    [[nodiscard]] QString expected() const; ///< what accepted() takes: "a number from 0 to 240 min"
};

/// All of them, in the order in which they are shown.
[[nodiscard]] const std::vector<Setting>& allSettings();
[[nodiscard]] const Setting* findSetting(const QString& key);
[[nodiscard]] QString settingGroupName(SettingGroup group);

/// A key with the type of its value, so that nobody reads a number where a word is stored.
template <typename T>
struct SettingKey {
    const char* key;
};

namespace setting {
inline constexpr SettingKey<QString> theme{"theme"};             ///< light, dark, contrast
inline constexpr SettingKey<QString> language{"language"};       ///< en, de
inline constexpr SettingKey<QString> scale{"scale"};             ///< 100, 125, 150, 200 (percent)
inline constexpr SettingKey<QString> forceUnit{"units/force"};   ///< one of forceUnitChoices
inline constexpr SettingKey<QString> lengthUnit{"units/length"}; ///< one of lengthUnitChoices
inline constexpr SettingKey<double> disarmMinutes{"inspecting/disarmMinutes"};
inline constexpr SettingKey<double> invalidInARow{"inspecting/invalidInARow"};
inline constexpr SettingKey<bool> partNumbers{"inspecting/partNumbers"};
inline constexpr SettingKey<bool> automaticSqueeze{"inspecting/automaticSqueeze"};
inline constexpr SettingKey<double> touchTimes{"inspecting/touchTimes"};      ///< the noise of the idle force
inline constexpr SettingKey<QString> expectedType{"inspecting/expectedType"}; ///< by name
inline constexpr SettingKey<QString> shiftStart{"inspecting/shiftStart"};     ///< see shift_start.h
inline constexpr SettingKey<bool> stopExplained{"start/stopExplained"};       ///< and read
inline constexpr SettingKey<bool> soundOnVerdict{"soundOnVerdict"};
inline constexpr SettingKey<double> falseReject{"rates/falseReject"};       ///< share
inline constexpr SettingKey<double> wrongType{"rates/wrongType"};           ///< share
inline constexpr SettingKey<double> strangerAccept{"rates/strangerAccept"}; ///< share
inline constexpr SettingKey<double> confidence{"rates/confidence"};         ///< 0: on average
inline constexpr SettingKey<bool> robust{"rates/robust"};
inline constexpr SettingKey<bool> earlyEnd{"rates/earlyEnd"};
inline constexpr SettingKey<bool> refuseOverdue{"inspecting/refuseOverdue"};
// Months until a study is due again; 0: never
inline constexpr SettingKey<double> typeOneMonths{"quality/typeOneMonths"};
inline constexpr SettingKey<double> gaugeMonths{"quality/gaugeMonths"};
inline constexpr SettingKey<double> linearityMonths{"quality/linearityMonths"};
inline constexpr SettingKey<double> attributesMonths{"quality/attributesMonths"};
inline constexpr SettingKey<double> mostLostShare{"inspecting/mostLostShare"}; ///< 0: no limit
inline constexpr SettingKey<bool> onlySignedIn{"inspecting/onlySignedIn"};
inline constexpr SettingKey<bool> keepSessions{"captures/keep"};
inline constexpr SettingKey<QString> captureFolder{"captures/folder"}; ///< empty: the usual one
inline constexpr SettingKey<double> captureMegabytes{"captures/megabytes"};
inline constexpr SettingKey<QString> connectAtStart{"start/connect"}; ///< last, virtual, nothing
inline constexpr SettingKey<bool> examplesAtStart{"start/examples"};
inline constexpr SettingKey<QString> lastGripper{"gripper"}; ///< an address
inline constexpr SettingKey<QString> operatorName{"operator"};
inline constexpr SettingKey<QString> company{"reports/company"};
inline constexpr SettingKey<QString> companyAddress{"reports/address"}; ///< lines parted by semicolons
inline constexpr SettingKey<QString> companyLogo{"reports/logo"};       ///< a file
inline constexpr SettingKey<double> gravity{"reports/gravity"};         ///< local, m/s²
inline constexpr SettingKey<bool> lineOn{"line/on"};
inline constexpr SettingKey<QString> lineHost{
    "line/host"}; ///< an address to listen on; empty: this computer's
inline constexpr SettingKey<double> linePort{"line/port"};
inline constexpr SettingKey<QString> linePeers{"line/peers"};        ///< parted by semicolons
inline constexpr SettingKey<QString> lineTypes{"line/types"};        ///< by number, parted by semicolons
inline constexpr SettingKey<double> lineHeartbeat{"line/heartbeat"}; ///< seconds
inline constexpr SettingKey<bool> mqttOn{"mqtt/on"};
inline constexpr SettingKey<QString> mqttBroker{"mqtt/broker"}; ///< HOST or HOST:PORT
inline constexpr SettingKey<bool> mqttTls{"mqtt/tls"};
inline constexpr SettingKey<QString> mqttCa{"mqtt/ca"}; ///< a file; empty: the computer's authorities
inline constexpr SettingKey<QString> mqttUser{"mqtt/user"};
inline constexpr SettingKey<QString> mqttPasswordFile{"mqtt/passwordFile"}; ///< never the password itself
inline constexpr SettingKey<QString> mqttTopic{"mqtt/topic"};               ///< of JSON; empty: none
inline constexpr SettingKey<QString> mqttSparkplug{"mqtt/sparkplug"};       ///< GROUP/NODE; empty: none
inline constexpr SettingKey<QString> mqttPrimaryHost{"mqtt/primaryHost"};
inline constexpr SettingKey<QString> plantServer{"plant/server"};      ///< postgresql://...; empty: none
inline constexpr SettingKey<double> idleMinutes{"people/idleMinutes"}; ///< 0: never
} // namespace setting

} // namespace gripscope
