// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/process/process_signal_list.h"

#include "core/session/process/process_words.h"
#include "ui/format/number_format.h"
#include "ui/pages/quality/process/process_names.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/row_list.h"

#include <QHeaderView>
#include <QTableWidget>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int signalRowHeight = 28; // logical pixels
constexpr int widthWithTime = 760;  // in less the words of a signal need what the time would take
constexpr int signalTimeColumn = 4;
constexpr std::size_t mostSignalLines = 500; // more are read by nobody

bool isShown(std::size_t own, std::size_t quantity)
{
    return quantity >= ProcessNames::allQuantities || own == quantity;
}

/// T^2 alone, or those of the quantities that are shown.
template <typename Visit>
void forShownCharts(const ProcessPicture& picture, std::size_t quantity, const Visit& visit)
{
    if (picture.joint) {
        if (*picture.joint)
            visit(**picture.joint);
        return;
    }
    for (std::size_t i = 0; i < picture.charts.size(); ++i)
        if (isShown(i, quantity) && picture.charts[i])
            visit(*picture.charts[i]);
}

std::uint32_t rowOf(const QuantityChart& chart, std::size_t point)
{
    return chart.row(point);
}
std::uint32_t rowOf(const JointChart& chart, std::size_t point)
{
    return chart.rows[point];
}

std::size_t pointCount(const QuantityChart& chart)
{
    return chart.points();
}
std::size_t pointCount(const JointChart& chart)
{
    return chart.points.size();
}

template <typename Chart>
void addLines(const ProcessPicture& picture, const Chart& chart, std::size_t most,
              std::vector<SignalLine>& lines)
{
    const std::size_t all = chart.signalsFound.size();
    for (std::size_t i = all - std::min(all, most); i < all; ++i) {
        const ProcessSignal& signal = chart.signalsFound[i];
        const SignalNumbers numbers = signalNumbers(chart, *picture.values, signal);
        SignalLine line;
        line.quantity = signal.joint ? u"T²"_s : processSymbol(signal.quantity);
        line.what = signalReason(signal, picture.options).capitalized().describe();
        line.since = QString::number(numbers.since);
        line.number = numbers.first;
        line.row = rowOf(chart, signal.first);
        line.point = signal.first;
        line.time = ProcessNames::time(*picture.values, line.row);
        lines.push_back(line);
    }
}

} // namespace

std::vector<SignalLine> signalLines(const ProcessPicture& picture, std::size_t quantity, std::size_t most)
{
    std::vector<SignalLine> lines;
    forShownCharts(picture, quantity, [&](const auto& chart) { addLines(picture, chart, most, lines); });
    std::ranges::stable_sort(lines, std::ranges::greater(), &SignalLine::number);
    if (lines.size() > most)
        lines.resize(most);
    return lines;
}

std::size_t countSignals(const ProcessPicture& picture, std::size_t quantity)
{
    std::size_t count = 0;
    forShownCharts(picture, quantity, [&count](const auto& chart) { count += chart.signalsFound.size(); });
    return count;
}

std::size_t countPoints(const ProcessPicture& picture, std::size_t quantity)
{
    std::size_t count = 0;
    forShownCharts(picture, quantity, [&count](const auto& chart) { count += pointCount(chart); });
    return count;
}

ProcessSignalList::ProcessSignalList(QWidget* parent) : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 4);
    m_verdict = makeLabel({}, "strong", this);
    m_verdict->setObjectName("processVerdict");
    m_verdict->setWordWrap(true);
    column->addWidget(m_verdict);
    m_table = new QTableWidget(0, 5, this);
    m_table->setObjectName("processSignals");
    m_table->setAccessibleName(tr("Signals"));
    m_table->setHorizontalHeaderLabels(
        {tr("Inspection"), tr("Of"), tr("Signal"), tr("Since inspection"), tr("Time")});
    setUpRowList(m_table, signalRowHeight);
    letRowsWrap(m_table); // what a signal is has to be read whole
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    m_table->setMinimumHeight(2 * signalRowHeight);
    column->addWidget(m_table, 1);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0 && std::size_t(row) < m_lines.size())
            emit pointShown(qsizetype(m_lines[std::size_t(row)].point));
    });
    connect(m_table, &QTableWidget::cellActivated, this, [this](int row) {
        if (row >= 0 && std::size_t(row) < m_lines.size())
            emit rowChosen(m_lines[std::size_t(row)].row);
    });
}

void ProcessSignalList::resizeEvent(QResizeEvent* event)
{
    m_table->setColumnHidden(signalTimeColumn, width() < widthWithTime); // History has it
    QWidget::resizeEvent(event);
}

QString ProcessSignalList::verdict(const ProcessPicture& picture, std::size_t quantity, std::size_t all) const
{
    if (all == 0)
        return tr("Steady: no signal.");
    QString text = all == 1 ? tr("Not steady: one signal.")
                            : tr("Not steady: %1 signals.").arg(formatCount(qint64(all)));
    if (all > m_lines.size())
        text = tr("Not steady: %1 signals; the newest %2 are listed.")
                   .arg(formatCount(qint64(all)), formatCount(qint64(m_lines.size())));
    const Finding chance = chanceSentence(countPoints(picture, quantity), picture.runLengths);
    return chance.isEmpty() ? text : text + u' ' + chance.describe();
}

void ProcessSignalList::show(const std::shared_ptr<const ProcessPicture>& picture, std::size_t quantity)
{
    m_lines = picture ? signalLines(*picture, quantity, mostSignalLines) : std::vector<SignalLine>();
    const std::size_t all = picture ? countSignals(*picture, quantity) : 0;
    const QSignalBlocker quiet(m_table);
    m_table->setRowCount(int(m_lines.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const SignalLine& line = m_lines[std::size_t(row)];
        const QStringList cells{QString::number(line.number), line.quantity, line.what, line.since,
                                line.time};
        for (int column = 0; column < cells.size(); ++column)
            m_table->setItem(row, column, new QTableWidgetItem(cells[column]));
    }
    m_table->setVisible(!m_lines.empty());
    m_verdict->setText(picture ? verdict(*picture, quantity, all) : QString());
}

} // namespace gripscope
