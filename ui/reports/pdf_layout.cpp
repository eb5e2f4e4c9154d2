// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/pdf_document.h"

#include <QAbstractTextDocumentLayout>
#include <QFont>
#include <QImage>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextTable>
#include <QUrl>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double fontSize_pt = 9;                            // of the text
constexpr double smallSizes_pt[] = {7.5, 7, 6.5, 6, 5.5, 5}; // of large tables, the first that fits
constexpr double leastPictureShare = 2.0 / 3;                // what a picture may shrink to

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

/// A line may end behind a slash, and at the space of "N s/m".
QString withWholeUnits(QString html)
{
    static const QRegularExpression inside(u"([0-9]\\x{00A0}[kMmµn]?(?:N|lbf|kgf)) (?=s/)"_s);
    static const QRegularExpression slash(u"(\\x{00A0}[^\\s<>\\x{00A0}/]+/)(?=[^\\s<>/])"_s);
    html.replace(inside, u"\\1\u00A0"_s);
    return html.replace(slash, u"\\1\u2060"_s);
}

void keepLinesWhole(QTextDocument& document)
{
    QTextBlockFormat oneLine;
    oneLine.setNonBreakableLines(true);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const QString text = block.text();
        QTextCursor cursor(block);
        if (text.contains(QChar::Nbsp) && !text.contains(u' ') && cursor.currentTable() != nullptr)
            cursor.mergeBlockFormat(oneLine);
    }
}

double widestTable(const QTextDocument& document)
{
    double widest = 0;
    for (QTextFrame* frame : document.rootFrame()->childFrames())
        if (qobject_cast<const QTextTable*>(frame) != nullptr)
            widest = std::max(widest, document.documentLayout()->frameBoundingRect(frame).width());
    return widest;
}

std::unique_ptr<QTextDocument> documentOf(const QString& html, const std::vector<PdfPicture>& pictures,
                                          QPaintDevice& device, QSizeF page, double smallSize_pt)
{
    auto document = std::make_unique<SealedDocument>();
    document->documentLayout()->setPaintDevice(&device);
    document->setDocumentMargin(0);
    document->setDefaultFont(pdfFont(fontSize_pt));
    document->setDefaultStyleSheet(u"h1 { font-size: 18pt; } h2 { font-size: 12pt; } "
                                   ".small td, .small th { font-size: %1pt; }"_s.arg(smallSize_pt));
    for (const PdfPicture& picture : pictures)
        document->addResource(QTextDocument::ImageResource, QUrl(picture.name), picture.image);
    document->setHtml(html);
    keepLinesWhole(*document);
    document->setPageSize(page);
    return document;
}

/// The only thing in a block; invalid where that is no picture.
QTextImageFormat pictureIn(const QTextBlock& block)
{
    const QTextBlock::iterator first = block.begin();
    const bool one = !first.atEnd() && first.fragment().length() == block.length() - 1;
    return one ? first.fragment().charFormat().toImageFormat() : QTextImageFormat();
}

struct Pages {
    QTextDocument& document;

    [[nodiscard]] QRectF place(const QTextBlock& block) const
    {
        return document.documentLayout()->blockBoundingRect(block);
    }
    [[nodiscard]] double height() const { return document.pageSize().height(); }
    [[nodiscard]] int pageAt(double y) const { return int(std::floor(y / height())); }
};

/// Makes a picture that went to the next page small enough for this one, where it then still can be read.
void fitPicture(const Pages& pages, const QTextBlock& block)
{
    QTextImageFormat format = pictureIn(block);
    const QTextBlock before = block.previous();
    if (!format.isValid() || !before.isValid())
        return;
    // A block begins where the one before ended, though its line may have gone to the next page.
    const double end = pages.place(before).bottom();
    if (pages.pageAt(pages.place(block).bottom() - 1) == pages.pageAt(end))
        return;
    const double height = block.layout()->lineAt(0).height();
    const double margins = 2 * pages.place(before).height(); // those between, whatever they are
    const double share = ((pages.pageAt(end) + 1) * pages.height() - end - margins) / height;
    if (share < leastPictureShare || share >= 1)
        return;
    format.setWidth(format.width() * share);
    format.setHeight(format.height() * share);
    QTextCursor cursor(block);
    cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    cursor.setCharFormat(format);
}

/// The first block below a heading that has to stand on its page: of a table the first row with content.
QTextBlock belowHeading(const QTextBlock& heading)
{
    const QTextBlock next = heading.next();
    const QTextTable* table = next.isValid() ? QTextCursor(next).currentTable() : nullptr;
    if (table == nullptr)
        return next;
    const int row = std::min(table->rows() - 1, std::max(1, table->format().headerRowCount()));
    return table->cellAt(row, 0).firstCursorPosition().block();
}

void keepWithNext(const Pages& pages, const QTextBlock& heading)
{
    const QTextBlock below = belowHeading(heading);
    if (!below.isValid())
        return;
    const QRectF place = pages.place(heading);
    const int page = pages.pageAt(place.top());
    constexpr double atTheTop = 0.1; // of a page: a new one would change nothing
    const bool first = place.top() - page * pages.height() < atTheTop * pages.height();
    if (first || pages.pageAt(pages.place(below).bottom() - 1) == page)
        return;
    QTextBlockFormat onNewPage;
    onNewPage.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    QTextCursor(heading).mergeBlockFormat(onNewPage);
}

} // namespace

QFont pdfFont(double points)
{
    QFont font(u"Noto Sans"_s);
    font.setPointSizeF(points);
    return font;
}

std::unique_ptr<QTextDocument> layOutPdf(const QString& html, const std::vector<PdfPicture>& pictures,
                                         QPaintDevice& device, QSizeF page)
{
    const QString text = withWholeUnits(html);
    std::unique_ptr<QTextDocument> document;
    for (const double size_pt : smallSizes_pt) {
        document = documentOf(text, pictures, device, page, size_pt);
        constexpr double slack = 1; // a point of the device
        if (widestTable(*document) <= page.width() + slack)
            break;
    }
    const Pages pages{*document};
    // From the top: what is moved moves only what comes after it.
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() > 0) {
            fitPicture(pages, block.next());
            keepWithNext(pages, block);
        } else {
            fitPicture(pages, block);
        }
    }
    return document;
}

} // namespace gripscope
