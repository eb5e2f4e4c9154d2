// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>

namespace gripscope::cli {

/// The options of one subcommand. After parse() the typed getters read them; the first value that makes no
/// sense is remembered, so that a command reads everything it wants and then asks once.
class CommandLine {
public:
    /// `arguments`: how the usage line goes on after the options, "FILE..."; in brackets when there may be
    /// none.
    enum class Json { OneDocument, OneAFile };
    CommandLine(const QString& command, const QString& description, const QString& arguments = {},
                Json json = Json::OneDocument);

    void flag(const QString& name, const QString& description);
    void option(const QString& name, const QString& valueName, const QString& description,
                const QString& defaultValue = {});
    void shortOption(QChar letter, const QString& name, const QString& valueName, const QString& description);

    /// The exit code when nothing is left to do: help was asked for, or something cannot be understood.
    [[nodiscard]] std::optional<int> parse(const QStringList& arguments);

    [[nodiscard]] bool isSet(const QString& name) const { return m_parser.isSet(name); }
    [[nodiscard]] QString text(const QString& name) const { return m_parser.value(name); }
    [[nodiscard]] QStringList list(const QString& name) const; ///< separated by commas
    /// Of an option that may be given several times.
    [[nodiscard]] QStringList texts(const QString& name) const { return m_parser.values(name); }
    [[nodiscard]] QStringList files() const { return m_parser.positionalArguments(); }

    enum class Range { Any, NotNegative, Positive };
    [[nodiscard]] double number(const QString& name, Range range = Range::Any);
    [[nodiscard]] int integer(const QString& name, int least, int most);
    [[nodiscard]] std::uint64_t seed(const QString& name = QStringLiteral("seed"));
    /// The position of the value among `choices`.
    [[nodiscard]] int choice(const QString& name, const QStringList& choices);
    /// Remembers that something makes no sense.
    void reject(const QString& reason);

    /// Told once all was read: the exit code when something made no sense.
    [[nodiscard]] std::optional<int> finish() const;

private:
    void rejectValue(const QString& name, const QString& expected);
    [[nodiscard]] QString helpText() const;
    [[nodiscard]] int usage(const QString& problem) const;

    QString m_command, m_arguments;
    QStringList m_names;
    QCommandLineParser m_parser;
    QString m_problem;
};

/// The candidate nearest to what was typed, when it is near enough to be meant.
[[nodiscard]] std::optional<QString> nearest(const QString& typed, const QStringList& candidates);

} // namespace gripscope::cli
