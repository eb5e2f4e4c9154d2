// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/output.h"

#include "app/cli/line/exit_code.h"
#include "core/base/printable.h"
#include "core/math/normal_interval.h"

#include <QJsonDocument>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

void write(std::FILE* stream, const QByteArray& bytes)
{
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stream);
    std::fputc('\n', stream);
    std::fflush(stream);
}

/// JSON leaves some characters as they are that a terminal obeys (printable.h). They stand in strings only,
/// where JSON has a way to write them out, so the document says the same.
QByteArray withoutSteering(const QByteArray& json)
{
    const bool plain = std::all_of(json.begin(), json.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
    if (plain)
        return json;
    const QString text = QString::fromUtf8(json);
    QString out;
    out.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (isSteering(text, i))
            out += u"\\u%1"_qs.arg(int(text[i].unicode()), 4, 16, QLatin1Char('0'));
        else
            out += text[i];
    }
    return out.toUtf8();
}

} // namespace

void printJson(const QJsonObject& document)
{
    write(stdout, withoutSteering(QJsonDocument(document).toJson(QJsonDocument::Compact)));
}

void print(const QString& text)
{
    write(stdout, printableLines(text).toUtf8());
}

void message(const QString& text)
{
    write(stderr, printableLines(text).toUtf8());
}

QJsonObject errorDocument(const Error& error)
{
    return {{u"error"_qs, QJsonObject{{u"code"_qs, error.name()}, {u"message"_qs, error.describe()}}}};
}

QJsonObject errorDocument(const QString& file, const Error& error)
{
    QJsonObject document = errorDocument(error);
    document[u"file"_qs] = file;
    return document;
}

int fail(const Error& error, bool json)
{
    message(u"gripscope-cli: "_qs + error.describe());
    if (json)
        printJson(errorDocument(error));
    return static_cast<int>(exitFor(error));
}

QString withInterval(double value, std::optional<double> standardError)
{
    if (!standardError || !(*standardError > 0))
        return QString::number(value, 'g', 6);
    // Two digits of the half width, and the value to the same place; exponents where that would be long.
    const double half = normal95 * *standardError;
    const int place = static_cast<int>(std::floor(std::log10(half))) - 1;
    const double largest = std::max(std::abs(value), half);
    const int exponent = static_cast<int>(std::floor(std::log10(largest)));
    if (exponent < -4 || place > 0) {
        const double scale = std::pow(10.0, exponent);
        const int decimals = std::max(0, exponent - place);
        return u"(%1 ± %2)e%3"_qs.arg(QString::number(value / scale, 'f', decimals),
                                      QString::number(half / scale, 'f', decimals),
                                      QString::number(exponent));
    }
    return u"%1 ± %2"_qs.arg(QString::number(value, 'f', -place), QString::number(half, 'f', -place));
}

QString fixed(std::optional<double> value, int decimals)
{
    return value ? QString::number(*value, 'f', decimals) : u"-"_qs;
}

} // namespace gripscope::cli
