// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"

#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "core/base/printable.h"
#include "core/signal/recording/recording_limits.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Levenshtein's distance: how many letters must be put in, taken out or changed.
int editDistance(const QString& a, const QString& b)
{
    std::vector<int> row(static_cast<std::size_t>(b.size()) + 1);
    std::iota(row.begin(), row.end(), 0);
    for (qsizetype i = 0; i < a.size(); ++i) {
        int diagonal = row[0]++;
        for (qsizetype j = 0; j < b.size(); ++j) {
            const auto at = static_cast<std::size_t>(j);
            const int changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[at + 1];
            row[at + 1] = std::min({changed, row[at] + 1, row[at + 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::optional<QString> nearest(const QString& typed, const QStringList& candidates)
{
    const auto best =
        std::min_element(candidates.begin(), candidates.end(), [&](const QString& a, const QString& b) {
            return editDistance(typed, a) < editDistance(typed, b);
        });
    if (best == candidates.end())
        return std::nullopt;
    // Up to a third of the letters may be wrong; more is another word.
    const bool near = editDistance(typed, *best) <= std::max<qsizetype>(1, best->size() / 3);
    return near ? std::optional(*best) : std::nullopt;
}

CommandLine::CommandLine(const QString& command, const QString& description, const QString& arguments,
                         Json json)
    : m_command(command), m_arguments(arguments)
{
    m_parser.setApplicationDescription(description);
    flag(u"json"_qs,
         json == Json::OneDocument
             ? u"Writes a JSON document to standard output, messages to standard error."_qs
             : u"Writes a JSON document for each file, a line each, to standard output, messages to standard "
               "error."_qs);
}

void CommandLine::flag(const QString& name, const QString& description)
{
    m_parser.addOption({name, description});
    m_names << name;
}

void CommandLine::option(const QString& name, const QString& valueName, const QString& description,
                         const QString& defaultValue)
{
    const QString text =
        defaultValue.isEmpty() ? description : u"%1 Default: %2."_qs.arg(description, defaultValue);
    m_parser.addOption({name, text, valueName, defaultValue});
    m_names << name;
}

void CommandLine::shortOption(QChar letter, const QString& name, const QString& valueName,
                              const QString& description)
{
    m_parser.addOption({{QString(letter), name}, description, valueName});
    m_names << name;
}

std::optional<int> CommandLine::parse(const QStringList& arguments)
{
    // Last, for a command may have an h of its own: a CUSUM's decision interval.
    const QStringList help{u"h"_qs, u"help"_qs};
    m_parser.addOption({help.mid(m_names.contains(u"h"_qs) ? 1 : 0), u"Shows this text."_qs});
    m_names << u"help"_qs;
    const bool understood = m_parser.parse(QStringList{u"gripscope-cli"_qs} + arguments);
    if (m_parser.isSet(u"help"_qs)) {
        print(helpText());
        return 0;
    }
    if (understood) {
        if (m_arguments.isEmpty() && !files().isEmpty())
            return usage(u"\"%1\" is not expected here."_qs.arg(files().first()));
        const bool needed = !m_arguments.isEmpty() && !m_arguments.startsWith(u'[');
        if (needed && files().isEmpty())
            return usage(u"%1 is missing."_qs.arg(m_arguments));
        return std::nullopt;
    }
    QString problem = m_parser.errorText();
    if (const QStringList unknown = m_parser.unknownOptionNames(); !unknown.isEmpty()) {
        problem = u"There is no option --%1."_qs.arg(unknown.first());
        if (const std::optional<QString> meant = nearest(unknown.first(), m_names))
            problem += u" Did you mean --%1?"_qs.arg(*meant);
    }
    return usage(problem);
}

QString CommandLine::helpText() const
{
    // The parser's own first line knows nothing of subcommands.
    const QString text = m_parser.helpText();
    QString first = u"Usage: gripscope-cli %1 [options]"_qs.arg(m_command);
    if (!m_arguments.isEmpty())
        first += u' ' + m_arguments;
    return first + text.mid(text.indexOf(u'\n')).trimmed().prepend(u'\n');
}

int CommandLine::usage(const QString& problem) const
{
    message(u"gripscope-cli %1: %2\ngripscope-cli %1 --help says more."_qs.arg(m_command, problem));
    return static_cast<int>(Exit::Usage);
}

void CommandLine::reject(const QString& reason)
{
    if (m_problem.isEmpty())
        m_problem = reason;
}

void CommandLine::rejectValue(const QString& name, const QString& expected)
{
    reject(u"--%1 is \"%2\"; %3 was expected."_qs.arg(name, printable(text(name), longestQuote), expected));
}

std::optional<int> CommandLine::finish() const
{
    return m_problem.isEmpty() ? std::nullopt : std::optional(usage(m_problem));
}

QStringList CommandLine::list(const QString& name) const
{
    QStringList parts;
    for (const QString& part : text(name).split(u','))
        if (!part.trimmed().isEmpty())
            parts << part.trimmed();
    return parts;
}

double CommandLine::number(const QString& name, Range range)
{
    bool ok = false;
    const double value = QLocale::c().toDouble(text(name), &ok);
    ok = ok && isReading(value);
    switch (range) {
    case Range::Any:
        if (!ok)
            rejectValue(name, u"a number"_qs);
        break;
    case Range::NotNegative:
        if (!ok || value < 0)
            rejectValue(name, u"a number of zero or above"_qs);
        break;
    case Range::Positive:
        if (!ok || value <= 0)
            rejectValue(name, u"a number above zero"_qs);
        break;
    }
    return ok ? value : 0;
}

int CommandLine::integer(const QString& name, int least, int most)
{
    bool ok = false;
    const int value = text(name).toInt(&ok);
    if (ok && value >= least && value <= most)
        return value;
    rejectValue(name, u"a whole number from %1 to %2"_qs.arg(least).arg(most));
    return least;
}

std::uint64_t CommandLine::seed(const QString& name)
{
    bool ok = false;
    const qulonglong value = text(name).toULongLong(&ok);
    // JSON's whole numbers end here, and a seed is to be read back as it was given.
    if (ok && value <= static_cast<qulonglong>(std::numeric_limits<qint64>::max()))
        return value;
    rejectValue(name, u"a whole number of zero or above"_qs);
    return 0;
}

int CommandLine::choice(const QString& name, const QStringList& choices)
{
    const qsizetype index = choices.indexOf(text(name));
    if (index >= 0)
        return static_cast<int>(index);
    rejectValue(name, u"one of "_qs + choices.join(u", "_qs));
    return 0;
}

} // namespace gripscope::cli
