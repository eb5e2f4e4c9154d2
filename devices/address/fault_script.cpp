// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/address/fault_script.h"

#include "core/base/bounded_file.h"
#include "core/base/words.h"
#include "devices/protocol/report.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Some ten thousand lines.
constexpr qint64 largestScript = megabyte;

/// What stands behind a word of the script.
enum class Operand { None, Share, Newtons, Step, Seconds, Switch, Command, Rate };

struct Word {
    const char* text;
    Fault fault;
    Operand operand;
};

constexpr Word scriptWords[] = {
    {"loss", Fault::Loss, Operand::Share},
    {"duplicate", Fault::Duplicate, Operand::Share},
    {"crc", Fault::Crc, Operand::Share},
    {"saturate", Fault::Saturate, Operand::Newtons},
    {"stuck", Fault::Stuck, Operand::Switch},
    {"stall", Fault::Stall, Operand::None},
    {"resume", Fault::Resume, Operand::None},
    {"clock", Fault::Clock, Operand::Step},
    {"unplug", Fault::Unplug, Operand::None},
    {"replug", Fault::Replug, Operand::None},
    {"deaf", Fault::Deaf, Operand::Command},
    {"hang-feature", Fault::HangFeature, Operand::Seconds},
    {"hang-write", Fault::HangWrite, Operand::Seconds},
    {"broken", Fault::Broken, Operand::Switch},
    {"no-watchdog", Fault::NoWatchdog, Operand::Switch},
    {"load", Fault::Load, Operand::Newtons},
    {"button", Fault::Button, Operand::Switch},
    {"clock-rate", Fault::ClockRate, Operand::Rate},
};

struct CommandName {
    const char* text;
    protocol::ReportId id;
};

constexpr CommandName commandNames[] = {
    {"arm", protocol::ReportId::Arm},          {"disarm", protocol::ReportId::Disarm},
    {"stop", protocol::ReportId::Stop},        {"heartbeat", protocol::ReportId::Heartbeat},
    {"limits", protocol::ReportId::SetLimits}, {"upload", protocol::ReportId::Upload},
    {"start", protocol::ReportId::Start},      {"finish", protocol::ReportId::Finish},
};

template <typename Table>
QString namesOf(const Table& table)
{
    QStringList names;
    for (const auto& entry : table)
        names << QString::fromLatin1(entry.text);
    return names.join(u", "_qs);
}

/// What may stand behind the word.
QString expectedBehind(Operand operand)
{
    switch (operand) {
    case Operand::None:
        return Words::tr("nothing");
    case Operand::Share:
        return Words::tr("a share from 0 to 1");
    case Operand::Newtons:
        return Words::tr("newtons from 0 to 1000000, or off");
    case Operand::Step:
        return Words::tr("seconds from -1000 to 1000");
    case Operand::Seconds:
        return Words::tr("nothing, seconds from 0 to 60, or off");
    case Operand::Switch:
        return Words::tr("nothing, or off");
    case Operand::Command:
        return Words::tr("nothing, off, or one of %1").arg(namesOf(commandNames));
    case Operand::Rate:
        return Words::tr("a share from -0.5 to 0.5");
    }
    return {};
}

bool readNumber(const QString& text, double least, double most, std::optional<double>& value)
{
    bool isNumber = false;
    value = text.toDouble(&isNumber);
    return isNumber && std::isfinite(*value) && *value >= least && *value <= most;
}

/// False: `text` is nothing that may stand there. An absent operand is empty.
bool readOperand(Operand operand, const QString& text, std::optional<double>& value)
{
    const bool mayBeOff = operand == Operand::Newtons || operand == Operand::Seconds ||
                          operand == Operand::Switch || operand == Operand::Command;
    if (mayBeOff && text == u"off")
        return true;
    switch (operand) {
    case Operand::None:
        return text.isEmpty();
    case Operand::Share:
        return readNumber(text, 0, 1, value);
    case Operand::Newtons:
        return readNumber(text, 0, 1e6, value);
    case Operand::Step:
        return readNumber(text, -1000, 1000, value);
    case Operand::Seconds:
        if (!text.isEmpty())
            return readNumber(text, 0, 60, value);
        value = usualHang_s;
        return true;
    case Operand::Switch:
        value = 1;
        return text.isEmpty();
    case Operand::Command:
        value = 0;
        for (const CommandName& command : commandNames)
            if (text == QLatin1String(command.text))
                value = static_cast<double>(command.id);
        return text.isEmpty() || *value > 0;
    case Operand::Rate:
        return readNumber(text, -largestClockRate, largestClockRate, value);
    }
    return false;
}

struct Token {
    QString text;
    qsizetype column = 0; ///< from 1
};

std::vector<Token> tokensOf(const QString& line)
{
    std::vector<Token> tokens;
    bool inside = false;
    for (qsizetype i = 0; i < line.size() && line[i] != u'#'; ++i) {
        const bool space = line[i].isSpace();
        if (!space && !inside)
            tokens.push_back({{}, i + 1});
        if (!space)
            tokens.back().text += line[i];
        inside = !space;
    }
    return tokens;
}

class ScriptParser {
public:
    explicit ScriptParser(const QString& name) : m_name(name) {}

    Expected<std::vector<FaultEvent>> parse(const QByteArray& text)
    {
        for (const QByteArray& line : text.split('\n')) {
            ++m_line;
            const std::vector<Token> tokens = tokensOf(QString::fromUtf8(line));
            if (tokens.empty())
                continue;
            RETURN_IF_ERROR(take(tokens));
        }
        return std::move(m_events);
    }

private:
    [[nodiscard]] tl::unexpected<Error> wrong(const Token& at, const QString& expected) const
    {
        return failure(ErrorCode::BadInput, {u"%1:%2:%3"_qs.arg(m_name).arg(m_line).arg(at.column),
                                             at.text.isEmpty() ? Words::tr("the line ends")
                                                               : Words::tr("found \"%1\"").arg(at.text),
                                             Words::tr("expected %1").arg(expected)});
    }

    Expected<void> take(const std::vector<Token>& tokens)
    {
        const Token& last = tokens.back();
        const Token end{{}, last.column + last.text.size()};
        const auto token = [&](std::size_t i) { return i < tokens.size() ? tokens[i] : end; };

        FaultEvent event;
        std::optional<double> time;
        if (!readNumber(token(0).text, 0, longestFaultTime_s, time))
            return wrong(token(0), Words::tr("a time in seconds, from 0 to 1000000"));
        event.at_s = *time;
        if (!m_events.empty() && event.at_s < m_events.back().at_s)
            return wrong(
                token(0),
                Words::tr("a time not before that of the line above, %1 s").arg(m_events.back().at_s));
        const auto* word =
            std::find_if(std::begin(scriptWords), std::end(scriptWords), [&](const Word& candidate) {
                return token(1).text == QLatin1String(candidate.text);
            });
        if (word == std::end(scriptWords))
            return wrong(token(1), Words::tr("one of %1").arg(namesOf(scriptWords)));
        event.fault = word->fault;
        if (!readOperand(word->operand, token(2).text, event.value))
            return wrong(token(2),
                         Words::tr("%1 behind %2").arg(expectedBehind(word->operand), token(1).text));
        if (tokens.size() > 3)
            return wrong(token(3), Words::tr("the end of the line; a comment begins with #"));
        m_events.push_back(event);
        return {};
    }

    const QString m_name;
    int m_line = 0;
    std::vector<FaultEvent> m_events;
};

} // namespace

void FaultState::apply(const FaultEvent& event)
{
    switch (event.fault) {
    case Fault::Loss:
        loss = event.value.value_or(0);
        return;
    case Fault::Duplicate:
        duplicate = event.value.value_or(0);
        return;
    case Fault::Crc:
        badCrc = event.value.value_or(0);
        return;
    case Fault::Saturate:
        saturate_N = event.value;
        return;
    case Fault::Load:
        load_N = event.value.value_or(0);
        return;
    case Fault::Stuck:
        stuck = event.value.has_value();
        return;
    case Fault::Stall:
        stalled = true;
        return;
    case Fault::Resume:
        stalled = false;
        return;
    case Fault::Clock:
        clock_s += event.value.value_or(0);
        return;
    case Fault::Unplug:
        unplugged = true;
        return;
    case Fault::Replug:
        unplugged = false;
        return;
    case Fault::Deaf:
        if (!event.value)
            deafTo = 0;
        else if (*event.value > 0)
            deafTo |=
                1U << (static_cast<unsigned>(*event.value) - static_cast<unsigned>(protocol::ReportId::Arm));
        else
            deafTo = ~0U;
        return;
    case Fault::HangFeature:
        featureHangs_s = event.value.value_or(0);
        return;
    case Fault::HangWrite:
        writeHangs_s = event.value.value_or(0);
        return;
    case Fault::Broken:
        broken = event.value.has_value();
        return;
    case Fault::NoWatchdog:
        noWatchdog = event.value.has_value();
        return;
    case Fault::Button:
        buttonDown = event.value.has_value();
        return;
    case Fault::ClockRate:
        clockRate = event.value.value_or(0);
        return;
    }
}

bool FaultState::deaf(std::uint8_t reportId) const
{
    const unsigned bit = reportId - static_cast<unsigned>(protocol::ReportId::Arm);
    return bit < 32 ? deafTo >> bit & 1U : deafTo == ~0U;
}

Expected<std::vector<FaultEvent>> parseFaultScript(const QByteArray& text, const QString& name)
{
    return ScriptParser(name).parse(text);
}

Expected<std::vector<FaultEvent>> readFaultScript(const QString& file)
{
    ASSIGN_OR_RETURN(const QByteArray text, readBounded(file, largestScript));
    return parseFaultScript(text, file);
}

void sortByTime(std::vector<FaultEvent>& events)
{
    std::stable_sort(events.begin(), events.end(),
                     [](const FaultEvent& a, const FaultEvent& b) { return a.at_s < b.at_s; });
}

Expected<std::vector<FaultEvent>> withScript(std::vector<FaultEvent> events, const QString& script)
{
    if (script.isEmpty())
        return events;
    return readFaultScript(script).map([&](const std::vector<FaultEvent>& read) {
        events.insert(events.end(), read.begin(), read.end());
        sortByTime(events);
        return events;
    });
}

} // namespace gripscope
