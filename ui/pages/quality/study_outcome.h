// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/quality/study_result.h"

#include <QWidget>

#include <array>

class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QTabBar;
class QTableWidget;

namespace gripscope {

class CategoryPlot;
class ElidedLabel;
struct StudyNumbersTable;
class Workbench;

/// What a finished study says: the verdict in plain sentences, then charts and numbers, of a gauge study
/// those of the quantity that is chosen; report and table of values.
class StudyOutcome : public QWidget {
    Q_OBJECT
public:
    explicit StudyOutcome(Workbench& workbench, QWidget* parent = nullptr);
    void refresh();
    void focusFirst();
    void writeCsv(const QString& file);
    void writeReport(const QString& file);

signals:
    void left(); ///< back to the list

private:
    [[nodiscard]] QWidget* makeHead();
    [[nodiscard]] QWidget* makeCharts(QWidget* parent);
    [[nodiscard]] QWidget* makeNumbers(QWidget* parent);
    void showResult(const StudyResult& result);
    void showGauge(const GaugeResult& gauge);
    void showSentences(const QStringList& sentences);
    void showQuantity();
    void showNumbers(const StudyNumbersTable& table);
    void chooseFile(const QString& title, const QString& filter, const QString& suffix,
                    void (StudyOutcome::*write)(const QString&));
    [[nodiscard]] const StudyResult* result() const;
    [[nodiscard]] std::size_t quantity() const; ///< place in the result

    Workbench* m_workbench;
    ElidedLabel *m_name, *m_facts;
    QLabel *m_verdict, *m_more, *m_categories, *m_judgement, *m_remarks;
    QTabBar* m_tabs;
    QWidget *m_content, *m_charts;
    QScrollArea* m_scroll;
    QTableWidget* m_numbers;
    std::array<CategoryPlot*, 5> m_plots{};
    QPushButton *m_csv, *m_report;
    CategoryPlot* m_readings; ///< the one chart of other kinds than gauge studies
    QWidget* m_readingsCard;
    QString m_shown; ///< the study whose result is shown
};

} // namespace gripscope
