// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/library.h"

#include <QWidget>

class QLabel;

namespace gripscope {

class InspectBatch;
class InspectionList;
class Workbench;
class YieldStrip;

/// The side of the Inspect page: how many parts, how many as expected, the last of them one by one, and their
/// strip.
class InspectSummary : public QWidget {
    Q_OBJECT
public:
    explicit InspectSummary(Workbench& workbench, QWidget* parent = nullptr);

    /// Whose record of right and wrong is shown; empty: that of all types together.
    void setExpected(const QString& type);
    [[nodiscard]] InspectBatch& batch() const { return *m_batch; }

private:
    void refreshCounts();
    void refreshEvidence(const InspectionCounts& counts);
    void reload();
    void open(const QString& graspId, qint64 number);
    Workbench* m_workbench;
    QString m_expected;
    QLabel *m_total, *m_share, *m_split, *m_shown, *m_empty;
    InspectBatch* m_batch;
    InspectionList* m_list;
    YieldStrip* m_strip;
};

} // namespace gripscope
