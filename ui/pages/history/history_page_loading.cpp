// SPDX-License-Identifier: GPL-3.0-or-later
// What the page asks the library for, and what becomes of the answers.
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/pages/history/history_page_private.h"

#include <QHash>

#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t mostPagesWaiting = 3; ///< while the list is scrolled fast, only the last are fetched

/// What one visit to the library brings back.
struct HistoryStart {
    bool empty = false; ///< the whole library
    HistoryChoices choices;
    HistoryList list;
    std::vector<HistoryEntry> first;
    QHash<QString, int> rows; ///< of what was selected, where the list does not know
};

/// How far the rows of a list have moved since the one before it; nothing where they cannot be told. Of a
/// filter nobody knows without counting.
Expected<std::optional<qint64>> movedSince(Library& library, const HistoryList& before,
                                           const HistoryList& list)
{
    if (!list.walked || !list.query.everything() || !(before.query == list.query))
        return std::nullopt;
    if (!list.query.descending)
        return 0; // what came is behind them
    return library.historyRow(list, before.newest.key);
}

/// `kept`: the rows in the list `before` of what should stay selected.
Expected<HistoryStart> fetchStart(Library& library, const HistoryQuery& query, const HistoryList& before,
                                  const QHash<QString, int>& kept)
{
    HistoryStart start;
    ASSIGN_OR_RETURN(start.choices, library.historyChoices());
    ASSIGN_OR_RETURN(start.list, library.historyList(query));
    ASSIGN_OR_RETURN(start.first, library.historyPage(start.list, 0, HistoryModel::pageSize));
    start.empty = start.list.rows == 0 && start.choices.operators.isEmpty() && query.everything();
    ASSIGN_OR_RETURN(const std::optional<qint64> moved, movedSince(library, before, start.list));
    if (moved)
        for (auto row = kept.cbegin(); row != kept.cend(); ++row)
            start.rows.insert(row.key(), row.value() + int(*moved));
    return start;
}

} // namespace

void HistoryPage::reload()
{
    const int generation = ++d->generation;
    d->stale = false;
    d->loading = true;
    workbench().background().ask<HistoryStart>(
        this,
        [wanted = query(), before = d->shown, kept = d->table->rowsToKeep()](Library& library) {
            return fetchStart(library, wanted, *before, kept);
        },
        [this, generation](Expected<HistoryStart> start) {
            if (generation != d->generation)
                return;
            d->loading = false;
            if (!start) {
                workbench().messages().report(start.error().describe());
                return;
            }
            d->waiting.clear();
            d->filters->setChoices(start->choices);
            d->shown = std::make_shared<HistoryList>(std::move(start->list));
            showCounts();
            d->emptyTitle->setText(start->empty ? tr("No squeezes yet") : tr("Nothing matches the filters"));
            d->emptyText->setText(
                start->empty
                    ? tr("Squeeze a part on the Inspect page, or enroll a type: every squeeze is kept here.")
                    : tr("Clear the search and the filters to see every squeeze."));
            d->detailed.clear();
            d->table->restart(d->shown, std::move(start->first), start->rows);
            if (std::exchange(d->choosesFirst, false))
                d->table->selectRow(0);
            showContent();
            if (!d->wanted.isEmpty())
                choose(std::exchange(d->wanted, {}));
            loadPoints();
            countOn();
        });
}

void HistoryPage::showSqueeze(const QString& graspId)
{
    d->wanted = graspId;
    d->list->setChecked(true);
    d->filters->clear(); // which reads the list anew
}

/// Others have their turn at the library between two stretches.
void HistoryPage::countOn()
{
    if (d->shown->through)
        return;
    workbench().background().ask<HistoryList>(
        this, [list = d->shown](Library& library) { return library.historyStretch(*list); },
        [this, generation = d->generation](Expected<HistoryList> list) {
            if (generation != d->generation)
                return;
            if (!list) {
                workbench().messages().report(list.error().describe());
                return;
            }
            d->shown = std::make_shared<HistoryList>(std::move(*list));
            d->model->goOn(d->shown);
            showCounts();
            loadPoints();
            countOn();
        });
}

void HistoryPage::showCounts()
{
    const HistoryList& list = *d->shown;
    QString words = list.counted ? HistoryWords::summary(list.counts)
                                 : tr("Counting: %1 so far").arg(formatCount(list.counts.total()));
    if (list.cut) {
        const bool oldest = list.query.order == HistoryColumn::Number && !list.query.descending;
        words = (oldest ? tr("Sorted: only the oldest %1") : tr("Sorted: only the newest %1"))
                    .arg(formatCount(list.rows)) +
                u" · "_s + words;
    }
    d->counts->setFullText(words);
    d->counts->setVisible(!words.isEmpty());
}

void HistoryPage::fetchPage()
{
    if (d->fetching || d->waiting.empty())
        return;
    while (d->waiting.size() > mostPagesWaiting) {
        d->model->forgetRequest(d->waiting.front());
        d->waiting.erase(d->waiting.begin());
    }
    const int page = d->waiting.back();
    d->waiting.pop_back();
    d->fetching = true;
    workbench().background().ask<std::vector<HistoryEntry>>(
        this,
        [list = d->shown, page](Library& library) {
            return library.historyPage(*list, qint64(page) * HistoryModel::pageSize, HistoryModel::pageSize);
        },
        [this, page, generation = d->generation](Expected<std::vector<HistoryEntry>> entries) {
            d->fetching = false;
            if (!entries)
                workbench().messages().report(entries.error().describe());
            if (generation == d->generation)
                d->model->setPage(page, entries.value_or(std::vector<HistoryEntry>{}));
            if (const QString current = d->table->currentKey(); !current.isEmpty() && current != d->detailed)
                loadDetails(); // it was not known yet which one it is
            fetchPage();
        });
}

void HistoryPage::loadPoints()
{
    if (!d->trend->isChecked() || d->pointsGeneration == d->generation || !d->shown->counted)
        return;
    d->pointsGeneration = d->generation;
    workbench().background().ask<HistoryPoints>(
        this, [list = d->shown](Library& library) { return library.historyPoints(*list); },
        [this, generation = d->generation](Expected<HistoryPoints> points) {
            if (generation != d->generation)
                return;
            if (!points) {
                workbench().messages().report(points.error().describe());
                return;
            }
            showPoints(std::make_shared<HistoryPoints>(std::move(*points)));
        });
}

void HistoryPage::showPoints(std::shared_ptr<const HistoryPoints> points)
{
    const TypeModels& models = workbench().inspection().models();
    const VerdictOptions rates = workbench().rates().rates;
    workbench().background().compute<std::vector<GateIntervals>>(
        this, [models, rates] { return gateIntervals(models, rates); },
        [this, points, models, generation = d->generation](std::vector<GateIntervals> gates) {
            if (generation != d->generation)
                return;
            d->charts->setPoints(points, models, std::move(gates));
            d->charts->select(d->table->currentKey());
        });
}

/// A point of the charts.
void HistoryPage::choose(const QString& key)
{
    if (const int row = d->model->rowOf(key); row >= 0 || !d->shown->walked) {
        d->table->select(row);
        return;
    }
    workbench().background().ask<std::optional<qint64>>(
        this, [list = d->shown, key](Library& library) { return library.historyRow(*list, key); },
        [this, generation = d->generation](Expected<std::optional<qint64>> row) {
            if (!row)
                workbench().messages().report(row.error().describe());
            else if (*row && generation == d->generation)
                d->table->select(int(**row));
        });
}

void HistoryPage::loadDetails()
{
    const QString key = d->table->currentKey();
    d->charts->select(key);
    if (key == d->detailed && !key.isEmpty())
        return;
    d->detailed = key;
    if (key.isEmpty()) {
        d->details->clear();
        return;
    }
    workbench().background().ask<SqueezeDetails>(
        this, [key](Library& library) { return library.squeezeDetails(key); },
        [this, key](Expected<SqueezeDetails> details) {
            if (key != d->detailed)
                return; // another one was chosen meanwhile
            if (details)
                d->details->show(*details);
            else
                workbench().messages().report(details.error().describe());
        });
}

} // namespace gripscope
