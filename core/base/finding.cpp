// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/finding.h"

#include "core/base/places.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonObject>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <array>
#include <functional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int deepest = 12;
constexpr qsizetype mostParts = 1000;
constexpr qsizetype longestText = 100'000;
constexpr int mostDigits = 17;

/// As it is stored, in the order of MechanicalQuantity.
constexpr std::array<const char16_t*, 5> quantityIds{u"mass", u"damping", u"stiffness", u"force", u"length"};

std::optional<std::vector<Finding>>
partsOf(const QJsonValue& value, const std::function<std::optional<Finding>(const QJsonValue&)>& read)
{
    const QJsonArray array = value.toArray();
    if (array.size() > mostParts)
        return std::nullopt;
    std::vector<Finding> parts;
    for (const QJsonValue element : array) {
        auto part = read(element);
        if (!part)
            return std::nullopt;
        parts.push_back(*std::move(part));
    }
    return parts;
}

QJsonArray arrayOf(const std::vector<Finding>& parts)
{
    QJsonArray array;
    for (const Finding& part : parts)
        array.append(part.toJson());
    return array;
}

QString withLargeFirst(QString words)
{
    if (!words.isEmpty())
        words[0] = words[0].toUpper();
    return words;
}

QString fullSentence(QString words)
{
    if (words.size() > 1 && words[1].isLetter())
        words[0] = words[0].toUpper();
    return words.isEmpty() || words.endsWith(u'.') ? words : words + u'.';
}

} // namespace

Finding::Finding(QString text) : m_text(std::move(text)) {}

Finding Finding::number(double value, char format, int digits)
{
    Finding out;
    out.m_kind = Kind::Number;
    out.m_number = value;
    out.m_format = format;
    out.m_digits = digits;
    return out;
}

Finding Finding::quantity(MechanicalQuantity quantity, double si)
{
    Finding out;
    out.m_kind = Kind::Quantity;
    out.m_quantity = quantity;
    out.m_number = si;
    return out;
}

Finding Finding::joined(std::vector<Finding> parts, const QString& between)
{
    Finding out(between);
    out.m_kind = Kind::Joined;
    out.m_parts = std::move(parts);
    return out;
}

bool Finding::isEmpty() const
{
    return m_kind == Kind::Joined ? m_parts.empty() : m_kind == Kind::Text && m_text.isEmpty();
}

Finding Finding::arg(Finding argument) const
{
    Finding out = *this;
    out.m_parts.push_back(std::move(argument));
    return out;
}

Finding Finding::arg(double value, char format, int digits) const
{
    return arg(number(value, format, digits));
}

Finding Finding::wrapped(Kind kind) const
{
    Finding out;
    out.m_kind = kind;
    out.m_parts = {*this};
    return out;
}

Finding Finding::capitalized() const
{
    return isEmpty() ? *this : wrapped(Kind::Capitalized);
}

Finding Finding::asSentence() const
{
    return isEmpty() ? *this : wrapped(Kind::FullSentence);
}

Finding& Finding::operator+=(const Finding& more)
{
    if (more.isEmpty())
        return *this;
    if (isEmpty())
        return *this = more;
    if (m_kind != Kind::Joined || !m_text.isEmpty())
        *this = joined({*this}, QString());
    m_parts.push_back(more);
    return *this;
}

QString Finding::sentence(Reader reader) const
{
    const QString text =
        reader == Reader::Person ? QCoreApplication::translate("Words", m_text.toUtf8().constData()) : m_text;
    return withPlacesFilled(text, [&](std::size_t place) {
        return place <= m_parts.size() ? m_parts[place - 1].worded(reader) : QString();
    });
}

QString Finding::describe() const
{
    return worded(Reader::Person);
}

QString Finding::english() const
{
    return worded(Reader::Document);
}

QString Finding::worded(Reader reader) const
{
    QStringList parts;
    if (m_kind != Kind::Sentence)
        for (const Finding& part : m_parts)
            parts << part.worded(reader);
    switch (m_kind) {
    case Kind::Text:
        return m_text;
    case Kind::Number:
        return QString::number(m_number, m_format, m_digits)
            .replace(u'.', reader == Reader::Person ? QLocale().decimalPoint() : u"."_s);
    case Kind::Quantity:
        return reader == Reader::Person ? quantityInWords(m_quantity, m_number, DisplayUnits::current())
                                              .replace(u'.', QLocale().decimalPoint())
                                        : quantityInWords(m_quantity, m_number, {});
    case Kind::Sentence:
        return sentence(reader);
    case Kind::Joined:
        return parts.join(m_text);
    case Kind::Capitalized:
        return withLargeFirst(parts.join(QString()));
    case Kind::FullSentence:
        return fullSentence(parts.join(QString()));
    }
    return {};
}

QJsonValue Finding::toJson() const
{
    switch (m_kind) {
    case Kind::Text:
        return m_text;
    case Kind::Number:
        return QJsonObject{
            {u"number"_s, m_number}, {u"format"_s, QString(QLatin1Char(m_format))}, {u"digits"_s, m_digits}};
    case Kind::Quantity:
        return QJsonObject{{u"quantity"_s, QString::fromUtf16(quantityIds[std::size_t(m_quantity)])},
                           {u"si"_s, m_number}};
    case Kind::Sentence:
        return QJsonObject{{u"say"_s, m_text}, {u"with"_s, arrayOf(m_parts)}};
    case Kind::Joined:
        return QJsonObject{{u"parts"_s, arrayOf(m_parts)}, {u"between"_s, m_text}};
    case Kind::Capitalized:
    case Kind::FullSentence:
        return QJsonObject{
            {m_kind == Kind::Capitalized ? u"capitalized"_s : u"sentence"_s, m_parts.front().toJson()}};
    }
    return {};
}

std::optional<Finding> Finding::fromJson(const QJsonValue& value)
{
    return fromJson(value, 0);
}

std::optional<Finding> Finding::fromJson(const QJsonValue& value, int depth)
{
    if (value.isString() && value.toString().size() <= longestText)
        return Finding(value.toString());
    if (!value.isObject() || depth == deepest)
        return std::nullopt;
    const QJsonObject object = value.toObject();
    const auto read = [depth](const QJsonValue& part) { return fromJson(part, depth + 1); };
    Finding out;
    if (const QJsonValue number = object[u"number"_s]; number.isDouble()) {
        const QString format = object[u"format"_s].toString();
        const int digits = object[u"digits"_s].toInt(-1);
        if (format.size() != 1 || !u"efg"_s.contains(format) || digits < 0 || digits > mostDigits)
            return std::nullopt;
        return Finding::number(number.toDouble(), format.front().toLatin1(), digits);
    }
    if (object.contains(u"quantity"_s)) {
        const QString id = object[u"quantity"_s].toString();
        const auto* const known = std::find_if(quantityIds.begin(), quantityIds.end(),
                                               [&id](const char16_t* one) { return id == QStringView(one); });
        if (known == quantityIds.end() || !object[u"si"_s].isDouble())
            return std::nullopt;
        return Finding::quantity(MechanicalQuantity(known - quantityIds.begin()), object[u"si"_s].toDouble());
    }
    for (const Kind kind : {Kind::Capitalized, Kind::FullSentence}) {
        const auto key = kind == Kind::Capitalized ? u"capitalized"_s : u"sentence"_s;
        if (!object.contains(key))
            continue;
        const auto inner = read(object[key]);
        return inner ? std::optional(inner->wrapped(kind)) : std::nullopt;
    }
    const bool isSentence = object.contains(u"say"_s);
    const QJsonValue text = object[isSentence ? u"say"_s : u"between"_s];
    auto parts = partsOf(object[isSentence ? u"with"_s : u"parts"_s], read);
    if (!text.isString() || text.toString().size() > longestText || !parts)
        return std::nullopt;
    out.m_kind = isSentence ? Kind::Sentence : Kind::Joined;
    out.m_text = text.toString();
    out.m_parts = *std::move(parts);
    return out;
}

QStringList described(const Findings& findings)
{
    QStringList words;
    for (const Finding& finding : findings)
        words << finding.describe();
    return words;
}

QStringList english(const Findings& findings)
{
    QStringList words;
    for (const Finding& finding : findings)
        words << finding.english();
    return words;
}

} // namespace gripscope
