// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/context/workbench.h"
#include "ui/pages/history/history_page.h"
#include "ui/pages/history/history_parts.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"

#include <QStackedWidget>

namespace gripscope {

struct HistoryPage::Private {
    HistoryModel* model = nullptr;
    std::shared_ptr<const HistoryList> shown = std::make_shared<HistoryList>();
    HistoryTable* table = nullptr;
    HistoryCharts* charts = nullptr;
    HistoryDetails* details = nullptr;
    HistoryFilterBar* filters = nullptr;
    HistoryWork* work = nullptr;
    QStackedWidget* stack = nullptr;
    QPushButton *list = nullptr, *trend = nullptr, *open = nullptr, *again = nullptr, *save = nullptr,
                *columns = nullptr;
    QAction* recordings = nullptr;
    ElidedLabel* counts = nullptr;
    QLabel *emptyTitle = nullptr, *emptyText = nullptr;
    HistoryColumn order = HistoryColumn::Time;
    bool descending = true;
    std::vector<int> waiting; ///< pages that were asked for, the last first to be fetched
    bool fetching = false;
    int generation = 0; ///< of the list; answers to an older one do not count
    int pointsGeneration = -1;
    QString detailed; ///< whose details are shown or on their way
    bool stale = true, loading = false;
    bool choosesFirst = false; ///< of the next list
    QString wanted;            ///< the key of what the next list chooses
    ExampleInspections* examples = nullptr;
};

} // namespace gripscope
