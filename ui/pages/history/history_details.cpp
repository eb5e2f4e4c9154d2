// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/date_text.h"
#include "ui/format/history_words.h"
#include "ui/pages/history/history_parts.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/outcome_view.h"

#include <QGridLayout>
#include <QJsonArray>
#include <QLocale>
#include <QPainter>
#include <QScrollArea>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int panelWidth = 304;
constexpr int nameWidth = 96;

/// The sign of an outcome, in the colours in force when it is painted.
class OutcomeSign : public QWidget {
public:
    OutcomeSign(InspectionOutcome outcome, bool suspect) : m_outcome(outcome), m_suspect(suspect)
    {
        setFixedSize(24, 24);
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        paintJudgedSign(painter, QRectF(rect()).adjusted(1, 1, -1, -1), m_outcome, m_suspect);
    }

private:
    InspectionOutcome m_outcome;
    bool m_suspect;
};

/// A source may be one long word: it breaks where its parts meet, or the panel would be cut at its side.
QString breakable(const QString& text)
{
    constexpr qsizetype longest = 20;
    QStringList words = text.split(u' ');
    for (QString& word : words)
        if (word.size() > longest)
            for (const QChar mark : {u'&', u',', u'/', u'_', u'='})
                word.replace(mark, mark + QString(QChar(0x200B)));
    return words.join(u' ');
}

QLabel* wrapped(const QString& text, const char* role = "")
{
    QLabel* label = makeLabel(breakable(text), role);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

HistoryDetails::HistoryDetails(QWidget* parent) : QFrame(parent), m_scroll(new QScrollArea)
{
    setRole(this, "card");
    setFixedWidth(panelWidth);
    setAccessibleName(tr("The squeeze that is chosen"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setAccessibleName(accessibleName());
    column->addWidget(m_scroll);
    clear();
}

void HistoryDetails::clear()
{
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 2 * metrics::step, metrics::step);
    column->addWidget(wrapped(tr("Choose a squeeze to see all that is known of it."), "second"));
    column->addStretch();
    m_scroll->setWidget(content);
}

void HistoryDetails::show(const SqueezeDetails& details)
{
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 2 * metrics::step, metrics::step);
    column->addWidget(wrapped(HistoryWords::title(details.entry), "heading"));
    addOutcome(column, details.entry);
    addEstimates(column, details);
    addHeading(column, tr("Where it comes from"));
    addFacts(column, HistoryWords::facts(details));
    addBudget(column, details);
    column->addStretch();
    m_scroll->setWidget(content); // the one before goes with it
}

void HistoryDetails::addHeading(QVBoxLayout* column, const QString& text)
{
    column->addWidget(makeRule());
    column->addWidget(wrapped(text, "strong"));
}

void HistoryDetails::addFacts(QVBoxLayout* column, const std::vector<Fact>& facts)
{
    auto* grid = new QGridLayout;
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::step);
    grid->setVerticalSpacing(metrics::insideControl);
    grid->setColumnMinimumWidth(0, nameWidth);
    grid->setColumnStretch(1, 1);
    int row = 0;
    for (const Fact& fact : facts) {
        QLabel* name = wrapped(fact.name, "second");
        name->setMaximumWidth(nameWidth);
        grid->addWidget(name, row, 0, Qt::AlignTop);
        grid->addWidget(wrapped(fact.text), row++, 1, Qt::AlignTop);
    }
    column->addLayout(grid);
}

void HistoryDetails::addOutcome(QVBoxLayout* column, const HistoryEntry& entry)
{
    if (const auto outcome = entry.outcome()) {
        auto* line = new QHBoxLayout;
        line->setSpacing(metrics::step);
        line->addWidget(new OutcomeSign(*outcome, entry.suspect()));
        const QString word = HistoryWords::outcome(entry);
        line->addWidget(wrapped(entry.type.isEmpty() ? word : u"%1 · %2"_s.arg(entry.type, word), "strong"),
                        1);
        column->addLayout(line);
    }
    if (!entry.reason.isEmpty())
        column->addWidget(wrapped(entry.reason.describe()));
}

void HistoryDetails::addEstimates(QVBoxLayout* column, const SqueezeDetails& details)
{
    bool later = false;
    for (const StoredEstimate& estimate : details.estimates) {
        if (estimate.rank > 0 && !estimate.again)
            continue; // beside the recommended one from the start: the Fit page compares those
        addHeading(column, estimate.again
                               ? tr("Identified again: %1").arg(HistoryWords::estimator(estimate.estimator))
                               : HistoryWords::estimator(estimate.estimator));
        std::vector<Fact> facts =
            HistoryWords::parameters(estimate, details.entry.forceUnit, details.entry.positionUnit);
        if (estimate.simulationFitPercent)
            facts.push_back(
                {tr("Simulation fit"),
                 QLocale().toString(*estimate.simulationFitPercent, 'f', 1) + QChar::Nbsp + u'%'});
        if (estimate.again) {
            facts.push_back({tr("How"), HistoryWords::how(*estimate.again), false});
            facts.push_back({tr("By"), estimate.again->operatorName, false});
            facts.push_back({tr("When"), timeText(estimate.stored), false});
            facts.push_back({tr("Software"), estimate.program, false});
            later = true;
        }
        addFacts(column, facts);
    }
    if (later)
        column->addWidget(
            wrapped(tr("The verdict stays the one of its day; later estimates stand beside it."), "second"));
}

void HistoryDetails::addBudget(QVBoxLayout* column, const SqueezeDetails& details)
{
    const QJsonObject budget = details.document.value(u"budget"_s).toObject();
    std::vector<Fact> facts;
    for (const QJsonValue value : budget.value(u"lines"_s).toArray()) {
        const QJsonObject line = value.toObject();
        const QJsonObject share = line.value(u"share"_s).toObject();
        const std::optional<Finding> finding = Finding::fromJson(line.value(u"finding"_s));
        const QString words = finding ? finding->describe() : line.value(u"message"_s).toString();
        const auto percent = [&share](const QString& name) {
            return QLocale().toString(100 * share.value(name).toDouble(), 'f', 0);
        };
        facts.push_back({tr("%1, %2, %3 %").arg(percent(u"m"_s), percent(u"b"_s), percent(u"k"_s)),
                         asSentence(words), false});
    }
    if (facts.empty())
        return;
    addHeading(column, tr("Uncertainty of m, b, k comes from"));
    addFacts(column, facts);
}

} // namespace gripscope
