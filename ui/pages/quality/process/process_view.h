// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/process/process_session.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace gripscope {

class ControlView;
class ElidedLabel;
class ProcessCapabilityPanel;
class ProcessControls;
class ProcessSignalList;
class Workbench;

/// Is what is made steady, and within its limits? Control charts of m, b and k of a type's inspections, their
/// signals in words, limits that can be fixed from the inspections in view, and beside them the capability.
/// Goes on by itself while parts are inspected.
class ProcessView : public QWidget {
    Q_OBJECT
public:
    explicit ProcessView(Workbench& workbench, QWidget* parent = nullptr);
    ~ProcessView() override;
    void setActive(bool active); ///< out of view nothing is read
    void focusFirst();
    void writeCsv(const QString& file);
    void writeReport(const QString& file);
    [[nodiscard]] const ProcessSession& session() const { return m_session; }

signals:
    void left();                               ///< back to the list
    void squeezeAsked(const QString& graspId); ///< to be shown in the history

private:
    [[nodiscard]] QWidget* makeHead();
    [[nodiscard]] QWidget* makeBusy();
    [[nodiscard]] QWidget* makeCharts();
    [[nodiscard]] QWidget* makeSide();
    void connectAll();
    void askChoices();
    void takeQuery();
    void takeOptions();
    void poll();
    void showState();
    void showPicture();
    void showEmpty();
    void fixLimits();
    void openRow(quint32 row);
    void chooseFile(const QString& title, const QString& filter, const QString& suffix,
                    void (ProcessView::*write)(const QString&));

    Workbench* m_workbench;
    ProcessSession m_session;
    bool m_active = false;
    bool m_asked = false; ///< the library was asked what there is to choose from
    std::shared_ptr<const ProcessPicture> m_shown;
    std::optional<Error> m_told;
    ProcessControls* m_controls;
    ElidedLabel* m_facts;
    QPushButton *m_fix, *m_release, *m_csv, *m_report, *m_cancel, *m_again;
    QProgressBar* m_progress;
    QLabel *m_doing, *m_empty, *m_limits, *m_missing, *m_runLengths;
    QWidget *m_busy, *m_content;
    ControlView* m_charts;
    ProcessSignalList* m_signals;
    ProcessCapabilityPanel* m_capability;
};

} // namespace gripscope
