// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/pdf_document.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>
#include <QUrl>

namespace gripscope {

using namespace Qt::StringLiterals;

Expected<void> writePdf(const QString& title, const QString& html, const std::vector<PdfPicture>& pictures,
                        const QString& file)
{
    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly))
        return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
    QByteArray bytes;
    {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        QPdfWriter pdf(&buffer);
        pdf.setPageSize(QPageSize(QPageSize::A4));
        pdf.setPageMargins(QMarginsF(20, 20, 20, 20), QPageLayout::Millimeter);
        pdf.setTitle(title);
        pdf.setCreator(u"Gripscope "_s + QStringLiteral(GRIPSCOPE_VERSION));
        QTextDocument document;
        document.setDefaultStyleSheet(
            u"h1 { font-size: 20pt; } h2 { font-size: 13pt; } body, td, th, p { font-size: 10pt; } "
            ".small td, .small th { font-size: 8pt; }"_s);
        for (const PdfPicture& picture : pictures)
            document.addResource(QTextDocument::ImageResource, QUrl(picture.name), picture.image);
        document.setHtml(html);
        document.print(&pdf);
    }
    if (out.write(bytes) != bytes.size() || !out.commit())
        return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
    return {};
}

QString pdfRow(const QString& name, const QString& text)
{
    return u"<tr><td>%1</td><td>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>"_s.arg(name.toHtmlEscaped(),
                                                                               text.toHtmlEscaped());
}

} // namespace gripscope
