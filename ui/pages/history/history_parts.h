// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history_list.h"
#include "core/recognition/types/type_model.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/library/history_document.h"
#include "core/signal/recording/recording.h"
#include "ui/context/stepped_work.h"
#include "ui/format/fact.h"
#include "ui/models/history_model.h"

#include <QFrame>
#include <QHash>
#include <QStringList>
#include <QTableView>
#include <QTimer>

#include <memory>
#include <vector>

class QComboBox;
class QDateEdit;
class QLabel;
class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace gripscope {

class TrendView;
class Workbench;

/// Which squeezes the history shows: words, kind, outcome and type in one line, the rest in a second one that
/// can be folded away.
class HistoryFilterBar : public QWidget {
    Q_OBJECT
public:
    explicit HistoryFilterBar(QWidget* parent = nullptr);

    /// What narrows the query; its order is not the bar's.
    [[nodiscard]] HistoryQuery query() const;
    /// What there is to choose from now; what was chosen stays chosen.
    void setChoices(const HistoryChoices& choices);
    void clear();

signals:
    void changed();

private:
    [[nodiscard]] QWidget* buildFirst();
    [[nodiscard]] QWidget* buildSecond();
    [[nodiscard]] QComboBox* makeBox(const QString& all, const QString& name, const char* objectName);
    void showPeriod();
    void refreshMore();

    QLineEdit* m_text;
    QComboBox *m_kind, *m_outcome, *m_validity, *m_type, *m_expected, *m_operator, *m_device, *m_batch,
        *m_period;
    QDateEdit *m_from, *m_to;
    QPushButton *m_more, *m_clear;
    QWidget* m_second;
    QTimer m_typing; ///< words are applied once a person stops typing
};

/// The list of squeezes: sorted by the header, columns chosen by a person, any number of rows selected, the
/// selection kept when the list starts anew.
class HistoryTable : public QTableView {
    Q_OBJECT
public:
    explicit HistoryTable(HistoryModel* model, QWidget* parent = nullptr);

    /// Tick marks that show and hide columns.
    [[nodiscard]] QMenu* columnsMenu() const { return m_columns; }
    /// First and last row of each stretch that is selected, in the order of the list.
    [[nodiscard]] std::vector<std::pair<int, int>> selectedRows() const;
    [[nodiscard]] qint64 selectedCount() const;
    /// In the order of the list; nothing where the model does not know all of them, or they are too many.
    [[nodiscard]] std::optional<std::vector<QString>> selectedKeys() const;
    [[nodiscard]] bool severalSelected() const;
    [[nodiscard]] QString currentKey() const; ///< empty: none, or not known yet
    void select(int row);                     ///< alone, and brings it into view
    /// Of the current key and those that are selected, where they are few and known.
    [[nodiscard]] QHash<QString, int> rowsToKeep() const;
    /// Starts the model anew; what was selected and is still there stays so. `rows`: where the kept keys are
    /// in a list that does not know them all.
    void restart(std::shared_ptr<const HistoryList> list, std::vector<HistoryEntry> first,
                 const QHash<QString, int>& rows);

signals:
    void chosen(); ///< another current row, another selection

protected:
    void selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void buildHeader();
    void buildColumnsMenu();
    [[nodiscard]] int titleWidth(int column) const;
    void fitColumns();
    void reselect(const std::vector<QString>& keys, const QString& current, const QHash<QString, int>& rows);

    HistoryModel* m_model;
    QMenu* m_columns;
    bool m_restarting = false, m_fitted = false;
};

/// m, b and k of the squeezes that the filters let through, over time or one after another, with the types'
/// signs named above.
class HistoryCharts : public QWidget {
    Q_OBJECT
public:
    explicit HistoryCharts(QWidget* parent = nullptr);

    /// `gates`: of gateIntervals().
    void setPoints(std::shared_ptr<const HistoryPoints> points, const TypeModels& models,
                   std::vector<GateIntervals> gates);
    void select(const QString& key);
    [[nodiscard]] TrendView* view() const { return m_view; }

signals:
    void chosen(const QString& key);

private:
    class Legend;
    void refresh();
    void refreshNote();

    std::shared_ptr<const HistoryPoints> m_points;
    TypeModels m_models;
    std::vector<GateIntervals> m_gates;
    TrendView* m_view;
    Legend* m_legend;
    QPushButton *m_byTime, *m_byPlace;
    QLabel* m_note;
};

/// All that is known of the squeeze that is chosen.
class HistoryDetails : public QFrame {
    Q_OBJECT
public:
    explicit HistoryDetails(QWidget* parent = nullptr);

    void show(const SqueezeDetails& details);
    void clear();

private:
    void addHeading(QVBoxLayout* column, const QString& text);
    void addFacts(QVBoxLayout* column, const std::vector<Fact>& facts);
    void addOutcome(QVBoxLayout* column, const HistoryEntry& entry);
    void addEstimates(QVBoxLayout* column, const SqueezeDetails& details);
    void addBudget(QVBoxLayout* column, const SqueezeDetails& details);

    QScrollArea* m_scroll;
};

/// What the history is writing: how far it is, and Cancel. Hidden while nothing is written.
class HistoryWork : public QFrame {
    Q_OBJECT
public:
    explicit HistoryWork(Workbench& workbench, QWidget* parent = nullptr);

    /// One at a time; `doing`: "Writing history.csv"; `done` is told when all of it was.
    void run(SteppedWork::Step step, const QString& doing, const QString& done);
    /// The report, which is read on the library's thread and drawn in the pool.
    void writeReport(const HistoryQuery& query, const QString& file);
    [[nodiscard]] bool busy() const { return m_busy; }

signals:
    void busyChanged();

private:
    void begin(const QString& doing);
    void end();

    Workbench* m_workbench;
    QLabel* m_text;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    bool m_busy = false;
};

/// Steps that write all that a query finds to `file`, whole or not at all.
[[nodiscard]] SteppedWork::Step historyExport(const HistoryQuery& query, HistoryFormat format,
                                              const QString& file);
/// Steps that write the recordings of these squeezes as CSV files into `folder`; those that have none are
/// left out. One whose name is taken gets a number behind it.
[[nodiscard]] SteppedWork::Step recordingExport(std::vector<QString> graspIds, const QString& folder);
/// "inspection_000412.csv", "enrolment_Can_G1B2.csv": the end of the key tells squeezes of a type apart.
[[nodiscard]] QString recordingFileName(const HistoryEntry& entry);

/// Fills an empty history for a tour: seven simulated squeezes of the paper's cans and one of a stranger,
/// judged and stored one after another by the session like any others. Their source says that they are
/// simulated. A history that holds anything is left alone.
class ExampleInspections : public QObject {
    Q_OBJECT
public:
    ExampleInspections(Workbench& workbench, QObject* parent);

    void start();
    [[nodiscard]] bool busy() const { return m_busy; }

signals:
    void finished();

private:
    void judgeNext();
    void finish();

    Workbench* m_workbench;
    std::vector<Recording> m_waiting;
    bool m_busy = false, m_simulated = false;
};

} // namespace gripscope
