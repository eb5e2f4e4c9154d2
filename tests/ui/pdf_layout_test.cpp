// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/reports/pdf_document.h"
#include "ui/reports/reports.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPdfWriter>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextTable>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// A4 as reports have it, and a document on it.
class Paper {
public:
    Paper()
    {
        m_bytes.open(QIODevice::WriteOnly);
        m_pdf = std::make_unique<QPdfWriter>(&m_bytes);
        m_pdf->setResolution(600);
        m_pdf->setPageSize(QPageSize(QPageSize::A4));
        m_pdf->setPageMargins(QMarginsF(18, 18, 18, 18), QPageLayout::Millimeter);
    }
    void print(const QString& html, const std::vector<PdfPicture>& pictures = {})
    {
        document = layOutPdf(html, pictures, *m_pdf, page());
    }
    [[nodiscard]] QSizeF page() const { return QSizeF(m_pdf->width(), m_pdf->height()); }
    [[nodiscard]] QRectF place(const QTextBlock& block) const
    {
        return document->documentLayout()->blockBoundingRect(block);
    }
    /// Of its last line, where it may have gone to the next page.
    [[nodiscard]] int pageOf(const QTextBlock& block) const
    {
        return int((place(block).bottom() - 1) / page().height());
    }
    [[nodiscard]] QTextBlock blockWith(const QString& text) const
    {
        for (QTextBlock block = document->begin(); block.isValid(); block = block.next())
            if (block.text().contains(text))
                return block;
        return {};
    }
    /// Headings that stand on another page than what follows them.
    [[nodiscard]] QStringList lonelyHeadings() const
    {
        QStringList lonely;
        for (QTextBlock block = document->begin(); block.isValid(); block = block.next())
            if (block.blockFormat().headingLevel() > 0 && block.next().isValid() &&
                pageOf(block) != pageOf(block.next()))
                lonely << block.text();
        return lonely;
    }
    /// Cells with a number, a time or a unit that is on two lines.
    [[nodiscard]] QStringList brokenCells() const
    {
        QStringList broken;
        for (QTextBlock block = document->begin(); block.isValid(); block = block.next())
            if (QTextCursor(block).currentTable() && block.text().contains(QChar::Nbsp) &&
                !block.text().contains(u' ') && block.layout()->lineCount() > 1)
                broken << block.text();
        return broken;
    }

    std::unique_ptr<QTextDocument> document;

private:
    QBuffer m_bytes;
    std::unique_ptr<QPdfWriter> m_pdf;
};

QString lines(int count)
{
    QString html;
    for (int i = 0; i < count; ++i)
        html += u"<p>line %1</p>"_s.arg(i);
    return html;
}

QImage red(QSize size)
{
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::red);
    return image;
}

HistoryReport longReport()
{
    HistoryReport report;
    report.made = QDateTime(QDate(2026, 11, 24), QTime(14, 31));
    report.operatorName = u"Mai"_s;
    for (int i = 0; i < 120; ++i) {
        HistoryEntry entry;
        entry.number = 1000 + i;
        entry.verdict = VerdictKind::Type;
        entry.type = u"A type with a name of some length"_s;
        entry.operatorName = u"Wolfeschlegelsteinhausenbergerdorff"_s;
        entry.device = u"Virtual gripper"_s;
        entry.program = u"0.1.0"_s;
        entry.time = report.made.addSecs(-60 * i);
        entry.parameters = MassDampingStiffness{0.04, 40, 10000};
        entry.standardErrors = Eigen::Vector3d(0.001, 1, 50);
        entry.forceUnit = u"N"_s;
        entry.positionUnit = u"m"_s;
        report.rows.push_back(entry);
    }
    report.total = report.rows.size();
    return report;
}

} // namespace

/// Where the lines and pages of reports end.
class PdfLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void aHeadingIsNeverAloneAtAPagesFoot()
    {
        // So many lines that a heading meets the page's foot at one of them.
        for (int count = 20; count < 50; ++count) {
            Paper paper;
            paper.print(lines(count) + pdfHeading(u"Heading"_s) +
                        u"<table><thead><tr><th>name</th></tr></thead><tr><td>row</td></tr></table>"_s);
            QVERIFY2(paper.lonelyHeadings().isEmpty(), qPrintable(QString::number(count)));
            QCOMPARE(paper.pageOf(paper.blockWith(u"Heading"_s)), paper.pageOf(paper.blockWith(u"row"_s)));
        }
    }
    void aPictureShrinksBeforeItLeavesAPageEmpty()
    {
        const std::vector<PdfPicture> pictures{{u"p"_s, red({680, 470})}};
        const QString picture = pdfHeading(u"Heading"_s) + pdfPicture(u"p"_s, {680, 470});
        int shrunk = 0, full = 0;
        for (int count = 2; count < 34; ++count) {
            Paper paper;
            paper.print(lines(count) + picture, pictures);
            QVERIFY(paper.lonelyHeadings().isEmpty());
            const QTextBlock heading = paper.blockWith(u"Heading"_s);
            const double width = heading.next().begin().fragment().charFormat().toImageFormat().width();
            const bool smaller = width < 656;
            QVERIFY2(!smaller || width > 430, qPrintable(QString::number(width))); // two thirds of 657
            if (smaller) // for this page, or for nothing
                QCOMPARE(paper.pageOf(heading), 0);
            shrunk += smaller ? 1 : 0;
            full += smaller ? 0 : 1;
        }
        QVERIFY2(shrunk > 2 && full > 10, qPrintable(u"%1 %2"_s.arg(shrunk).arg(full)));
    }
    void aLargeTableGetsSmallerLettersAndNoBrokenNumbers()
    {
        for (const int columns : {4, 8, 9}) {
            QString html = u"<table class='small' width='100%' cellpadding='2'>"_s;
            for (int row = 0; row < 5; ++row) {
                html += u"<tr>"_s;
                for (int i = 0; i < columns; ++i)
                    html += u"<td>2026-11-24\u00A014:31</td>"_s;
                html += u"</tr>"_s;
            }
            Paper paper;
            paper.print(html + u"</table>"_s);
            QCOMPARE(paper.brokenCells(), QStringList());
            const QTextTable* table = QTextCursor(paper.blockWith(u"14:31"_s)).currentTable();
            QVERIFY(
                paper.document->documentLayout()->frameBoundingRect(const_cast<QTextTable*>(table)).width() <=
                paper.page().width() + 1);
        }
    }
    void aUnitIsNotParted()
    {
        Paper paper;
        paper.print(
            u"<p>a stiffness of 9.98 ± 0.05\u00A0kN/m, a damping of 43\u00A0N s/m, 57\u00A0lbf/in</p>"_s);
        const QString text = paper.document->begin().text();
        QVERIFY2(text.contains(u"\u00A0kN/\u2060m"_s), qPrintable(text)); // a word joiner: no line ends there
        QVERIFY2(text.contains(u"43\u00A0N\u00A0s/\u2060m"_s), qPrintable(text));
        QVERIFY2(text.contains(u"lbf/\u2060in"_s), qPrintable(text));
    }
    void theHistoryReportFillsItsPages()
    {
        Paper paper;
        const HistoryReport report = longReport();
        const QString html = historyReportHtml(report);
        QVERIFY(!html.contains(u"page-break-before"_s));
        paper.print(html);
        QCOMPARE(paper.brokenCells(), QStringList());
        QCOMPARE(paper.lonelyHeadings(), QStringList());
        // Rows go on to the last page without a page that holds next to nothing.
        const int pages = paper.document->pageCount();
        std::vector<int> rows(std::size_t(pages), 0);
        for (const HistoryEntry& entry : report.rows)
            ++rows[std::size_t(paper.pageOf(paper.blockWith(QString::number(entry.number))))];
        for (std::size_t i = 1; i + 1 < rows.size(); ++i)
            QVERIFY2(rows[i] > 5, qPrintable(u"page %1: %2 rows"_s.arg(i + 1).arg(rows[i])));
    }
};

GRIPSCOPE_TEST(PdfLayoutTest)
#include "pdf_layout_test.moc"
