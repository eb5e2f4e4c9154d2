// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/pdf_document.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>
#include <QUrl>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int resolution = 600;   // points per inch: fine enough that letters stand where they should
constexpr double margin_mm = 18;  // around the page
constexpr double footer_mm = 10;  // below the text, the page's number in it
constexpr double fontSize_pt = 9; // of the text
constexpr double pictureDpi = 96; // pdfPicture() counts in these

struct PdfWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::PdfDocument)
};

QFont fontOf(double points)
{
    QFont font(u"Noto Sans"_s);
    font.setPointSizeF(points); // the program's own font is sized for the screen
    return font;
}

/// Has the pictures that were added and loads nothing else, whatever an address in its text names.
class SealedDocument : public QTextDocument {
protected:
    QVariant loadResource(int, const QUrl&) override
    {
        // Where it gets no picture, Qt itself opens the address as a file; so it gets one of nothing.
        QImage nothing(1, 1, QImage::Format_ARGB32);
        nothing.fill(Qt::transparent);
        return nothing;
    }
};

void prepare(QPdfWriter& pdf, const QString& title)
{
    pdf.setResolution(resolution);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm), QPageLayout::Millimeter);
    pdf.setTitle(title);
    pdf.setCreator(u"Gripscope "_s + QStringLiteral(GRIPSCOPE_VERSION));
}

void paintFooter(QPainter& painter, const QPdfWriter& pdf, const QString& title, int page, int pages)
{
    painter.setFont(fontOf(fontSize_pt - 1.5));
    painter.setPen(Qt::darkGray);
    const QRectF line(0, 0, pdf.width(), pdf.height());
    painter.drawText(line, Qt::AlignLeft | Qt::AlignBottom, title);
    painter.drawText(line, Qt::AlignRight | Qt::AlignBottom, PdfWords::tr("%1 of %2").arg(page).arg(pages));
}

void paintPages(QTextDocument& document, QPdfWriter& pdf, const QString& title)
{
    QPainter painter(&pdf);
    const QSizeF page = document.pageSize();
    const int pages = document.pageCount();
    for (int i = 0; i < pages; ++i) {
        if (i > 0)
            pdf.newPage();
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = QRectF(QPointF(0, i * page.height()), page);
        context.palette.setColor(QPalette::Text, Qt::black);
        painter.save();
        painter.translate(0, -i * page.height());
        painter.setClipRect(context.clip);
        document.documentLayout()->draw(&painter, context);
        painter.restore();
        paintFooter(painter, pdf, title, i + 1, pages);
    }
}

} // namespace

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
        prepare(pdf, title);
        SealedDocument document;
        document.documentLayout()->setPaintDevice(&pdf);
        document.setDocumentMargin(0);
        document.setDefaultFont(fontOf(fontSize_pt));
        document.setDefaultStyleSheet(u"h1 { font-size: 18pt; } h2 { font-size: 12pt; } "
                                      ".small td, .small th { font-size: 7.5pt; }"_s);
        for (const PdfPicture& picture : pictures)
            document.addResource(QTextDocument::ImageResource, QUrl(picture.name), picture.image);
        document.setHtml(html);
        document.setPageSize(QSizeF(pdf.width(), pdf.height() - footer_mm / 25.4 * resolution));
        paintPages(document, pdf, title);
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

QString pdfPicture(const QString& name, QSize size)
{
    // Without a height it would be that of the picture's own points.
    const double wide = (210 - 2 * margin_mm) / 25.4 * pictureDpi;
    return u"<p><img src='%1' width='%2' height='%3'></p>"_s.arg(name)
        .arg(qRound(wide))
        .arg(qRound(wide * size.height() / size.width()));
}

} // namespace gripscope
