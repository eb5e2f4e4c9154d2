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

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int resolution = 600;  // points per inch: fine enough that letters stand where they should
constexpr double margin_mm = 18; // around the page
constexpr double footer_mm = 10; // below the text, the page's number in it
constexpr double footerSize_pt = 7.5;
constexpr double pictureDpi = 96; // pdfPicture() counts in these

struct PdfWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::PdfDocument)
};

void prepare(QPdfWriter& pdf, const QString& title)
{
    pdf.setResolution(resolution);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm), QPageLayout::Millimeter);
    pdf.setTitle(title);
    pdf.setCreator(u"Gripscope "_s + QStringLiteral(GRIPSCOPE_VERSION));
}

QSizeF pdfTextSize(const QPdfWriter& pdf)
{
    return {double(pdf.width()), pdf.height() - footer_mm / 25.4 * resolution};
}

void paintFooter(QPainter& painter, const QPdfWriter& pdf, const QString& title, int page, int pages)
{
    painter.setFont(pdfFont(footerSize_pt));
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
                        const QString& file, const std::shared_ptr<WorkWatch>& watch)
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
        const auto document = layOutPdf(html, pictures, pdf, pdfTextSize(pdf));
        paintPages(*document, pdf, title);
    }
    if (isStopped(watch)) {
        out.cancelWriting();
        return {};
    }
    if (out.write(bytes) != bytes.size() || !out.commit())
        return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
    return {};
}

QString pdfHeading(const QString& text)
{
    return u"<h2>%1</h2>"_s.arg(text.toHtmlEscaped());
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
