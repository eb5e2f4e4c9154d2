// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_file.h"
#include "core/library/library.h"
#include "ui/charts/study_charts.h"
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/format/reference_words.h"
#include "ui/pages/quality/study_views.h"
#include "ui/pages/quality/study_words.h"
#include "ui/reports/quality_reports.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/row_list.h"
#include "ui/windows/file_dialog.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTableWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

static_assert(StudyCharts::count == 5);

namespace {
constexpr int numbersRowHeight = 32; // logical pixels
}

StudyOutcome::StudyOutcome(Workbench& workbench, QWidget* parent) : QWidget(parent), m_workbench(&workbench)
{
    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 0, 12);
    QFrame* card = makeCard(content);
    auto* words = new QVBoxLayout(card);
    setSpacing(words, 16, 8);
    m_verdict = makeLabel({}, "title", card);
    m_verdict->setObjectName("studyVerdict");
    m_more = makeLabel({}, "", card);
    m_more->setObjectName("studyMore");
    m_categories = makeLabel({}, "second", card);
    m_categories->setObjectName("studyCategories");
    for (QLabel* label : {m_verdict, m_more, m_categories}) {
        label->setWordWrap(true);
        words->addWidget(label);
    }
    column->addWidget(card);
    m_content = new QWidget(content);
    auto* inside = new QVBoxLayout(m_content);
    setSpacing(inside, 0, 12);
    m_tabs = new QTabBar(m_content);
    m_tabs->setObjectName("studyQuantityTabs");
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    m_judgement = makeLabel({}, "", m_content);
    m_judgement->setObjectName("studyJudgement");
    m_remarks = makeLabel({}, "second", m_content);
    m_remarks->setObjectName("studyRemarks");
    for (QLabel* label : {m_judgement, m_remarks})
        label->setWordWrap(true);
    inside->addWidget(m_tabs);
    inside->addWidget(m_judgement);
    m_charts = makeCharts(m_content);
    m_readingsCard = makeCard(m_content);
    auto* readings = new QVBoxLayout(m_readingsCard);
    setSpacing(readings, 12, 0);
    m_readings = new CategoryPlot(m_readingsCard);
    m_readings->setObjectName("studyReadings");
    readings->addWidget(m_readings);
    for (QWidget* part : {m_charts, static_cast<QWidget*>(m_readingsCard), makeNumbers(m_content),
                          static_cast<QWidget*>(m_remarks)})
        inside->addWidget(part);
    column->addWidget(m_content);
    column->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 12);
    outer->addWidget(makeHead());
    m_scroll = makeScroll(content, this);
    outer->addWidget(m_scroll, 1);
    connect(m_tabs, &QTabBar::currentChanged, this, &StudyOutcome::showQuantity);
}

QWidget* StudyOutcome::makeHead()
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    QPushButton* back = makeButton(tr("All studies"), u"go-previous"_s, "", box);
    back->setObjectName("studyOutcomeBack");
    m_name = new ElidedLabel({}, box);
    m_name->setObjectName("studyOutcomeName");
    setRole(m_name, "strong");
    m_facts = new ElidedLabel({}, box);
    setRole(m_facts, "caption");
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(m_name);
    words->addWidget(m_facts);
    m_csv = makeButton(tr("CSV…"), {}, "", box);
    m_csv->setObjectName("studyCsv");
    m_csv->setToolTip(tr("Every measurement that counts, as a table"));
    m_report = makeButton(tr("Report (PDF)…"), {}, "primary", box);
    m_report->setObjectName("studyReport");
    row->addWidget(back);
    row->addLayout(words, 1);
    row->addWidget(m_csv);
    row->addWidget(m_report);
    connect(back, &QPushButton::clicked, this, &StudyOutcome::left);
    connect(m_csv, &QPushButton::clicked, this, [this] {
        chooseFile(tr("Save the measurements"), tr("CSV (*.csv)"), u"csv"_s, &StudyOutcome::writeCsv);
    });
    connect(m_report, &QPushButton::clicked, this, [this] {
        chooseFile(tr("Save the report"), tr("PDF (*.pdf)"), u"pdf"_s, &StudyOutcome::writeReport);
    });
    return box;
}

QWidget* StudyOutcome::makeCharts(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(12);
    const char* const names[] = {"studyComponents", "studyByPart", "studyByOperator", "studyRanges",
                                 "studyInteraction"};
    for (std::size_t i = 0; i < m_plots.size(); ++i) {
        QFrame* card = makeCard(box);
        auto* inside = new QVBoxLayout(card);
        setSpacing(inside, 12, 0);
        m_plots[i] = new CategoryPlot(card);
        m_plots[i]->setObjectName(QLatin1StringView(names[i]));
        inside->addWidget(m_plots[i]);
        // The ranges of all operators and parts need the whole width.
        const bool wide = i == 3;
        const int place = wide ? 4 : i == 4 ? 3 : int(i);
        grid->addWidget(card, place / 2, place % 2, 1, wide ? 2 : 1);
    }
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    return box;
}

QWidget* StudyOutcome::makeNumbers(QWidget* parent)
{
    QFrame* card = makeCard(parent);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 2, 0);
    m_numbers = new QTableWidget(card);
    m_numbers->setObjectName("studyNumbers");
    setUpRowList(m_numbers, numbersRowHeight);
    m_numbers->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents); // none is cut
    m_numbers->horizontalHeader()->setStretchLastSection(true);
    m_numbers->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(m_numbers);
    return card;
}

const StudyResult* StudyOutcome::result() const
{
    const auto& result = m_workbench->study().result();
    return result && *result ? &**result : nullptr;
}

void StudyOutcome::refresh()
{
    const StudySession& session = m_workbench->study();
    if (!session.study())
        return;
    const StudyRecord& record = session.study()->record;
    m_name->setFullText(record.study.name);
    const std::optional<StudyKind> kind = studyKindFromString(record.study.kind);
    m_facts->setParts({kind ? StudyWords::name(*kind) : record.study.kind,
                       timeText(record.ended.value_or(record.begun)), record.study.operatorName,
                       tr("gripper %1").arg(record.study.gripperSerial)},
                      u" · "_s);
    m_report->setEnabled(result() != nullptr);
    m_content->setVisible(result() != nullptr);
    m_categories->setVisible(result() != nullptr && result()->gauge() != nullptr);
    if (result() != nullptr) {
        if (m_shown != record.id)
            showResult(*result());
        return;
    }
    m_shown.clear();
    m_verdict->setText(record.state == StudyState::Abandoned ? tr("This study was given up.")
                       : session.result()                    ? session.result()->error().describe()
                                                             : tr("Being worked out…"));
    m_more->setText(record.endReason);
    m_more->setVisible(!record.endReason.isEmpty());
}

void StudyOutcome::showSentences(const QStringList& sentences)
{
    QString verdict = sentences.value(0);
    m_verdict->setText(verdict.replace(u" < "_s, u"\u00A0<\u00A0"_s)); // "p < 0.001" stays on one line
    m_more->setText(sentences.mid(1).join(u' '));
    m_more->setVisible(sentences.size() > 1);
}

void StudyOutcome::showResult(const StudyResult& result)
{
    const KeptStudy& study = *m_workbench->study().study();
    m_shown = study.record.id;
    m_scroll->verticalScrollBar()->setValue(0); // where the one before was read to means nothing here
    showSentences(described(result.verdict));
    const GaugeResult* const gauge = result.gauge();
    for (QWidget* part : {static_cast<QWidget*>(m_tabs), static_cast<QWidget*>(m_judgement), m_charts,
                          static_cast<QWidget*>(m_remarks)})
        part->setVisible(gauge != nullptr);
    if (gauge != nullptr) {
        m_readingsCard->hide();
        return showGauge(*gauge);
    }
    const CategoryChart chart = StudyCharts::single(study, result);
    m_readingsCard->setVisible(!chart.series.empty());
    m_readings->setChart(chart);
    showNumbers(StudyNumbers::of(result));
}

void StudyOutcome::showGauge(const GaugeResult& gauge)
{
    m_categories->setText(tr("Distinct categories – %1").arg(StudyNumbers::categories(gauge).join(u"; "_s)));
    const QSignalBlocker quiet(m_tabs);
    while (m_tabs->count() > 0)
        m_tabs->removeTab(0);
    for (std::size_t i = gauge.quantities.size(); i-- > 0;)
        m_tabs->addTab(ReferenceWords::quantity(StudyCharts::placeOf(gauge.quantities[i].name)));
    m_tabs->setCurrentIndex(0);
    showQuantity();
}

std::size_t StudyOutcome::quantity() const
{
    return result()->gauge()->quantities.size() - 1 - std::size_t(std::max(0, m_tabs->currentIndex()));
}

void StudyOutcome::showQuantity()
{
    const GaugeResult* const gauge = result() != nullptr ? result()->gauge() : nullptr;
    if (gauge == nullptr || m_tabs->count() == 0)
        return;
    const auto charts = StudyCharts::of(*m_workbench->study().study(), *gauge, quantity());
    for (std::size_t i = 0; i < charts.size(); ++i)
        m_plots[i]->setChart(charts[i]);
    showNumbers(StudyNumbers::of(*result(), quantity()));
    const QStringList remarks = StudyNumbers::remarks(*gauge, quantity());
    m_judgement->setText(remarks.value(0));
    m_judgement->setVisible(!remarks.isEmpty());
    m_remarks->setText(remarks.mid(1).join(u"\n"_s));
    m_remarks->setVisible(remarks.size() > 1);
}

void StudyOutcome::showNumbers(const StudyNumbersTable& table)
{
    m_numbers->setAccessibleName(table.title);
    m_numbers->setColumnCount(int(table.heads.size()));
    m_numbers->setHorizontalHeaderLabels(table.heads);
    m_numbers->setRowCount(int(table.rows.size()));
    for (int row = 0; row < m_numbers->rowCount(); ++row)
        for (int column = 0; column < m_numbers->columnCount(); ++column)
            m_numbers->setItem(row, column, new QTableWidgetItem(table.rows[std::size_t(row)].value(column)));
    m_numbers->setFixedHeight(m_numbers->horizontalHeader()->sizeHint().height() +
                              m_numbers->rowCount() * numbersRowHeight + 2 * m_numbers->frameWidth());
}

void StudyOutcome::focusFirst()
{
    (m_tabs->isVisible() ? static_cast<QWidget*>(m_tabs) : m_csv)->setFocus();
}

void StudyOutcome::chooseFile(const QString& title, const QString& filter, const QString& suffix,
                              void (StudyOutcome::*write)(const QString&))
{
    auto* dialog = new FileDialog(this, title, QString(), filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(u"study."_s + suffix);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, write](const QString& file) { (this->*write)(file); });
    dialog->open();
}

namespace {

/// First into the audit trail, as every export; then `write` in the pool, and what came of it is told.
void exportStudy(Workbench& bench, QWidget* context, const QString& file, const QString& format, qint64 rows,
                 const QString& told, std::function<Expected<void>()> write)
{
    bench.background().ask<void>(
        context, [file, format, rows](Library& library) { return library.tellExport(file, format, rows); },
        [&bench, context, told, write = std::move(write)](const Expected<void>& entered) {
            if (!entered)
                return bench.messages().report(entered.error().describe());
            bench.background().compute<Expected<void>>(
                context, write, [&bench, told](const Expected<void>& done) {
                    if (done)
                        bench.messages().tell(told);
                    else
                        bench.messages().report(done.error().describe());
                });
        });
}

} // namespace

void StudyOutcome::writeCsv(const QString& file)
{
    const std::optional<KeptStudy>& study = m_workbench->study().study();
    if (study)
        exportStudy(*m_workbench, this, file, u"csv"_s, qint64(study->counted().size()),
                    tr("Measurements written to %1").arg(file),
                    [kept = *study, file] { return writeWhole(file, studyCsv(kept)); });
}

void StudyOutcome::writeReport(const QString& file)
{
    if (result() == nullptr)
        return;
    const StudyReport report{*m_workbench->study().study(), *result(),
                             letterheadSource(m_workbench->settings()), m_workbench->operatorName(),
                             QDateTime::currentDateTimeUtc()};
    exportStudy(*m_workbench, this, file, u"pdf"_s, qint64(report.study.counted().size()),
                tr("Report written to %1").arg(file),
                [report, file] { return writeStudyReport(report, file); });
}

} // namespace gripscope
