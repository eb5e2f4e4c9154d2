// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/letterhead.h"

#include "core/base/bounded_file.h"
#include "ui/settings/values/settings.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImageReader>
#include <QPainter>
#include <QSvgRenderer>
#include <QXmlStreamReader>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct LetterheadWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::Letterhead)
};

constexpr QSize logoRoom(170, 64); // as pdfPicture() counts, at 96 to the inch: 45 mm x 17 mm
constexpr int logoScale = 6;       // a drawing's points to one of these: enough for paper
const auto logoName = u"letterhead-logo"_s;

tl::unexpected<Error> unusable(const QString& file, const QString& why)
{
    return failure(ErrorCode::FileUnreadable,
                   {file, LetterheadWords::tr("%1. Choose another logo in the settings, or none.").arg(why)});
}

/// What an SVG has that a logo does without; empty when it is plain.
QString troubleIn(const QByteArray& svg)
{
    QXmlStreamReader xml(svg);
    while (!xml.atEnd()) {
        switch (xml.readNext()) {
        case QXmlStreamReader::DTD:
        case QXmlStreamReader::EntityReference:
            return LetterheadWords::tr("it declares entities or a document type");
        case QXmlStreamReader::ProcessingInstruction:
            return LetterheadWords::tr("it names a style sheet or another program");
        case QXmlStreamReader::StartElement:
            for (const auto forbidden : {"image"_L1, "use"_L1, "script"_L1, "foreignObject"_L1})
                if (xml.name() == forbidden)
                    return LetterheadWords::tr("it has an element that reads files or repeats parts (%1)")
                        .arg(forbidden);
            break;
        default:
            break;
        }
    }
    return xml.hasError() ? LetterheadWords::tr("it is neither PNG nor SVG") : QString();
}

Expected<QImage> drawnSvg(const QByteArray& bytes, const QString& file)
{
    if (const QString trouble = troubleIn(bytes); !trouble.isEmpty())
        return unusable(file, trouble);
    QSvgRenderer renderer(bytes);
    const QSize shape = renderer.defaultSize();
    if (!renderer.isValid() || shape.isEmpty())
        return unusable(file, LetterheadWords::tr("it is neither PNG nor SVG"));
    const QSize size = shape.scaled(logoRoom * logoScale, Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    renderer.render(&painter);
    return image;
}

Expected<QImage> readPng(const QByteArray& bytes, const QString& file)
{
    QBuffer buffer;
    buffer.setData(bytes);
    QImageReader reader(&buffer, "png");
    const QSize size = reader.size(); // from its head: nothing is unpacked yet
    if (size.isEmpty() || size.width() > mostLogoSide || size.height() > mostLogoSide)
        return unusable(
            file, LetterheadWords::tr("it is larger than %1 x %1 pixels, or damaged").arg(mostLogoSide));
    QImage image = reader.read();
    if (image.isNull())
        return unusable(file, reader.errorString());
    return image;
}

Expected<QImage> readLogo(const QString& file)
{
    if (file.isEmpty())
        return QImage();
    ASSIGN_OR_RETURN(const QByteArray bytes, readBounded(file, mostLogoBytes));
    return bytes.startsWith("\x89PNG") ? readPng(bytes, file) : drawnSvg(bytes, file);
}

} // namespace

LetterheadSource letterheadSource(const Settings& settings)
{
    return {settings.get(setting::company), settings.get(setting::companyAddress),
            settings.get(setting::companyLogo)};
}

Expected<Letterhead> readLetterhead(const LetterheadSource& source)
{
    Letterhead letterhead;
    letterhead.company = source.company.trimmed();
    for (const QString& line : source.address.split(u';', Qt::SkipEmptyParts))
        if (!line.trimmed().isEmpty())
            letterhead.address << line.trimmed();
    ASSIGN_OR_RETURN(letterhead.logo, readLogo(source.logoFile));
    return letterhead;
}

QString letterheadHtml(const Letterhead& letterhead)
{
    if (letterhead.company.isEmpty() && letterhead.address.isEmpty() && letterhead.logo.isNull())
        return {};
    QStringList lines;
    if (!letterhead.company.isEmpty())
        lines << u"<b>%1</b>"_s.arg(letterhead.company.toHtmlEscaped());
    for (const QString& line : letterhead.address)
        lines << line.toHtmlEscaped();
    QString logo;
    if (!letterhead.logo.isNull()) {
        const QSize size =
            letterhead.logo.size().scaled(logoRoom, Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
        logo = u"<img src='%1' width='%2' height='%3'>"_s.arg(logoName).arg(size.width()).arg(size.height());
    }
    return u"<table width='100%'><tr><td>%1</td><td align='right'>%2</td></tr></table><hr>"_s.arg(
        lines.join(u"<br>"_s), logo);
}

std::vector<PdfPicture> letterheadPictures(const Letterhead& letterhead)
{
    if (letterhead.logo.isNull())
        return {};
    return {{logoName, letterhead.logo}};
}

} // namespace gripscope
