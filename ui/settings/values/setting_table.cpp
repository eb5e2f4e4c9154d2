// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/display_units.h"
#include "core/calibration/conditions.h"
#include "core/recognition/verdict/verdict.h"
#include "devices/replay/capture_writer.h"
#include "ui/settings/values/setting_makers.h"

#include <QCoreApplication>

namespace gripscope {

namespace {

constexpr const char* percentUnit = "%";
/// Of rates, as the Rates window allows them.
constexpr double leastShare = 1e-5, mostShare = 0.2;

Setting rate(const char* key, double fallback, const char* name, const char* explanation)
{
    Setting made{key, SettingKind::Number, fallback, SettingGroup::Rates, name, explanation};
    made.least = leastShare;
    made.most = mostShare;
    made.factor = 100;
    made.decimals = 3;
    made.unit = percentUnit;
    made.needsSupervisor = made.needsReason = true;
    return made;
}

/// A unit reads alike in every language.
template <typename Unit, std::size_t N>
Setting unitChoice(const char* key, const std::array<UnitChoice<Unit>, N>& units, const char* name,
                   const char* explanation)
{
    std::vector<SettingChoice> choices;
    for (const UnitChoice<Unit>& one : units)
        choices.push_back({one.name, one.name});
    Setting made = choiceSetting(key, units.front().name, SettingGroup::Appearance, name, explanation,
                                 std::move(choices));
    made.choicesAreNames = true;
    return made;
}

std::vector<Setting> appearance()
{
    Setting language =
        choiceSetting(setting::language.key, "en", SettingGroup::Appearance,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Language"),
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Of all words and numbers on the screen."),
                      {{"en", "English"}, {"de", "Deutsch"}});
    Setting scale =
        choiceSetting(setting::scale.key, "100", SettingGroup::Appearance,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Text and control size"),
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Enlarges everything in the window."),
                      {{"100", "100 %"}, {"125", "125 %"}, {"150", "150 %"}, {"200", "200 %"}});
    language.choicesAreNames = scale.choicesAreNames = true;
    scale.applies = SettingApplies::NextStart;
    scale.portable = false; // it goes with the screen
    return {choiceSetting(setting::theme.key, "light", SettingGroup::Appearance,
                          QT_TRANSLATE_NOOP("gripscope::Setting", "Theme"),
                          QT_TRANSLATE_NOOP("gripscope::Setting", "Colours of the window."),
                          {{"light", QT_TRANSLATE_NOOP("gripscope::Setting", "Light")},
                           {"dark", QT_TRANSLATE_NOOP("gripscope::Setting", "Dark")},
                           {"contrast", QT_TRANSLATE_NOOP("gripscope::Setting", "High contrast")}}),
            language, scale,
            unitChoice(setting::forceUnit.key, forceUnitChoices,
                       QT_TRANSLATE_NOOP("gripscope::Setting", "Unit of force"),
                       QT_TRANSLATE_NOOP("gripscope::Setting",
                                         "On the screen and in reports; damping and stiffness follow, and "
                                         "masses are in lb with lbf.")),
            unitChoice(setting::lengthUnit.key, lengthUnitChoices,
                       QT_TRANSLATE_NOOP("gripscope::Setting", "Unit of length"),
                       QT_TRANSLATE_NOOP("gripscope::Setting",
                                         "On the screen and in reports; CSV and JSON files stay in the units "
                                         "that they were recorded in."))};
}

std::vector<Setting> automaticSqueeze()
{
    Setting automatic = switchSetting(
        setting::automaticSqueeze.key, false, SettingGroup::Inspecting,
        QT_TRANSLATE_NOOP("gripscope::Setting", "Squeeze by itself when a part arrives"),
        QT_TRANSLATE_NOOP("gripscope::Setting",
                          "Only armed, on the Inspect page, 2 s after the force has changed last, with "
                          "a countdown that is seen and heard."));
    Setting touch{setting::touchTimes.key,
                  SettingKind::Number,
                  8.0,
                  SettingGroup::Inspecting,
                  QT_TRANSLATE_NOOP("gripscope::Setting", "A part has arrived"),
                  QT_TRANSLATE_NOOP("gripscope::Setting",
                                    "When the force rises by so many times its own noise at rest.")};
    touch.least = 5;
    touch.most = 100;
    for (Setting* one : {&automatic, &touch})
        one->needsSupervisor = one->needsReason = true;
    return {automatic, touch};
}

std::vector<Setting> inspecting()
{
    Setting sound =
        switchSetting(setting::soundOnVerdict.key, true, SettingGroup::Inspecting,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Sound on a verdict"),
                      QT_TRANSLATE_NOOP("gripscope::Setting", "A beep when an inspection is decided."));
    Setting early =
        switchSetting(setting::earlyEnd.key, true, SettingGroup::Inspecting,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "End a squeeze as soon as it is decided"),
                      QT_TRANSLATE_NOOP("gripscope::Setting",
                                        "Parts that are clear take less time; the rates still hold."));
    early.needsSupervisor = early.needsReason = true;
    Setting disarm{setting::disarmMinutes.key,
                   SettingKind::Number,
                   5.0,
                   SettingGroup::Inspecting,
                   QT_TRANSLATE_NOOP("gripscope::Setting", "Disarm when nothing is done"),
                   QT_TRANSLATE_NOOP("gripscope::Setting",
                                     "After so many minutes without a key, a click, a scan or a squeeze.")};
    disarm.least = 1;
    disarm.most = 60;
    disarm.unit = "min";
    disarm.needsSupervisor = true;
    Setting overdue = switchSetting(
        setting::refuseOverdue.key, false, SettingGroup::Inspecting,
        QT_TRANSLATE_NOOP("gripscope::Setting", "Refuse to judge when a calibration is overdue"),
        QT_TRANSLATE_NOOP("gripscope::Setting", "Otherwise such a measurement is suspect."));
    Setting lost{setting::mostLostShare.key,
                 SettingKind::Number,
                 0.0,
                 SettingGroup::Inspecting,
                 QT_TRANSLATE_NOOP("gripscope::Setting", "Refuse to judge when more samples are lost"),
                 QT_TRANSLATE_NOOP("gripscope::Setting",
                                   "Share of a squeeze's samples. Otherwise such a measurement is suspect.")};
    lost.most = 0.2;
    lost.factor = 100;
    lost.decimals = 2;
    lost.unit = percentUnit;
    lost.zeroMeans = QT_TRANSLATE_NOOP("gripscope::Setting", "never");
    Setting person =
        switchSetting(setting::onlySignedIn.key, false, SettingGroup::Inspecting,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Refuse to judge when nobody is signed in"),
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Where the library has people."));
    for (Setting* policy : {&overdue, &lost, &person})
        policy->needsSupervisor = policy->needsReason = true;
    Setting invalid{
        setting::invalidInARow.key,
        SettingKind::Number,
        3.0,
        SettingGroup::Inspecting,
        QT_TRANSLATE_NOOP("gripscope::Setting", "Call the supervisor"),
        QT_TRANSLATE_NOOP("gripscope::Setting", "After so many squeezes in a row that were not valid.")};
    invalid.least = 1;
    invalid.most = 20;
    invalid.needsSupervisor = true;
    const Setting parts =
        switchSetting(setting::partNumbers.key, false, SettingGroup::Inspecting,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Part numbers"),
                      QT_TRANSLATE_NOOP("gripscope::Setting",
                                        "A scanned code that is no type's is the number of the next part."));
    Setting expected = textSetting(setting::expectedType.key, SettingKind::Text, SettingGroup::Inspecting,
                                   QT_TRANSLATE_NOOP("gripscope::Setting", "Expected type"), "");
    Setting shift = textSetting(setting::shiftStart.key, SettingKind::Text, SettingGroup::Inspecting,
                                QT_TRANSLATE_NOOP("gripscope::Setting", "Begin of the shift"), "");
    for (Setting* one : {&expected, &shift})
        one->shown = one->portable = false;
    std::vector<Setting> all{sound, early, disarm, invalid, parts, overdue, lost, person, expected, shift};
    const std::vector<Setting> automatic = automaticSqueeze();
    all.insert(all.begin() + 3, automatic.begin(), automatic.end()); // behind when it is disarmed
    return all;
}

/// After how many months a study is due again.
Setting repeated(const char* key, const char* name)
{
    Setting one{
        key,
        SettingKind::Number,
        12.0,
        SettingGroup::Studies,
        name,
        QT_TRANSLATE_NOOP("gripscope::Setting", "Months for which a study holds that is begun from now on.")};
    one.most = 120;
    one.zeroMeans = QT_TRANSLATE_NOOP("gripscope::Setting", "never");
    one.needsSupervisor = one.needsReason = true;
    return one;
}

std::vector<Setting> studies()
{
    return {repeated(setting::typeOneMonths.key,
                     QT_TRANSLATE_NOOP("gripscope::Setting", "Type-1 study is due again")),
            repeated(setting::gaugeMonths.key,
                     QT_TRANSLATE_NOOP("gripscope::Setting", "Gauge study is due again")),
            repeated(setting::linearityMonths.key,
                     QT_TRANSLATE_NOOP("gripscope::Setting", "Linearity study is due again")),
            repeated(setting::attributesMonths.key,
                     QT_TRANSLATE_NOOP("gripscope::Setting", "Attribute study is due again"))};
}

std::vector<Setting> rates()
{
    const VerdictOptions usual;
    Setting confidence = choiceSetting(
        setting::confidence.key, "0", SettingGroup::Rates,
        QT_TRANSLATE_NOOP("gripscope::Setting", "The false-reject rate holds"),
        QT_TRANSLATE_NOOP("gripscope::Setting", "With confidence for this library, gates are wider."),
        {{"0", QT_TRANSLATE_NOOP("gripscope::Setting", "on average over libraries")},
         {"0.95", QT_TRANSLATE_NOOP("gripscope::Setting", "with 95 % confidence")}});
    confidence.needsSupervisor = confidence.needsReason = true;
    Setting robust =
        switchSetting(setting::robust.key, usual.robust, SettingGroup::Rates,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Types spread unlike"),
                      QT_TRANSLATE_NOOP("gripscope::Setting",
                                        "Or have wild squeezes among them: allows for both by wider gates."));
    robust.needsSupervisor = robust.needsReason = true;
    return {rate(setting::falseReject.key, usual.falseReject,
                 QT_TRANSLATE_NOOP("gripscope::Setting", "False-reject rate"),
                 QT_TRANSLATE_NOOP("gripscope::Setting",
                                   "Share of squeezes of enrolled types that may be called unknown.")),
            rate(setting::wrongType.key, usual.wrongType,
                 QT_TRANSLATE_NOOP("gripscope::Setting", "Wrong-type rate"),
                 QT_TRANSLATE_NOOP("gripscope::Setting",
                                   "Share of squeezes of enrolled types that may be named another type.")),
            rate(setting::strangerAccept.key, usual.strangerAccept,
                 QT_TRANSLATE_NOOP("gripscope::Setting", "Stranger-accept rate"),
                 QT_TRANSLATE_NOOP("gripscope::Setting",
                                   "Share of parts of no enrolled type that may be named a type.")),
            confidence, robust};
}

std::vector<Setting> sessions()
{
    Setting keep = switchSetting(
        setting::keepSessions.key, true, SettingGroup::Sessions,
        QT_TRANSLATE_NOOP("gripscope::Setting", "Keep the raw reports of every session"),
        QT_TRANSLATE_NOOP("gripscope::Setting", "So that it can be replayed. Of real grippers only."));
    Setting folder =
        textSetting(setting::captureFolder.key, SettingKind::Folder, SettingGroup::Sessions,
                    QT_TRANSLATE_NOOP("gripscope::Setting", "Folder of kept sessions"),
                    QT_TRANSLATE_NOOP("gripscope::Setting", "Empty: the usual folder for data."));
    folder.portable = false;
    Setting bound{setting::captureMegabytes.key,
                  SettingKind::Number,
                  static_cast<double>(CaptureLimits().totalBytes) / 1e6,
                  SettingGroup::Sessions,
                  QT_TRANSLATE_NOOP("gripscope::Setting", "Room for kept sessions"),
                  QT_TRANSLATE_NOOP("gripscope::Setting", "When it is full, the oldest make room.")};
    bound.least = 100;
    bound.most = 1e6;
    bound.unit = "MB";
    for (Setting* one : {&keep, &folder, &bound}) {
        one->needsSupervisor = true; // what is not kept cannot be replayed
        one->applies = SettingApplies::NextConnection;
    }
    return {keep, folder, bound};
}

std::vector<Setting> start()
{
    Setting connect = choiceSetting(
        setting::connectAtStart.key, "last", SettingGroup::Start,
        QT_TRANSLATE_NOOP("gripscope::Setting", "Connect at the start"),
        QT_TRANSLATE_NOOP("gripscope::Setting", "The gripper that Gripscope looks for by itself."),
        {{"last", QT_TRANSLATE_NOOP("gripscope::Setting", "The one used last")},
         {"virtual", QT_TRANSLATE_NOOP("gripscope::Setting", "The virtual gripper")},
         {"nothing", QT_TRANSLATE_NOOP("gripscope::Setting", "None")}});
    Setting examples =
        switchSetting(setting::examplesAtStart.key, false, SettingGroup::Start,
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Example types"),
                      QT_TRANSLATE_NOOP("gripscope::Setting", "Adds the four example types to the library."));
    connect.applies = examples.applies = SettingApplies::NextStart;
    Setting last = textSetting(setting::lastGripper.key, SettingKind::Text, SettingGroup::Start,
                               QT_TRANSLATE_NOOP("gripscope::Setting", "Gripper used last"), "");
    Setting person = textSetting(setting::operatorName.key, SettingKind::Text, SettingGroup::People,
                                 QT_TRANSLATE_NOOP("gripscope::Setting", "Operator"), "");
    Setting explained = switchSetting(setting::stopExplained.key, false, SettingGroup::Start,
                                      QT_TRANSLATE_NOOP("gripscope::Setting", "What STOP is was read"), "");
    for (Setting* one : {&last, &person, &explained})
        one->shown = one->portable = false;
    Setting idle{setting::idleMinutes.key,
                 SettingKind::Number,
                 15.0,
                 SettingGroup::People,
                 QT_TRANSLATE_NOOP("gripscope::Setting", "Sign out when nobody works"),
                 QT_TRANSLATE_NOOP("gripscope::Setting", "After so many minutes without a key or a click.")};
    idle.most = 240;
    idle.unit = "min";
    idle.zeroMeans = QT_TRANSLATE_NOOP("gripscope::Setting", "never");
    idle.needsSupervisor = true;
    return {connect, examples, last, person, explained, idle};
}

std::vector<Setting> reports()
{
    Setting company =
        textSetting(setting::company.key, SettingKind::Text, SettingGroup::Reports,
                    QT_TRANSLATE_NOOP("gripscope::Setting", "Company"),
                    QT_TRANSLATE_NOOP("gripscope::Setting", "At the head of reports and certificates."));
    Setting address = textSetting(
        setting::companyAddress.key, SettingKind::Text, SettingGroup::Reports,
        QT_TRANSLATE_NOOP("gripscope::Setting", "Address"),
        QT_TRANSLATE_NOOP("gripscope::Setting", "Below the name; a semicolon begins a new line."));
    Setting logo =
        textSetting(setting::companyLogo.key, SettingKind::Picture, SettingGroup::Reports,
                    QT_TRANSLATE_NOOP("gripscope::Setting", "Logo"),
                    QT_TRANSLATE_NOOP("gripscope::Setting", "A PNG or SVG file of up to 2 MB. Empty: none."));
    logo.portable = false; // a file of this computer
    Setting gravity{setting::gravity.key,
                    SettingKind::Number,
                    standardGravity,
                    SettingGroup::Reports,
                    QT_TRANSLATE_NOOP("gripscope::Setting", "Local gravity"),
                    QT_TRANSLATE_NOOP("gripscope::Setting",
                                      "By which reference masses in kg or lb are taken for forces.")};
    gravity.least = leastGravity;
    gravity.most = mostGravity;
    gravity.decimals = 5;
    gravity.unit = "m/s\u00B2";
    for (Setting* one : {&company, &address, &logo, &gravity})
        one->needsSupervisor = true; // they stand on certificates
    return {company, address, logo, gravity};
}

} // namespace

const std::vector<Setting>& allSettings()
{
    static const std::vector<Setting> all = [] {
        std::vector<Setting> made;
        for (const std::vector<Setting>& group :
             {appearance(), inspecting(), rates(), studies(), sessions(), start(), reports(), lineSettings(),
              brokerSettings(), plantSettings()})
            made.insert(made.end(), group.begin(), group.end());
        return made;
    }();
    return all;
}

} // namespace gripscope
