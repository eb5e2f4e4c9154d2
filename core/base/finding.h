// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"

#include <QJsonValue>
#include <QString>

#include <concepts>
#include <optional>
#include <vector>

namespace gripscope {

/// What the program has to say, as a value without a language: sentences whose places (%1 to %9) hold
/// numbers, names or further findings. Made by Words::say(), kept and sent as it is, and worded by describe()
/// where a person reads it, in that reader's language. Numbers keep their value and how many digits they are
/// worth.
class Finding {
public:
    Finding() = default;
    /// Text that has no language, such as a name, a file or a person's own words. Never a sentence.
    Finding(QString text); // NOLINT(google-explicit-constructor)
    Finding(const char16_t* text)
        : Finding(QString::fromUtf16(text)) {} // NOLINT(google-explicit-constructor)
    /// As QString::number(value, format, digits), with the decimal sign of the reader.
    [[nodiscard]] static Finding number(double value, char format = 'g', int digits = 6);
    /// A value in SI, read in the units that the reader has chosen; in documents in SI.
    [[nodiscard]] static Finding quantity(MechanicalQuantity quantity, double si);
    /// One after the other, with `between` (punctuation) between them.
    [[nodiscard]] static Finding joined(std::vector<Finding> parts, const QString& between);

    [[nodiscard]] bool isEmpty() const;

    /// Fills the next place, as QString::arg() does, but never looks into what was filled in before.
    [[nodiscard]] Finding arg(Finding argument) const;
    [[nodiscard]] Finding arg(double value, char format = 'g', int digits = 6) const;
    [[nodiscard]] Finding arg(std::integral auto count) const { return arg(double(count), 'f', 0); }
    template <std::convertible_to<Finding>... More>
    requires(sizeof...(More) > 0) [[nodiscard]] Finding arg(Finding first, More... more) const
    {
        return arg(std::move(first)).arg(std::move(more)...);
    }
    /// The same, its first letter large.
    [[nodiscard]] Finding capitalized() const;
    /// The same as a sentence: its first word large, unless that is a symbol (m, b, k), and a full stop
    /// behind.
    [[nodiscard]] Finding asSentence() const;
    /// Says more behind it.
    Finding& operator+=(const Finding& more);
    friend Finding operator+(Finding first, const Finding& more) { return first += more; }

    /// In the language of the installed translator and with the decimal sign of QLocale(): English where
    /// there is none, as on the command line.
    [[nodiscard]] QString describe() const;
    /// The same for documents and files, whoever writes them: English, with a decimal point.
    [[nodiscard]] QString english() const;

    /// For what is stored; text alone is a string, so that sentences of earlier versions read as what they
    /// are.
    [[nodiscard]] QJsonValue toJson() const;
    /// Nothing for what toJson() does not make, or what is too deep or too long to be read by anybody.
    [[nodiscard]] static std::optional<Finding> fromJson(const QJsonValue& value);

    friend bool operator==(const Finding&, const Finding&) = default;
    /// A sentence is not the text that it is worded as: compare describe().
    friend bool operator==(const Finding&, const QString&) = delete;

private:
    friend class Words;
    enum class Kind { Text, Number, Quantity, Sentence, Joined, Capitalized, FullSentence };

    [[nodiscard]] static std::optional<Finding> fromJson(const QJsonValue& value, int depth);
    enum class Reader { Person, Document };
    [[nodiscard]] QString worded(Reader reader) const;
    [[nodiscard]] QString sentence(Reader reader) const;
    [[nodiscard]] Finding wrapped(Kind kind) const;

    Kind m_kind = Kind::Text;
    QString m_text; ///< of a sentence its English, by which translators know it; of several what is between
    double m_number = 0;
    char m_format = 'g';
    int m_digits = 6;
    MechanicalQuantity m_quantity = MechanicalQuantity::Mass;
    std::vector<Finding>
        m_parts; ///< of a sentence what its places hold; of the last two kinds what is written so
};

using Findings = std::vector<Finding>;

/// Each in words, for lists.
[[nodiscard]] QStringList described(const Findings& findings);
[[nodiscard]] QStringList english(const Findings& findings);

} // namespace gripscope
