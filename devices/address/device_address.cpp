// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/device_address.h"

#include "core/base/words.h"
#include "core/recognition/types/simulated_parts.h"
#include "devices/address/virtual_object.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<Error> wrong(const QString& found, const QString& expected)
{
    return failure(ErrorCode::Usage,
                   {Words::tr("Device address: %1 is not understood; %2.").arg(found, expected)});
}

Expected<double> number(const QString& key, const QString& text, double least, double most)
{
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(value) || value < least || value > most)
        return wrong(key + u'=' + text,
                     Words::tr("%1 is a number from %2 to %3").arg(key).arg(least).arg(most));
    return value;
}

/// The faults whose value is a size, in force from the beginning on, and those whose value is their time.
struct FaultName {
    const char* text;
    Fault fault;
    double most;
    bool isTime;
    double least = 0;
};
constexpr FaultName faultNames[] = {
    {"loss", Fault::Loss, 1, false},
    {"duplicate", Fault::Duplicate, 1, false},
    {"crc", Fault::Crc, 1, false},
    {"saturate", Fault::Saturate, 1e6, false},
    {"stall", Fault::Stall, longestFaultTime_s, true},
    {"unplug", Fault::Unplug, longestFaultTime_s, true},
    {"replug", Fault::Replug, longestFaultTime_s, true},
    {"deaf", Fault::Deaf, longestFaultTime_s, true},
    {"hang-feature", Fault::HangFeature, longestFaultTime_s, true},
    {"hang-write", Fault::HangWrite, longestFaultTime_s, true},
    {"broken", Fault::Broken, longestFaultTime_s, true},
    {"button", Fault::Button, longestFaultTime_s, true},
    {"clock-rate", Fault::ClockRate, largestClockRate, false, -largestClockRate},
};

/// What a fault that is named with its time alone is set to.
std::optional<double> usualValue(Fault fault)
{
    switch (fault) {
    case Fault::HangFeature:
    case Fault::HangWrite:
        return usualHang_s;
    case Fault::Deaf: // to all commands
        return 0;
    case Fault::Broken:
    case Fault::Button:
        return 1;
    default:
        return {};
    }
}

Expected<void> parseFault(const QString& text, VirtualAddress& address)
{
    if (text == u"stuck") {
        address.faults.push_back({0, Fault::Stuck, 1});
        return {};
    }
    if (text == u"units") {
        address.millimetres = true;
        return {};
    }
    const QString name = text.section(u':', 0, 0);
    const auto* known = std::find_if(std::begin(faultNames), std::end(faultNames),
                                     [&](const FaultName& each) { return name == QLatin1String(each.text); });
    if (known == std::end(faultNames))
        return wrong(
            u"fault="_qs + text,
            Words::tr(
                "a fault is loss:P, duplicate:P, crc:P, saturate:N, stall:S, unplug:S, replug:S, "
                "deaf:S, hang-feature:S, hang-write:S, broken:S, button:S, clock-rate:R, stuck or units"));
    ASSIGN_OR_RETURN(const double value,
                     number(u"fault="_qs + name, text.section(u':', 1), known->least, known->most));
    if (known->isTime)
        address.faults.push_back({value, known->fault, usualValue(known->fault)});
    else
        address.faults.push_back({0, known->fault, value});
    return {};
}

Expected<void> parseFaults(const QString& text, VirtualAddress& address)
{
    for (const QString& fault : text.split(u','))
        RETURN_IF_ERROR(parseFault(fault, address));
    // A replug is named by how long after the unplug it comes.
    std::optional<double> unplugged_s;
    for (const FaultEvent& event : address.faults)
        if (event.fault == Fault::Unplug)
            unplugged_s = event.at_s;
    for (FaultEvent& event : address.faults)
        if (event.fault == Fault::Replug) {
            if (!unplugged_s)
                return wrong(u"fault="_qs + text, Words::tr("replug:S needs unplug:S beside it"));
            event.at_s += *unplugged_s;
        }
    sortByTime(address.faults);
    return {};
}

/// "0.2,0.03": k1 as a share of k, and tau in seconds.
Expected<void> parseZener(const QString& value, VirtualTerms& terms)
{
    constexpr double shortest_s = 1e-4, longest_s = 1000;
    if (value.count(u',') != 1)
        return wrong(
            u"zener="_qs + value,
            Words::tr("zener is two numbers, the share of k that yields and its time in seconds, such as "
                      "0.2,0.03"));
    ASSIGN_OR_RETURN(terms.relaxingShare, number(u"zener"_qs, value.section(u',', 0, 0), 0, 100));
    ASSIGN_OR_RETURN(terms.relaxationTime_s,
                     number(u"zener"_qs, value.section(u',', 1), shortest_s, longest_s));
    return {};
}

/// What is not ideal about the part or the gripper; nothing for other options.
std::optional<Expected<void>> parseRealOption(const QString& key, const QString& value,
                                              VirtualAddress& address)
{
    struct Option {
        const char* key;
        double least, most;
        double& value;
    };
    VirtualTerms& terms = address.terms;
    const Option options[] = {{"friction", 0, 1000, terms.friction_N},
                              {"own-friction", 0, 1000, terms.ownFriction_N},
                              {"k3", -1e15, 1e15, terms.cubic},
                              {"rate", slowestVirtual_Hz, fastestVirtual_Hz, address.samplesPerSecond},
                              {"jitter", 0, 1, address.jitter_s}};
    if (key == u"zener")
        return parseZener(value, terms);
    for (const Option& option : options)
        if (key == QLatin1String(option.key))
            return number(key, value, option.least, option.most).map([&](double found) {
                option.value = found;
            });
    return {};
}

/// What is squeezed of a gauge study, and how it scatters; nothing for other options.
std::optional<Expected<void>> parseStudyOption(const QString& key, const QString& value,
                                               VirtualAddress& address)
{
    VirtualStudyPart study = address.study.value_or(VirtualStudyPart());
    const std::pair<const char*, int&> places[] = {
        {"part", study.part}, {"operator", study.operatorNumber}, {"trial", study.trial}};
    const std::pair<const char*, double&> spreads[] = {{"part-spread", study.partSpread},
                                                       {"operator-spread", study.operatorSpread},
                                                       {"repeat-spread", study.repeatSpread}};
    for (const auto& [name, place] : places)
        if (key == QLatin1String(name)) {
            bool isNumber = false;
            place = value.toInt(&isNumber);
            if (!isNumber || place < 1 || place > VirtualStudyPart::mostOfStudy)
                return wrong(key + u'=' + value, Words::tr("%1 is a whole number from 1 to %2")
                                                     .arg(key)
                                                     .arg(VirtualStudyPart::mostOfStudy));
            address.study = study;
            return Expected<void>();
        }
    for (const auto& [name, spread] : spreads)
        if (key == QLatin1String(name))
            return number(key, value, 0, VirtualStudyPart::largestSpread)
                .map([&, to = &spread](double found) {
                    *to = found;
                    address.study = study;
                });
    return {};
}

Expected<void> parseVirtualOption(const QString& key, const QString& value, VirtualAddress& address)
{
    if (const std::optional<Expected<void>> real = parseRealOption(key, value, address))
        return *real;
    if (const std::optional<Expected<void>> study = parseStudyOption(key, value, address))
        return *study;
    if (key == u"object") {
        address.object = value;
        return VirtualObject::fromText(value).map([](const VirtualObject&) {});
    }
    if (key == u"seed") {
        bool isNumber = false;
        address.seed = value.toULongLong(&isNumber);
        if (!isNumber)
            return wrong(u"seed="_qs + value, Words::tr("seed is a whole number from 0 on"));
        return {};
    }
    if (key == u"noise")
        return number(key, value, 0, 0.01).map([&](double metres) { address.positionNoise_m = metres; });
    if (key == u"speed")
        return number(key, value, 0, 100).map([&](double speed) { address.speed = speed; });
    if (key == u"fault") {
        if (!address.faults.empty())
            return wrong(Words::tr("a second fault="),
                         Words::tr("faults stand behind one fault=, with commas between"));
        return parseFaults(value, address);
    }
    if (key == u"script") {
        address.script = value;
        return {};
    }
    if (key == u"capture") {
        address.capture = value;
        return {};
    }
    if (key == u"profile" || key == u"like") {
        (key == u"like" ? address.like : address.profile) = value;
        return {};
    }
    return wrong(
        key,
        Words::tr(
            "virtual: knows object, seed, noise, speed, friction, own-friction, zener, k3, rate, jitter, "
            "part, operator, trial, part-spread, operator-spread, repeat-spread, fault, script, capture, "
            "profile and like"));
}

Expected<DeviceAddress> parseVirtual(const QString& rest)
{
    VirtualAddress address;
    if (rest.isEmpty() || rest == u"?")
        return address;
    if (!rest.startsWith(u'?'))
        return wrong(rest,
                     Words::tr("behind virtual: comes nothing, or ? and options such as object=A&seed=7"));
    for (const QString& option : rest.mid(1).split(u'&')) {
        if (!option.contains(u'='))
            return wrong(u'"' + option + u'"', Words::tr("an option is name=value"));
        RETURN_IF_ERROR(parseVirtualOption(option.section(u'=', 0, 0), option.section(u'=', 1), address));
    }
    if (address.study)
        address.study->seed = address.seed;
    const SimulatedPart* const simulated = simulatedPart(address.object);
    const bool zenerGiven = address.terms.relaxationTime_s > 0;
    if (simulated != nullptr && !zenerGiven) {
        address.terms.relaxingShare = simulated->relaxingShare;
        address.terms.relaxationTime_s = simulated->relaxationTime_s;
    }
    if (address.jitter_s * address.samplesPerSecond > largestJitter)
        return wrong(u"jitter=%1"_qs.arg(address.jitter_s),
                     Words::tr("jitter is at most %1 of the time between two samples, here %2 s")
                         .arg(largestJitter)
                         .arg(largestJitter / address.samplesPerSecond));
    return address;
}

Expected<std::uint16_t> hexId(const QString& text)
{
    bool isNumber = false;
    const uint value = text.toUInt(&isNumber, 16);
    if (!isNumber || value > 0xFFFF)
        return wrong(text,
                     Words::tr("a vendor or product number has up to four hexadecimal digits, such as 1209"));
    return static_cast<std::uint16_t>(value);
}

Expected<void> parseHidOptions(const QString& options, HidAddress& address)
{
    for (const QString& option : options.split(u'&')) {
        const QString value = option.section(u'=', 1);
        if (option.startsWith(u"capture="))
            address.capture = value;
        else if (option.startsWith(u"port="))
            address.port = value;
        else if (option.startsWith(u"profile="))
            address.profile = value;
        else
            return wrong(option,
                         Words::tr("behind hid: the options are port=PORT, profile=FILE and capture=FILE"));
    }
    return {};
}

Expected<DeviceAddress> parseHid(const QString& rest)
{
    HidAddress address;
    const QString name = rest.section(u'?', 0, 0);
    if (rest.contains(u'?'))
        RETURN_IF_ERROR(parseHidOptions(rest.section(u'?', 1), address));
    if (name.isEmpty())
        return address;
    if (!name.contains(u':'))
        return wrong(name, Words::tr("hid: stands alone, or as hid:1209:0001 or hid:1209:0001:SERIAL"));
    ASSIGN_OR_RETURN(const std::uint16_t vendor, hexId(name.section(u':', 0, 0)));
    ASSIGN_OR_RETURN(const std::uint16_t product, hexId(name.section(u':', 1, 1)));
    address.vendor = vendor;
    address.product = product;
    address.serial = name.section(u':', 2);
    return address;
}

/// Anything may stand in the name of a file; the one option is what follows the last ?speed=.
Expected<DeviceAddress> parseReplay(const QString& rest)
{
    const QString option = u"?speed="_qs;
    const qsizetype at = rest.lastIndexOf(option);
    if (at < 0)
        return ReplayAddress{rest};
    ASSIGN_OR_RETURN(const double speed, number(u"speed"_qs, rest.mid(at + option.size()), 0, 1000));
    return ReplayAddress{rest.left(at), speed};
}

} // namespace

Expected<DeviceAddress> parseDeviceAddress(const QString& text)
{
    const QString kind = text.section(u':', 0, 0);
    const QString rest = text.section(u':', 1);
    if (kind == u"virtual" && text.contains(u':'))
        return parseVirtual(rest);
    if (kind == u"hid" && text.contains(u':'))
        return parseHid(rest);
    if (kind == u"replay" && !rest.isEmpty())
        return parseReplay(rest);
    return wrong(text.isEmpty() ? Words::tr("nothing") : text,
                 Words::tr("an address is virtual: or virtual:?object=A&seed=7, hid: or "
                           "hid:1209:0001:SERIAL, or replay:FILE"));
}

} // namespace gripscope
