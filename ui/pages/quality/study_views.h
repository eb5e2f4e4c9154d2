// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/display_units.h"
#include "core/base/error.h"
#include "core/library/records/study_record.h"
#include "core/quality/plan/study_plan.h"
#include "core/session/quality/study_due.h"
#include "core/session/quality/study_result.h"
#include "core/session/quality/study_session.h"

#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QSpinBox;
class QTabBar;
class QTableWidget;
class QVBoxLayout;

namespace gripscope {

class CategoryPlot;
class ElidedLabel;
class ProgressRing;
class QuantityBox;
struct StudyNumbersTable;
class Workbench;

/// All studies of the library: those that are not finished first, then what can be begun, in the order of
/// practice, then what was found before.
class StudyList : public QWidget {
    Q_OBJECT
public:
    explicit StudyList(Workbench& workbench, QWidget* parent = nullptr);
    void load(); ///< asks the library
    /// Newest first, as the library had them when it was last asked.
    [[nodiscard]] const std::vector<StudyRecord>& studies() const { return m_studies; }

signals:
    void beginAsked(gripscope::StudyKind kind);
    void driftAsked();                      ///< what has moved
    void transferAsked();                   ///< types on another gripper
    void openAsked(const QString& studyId); ///< to go on with, or to read
    void processAsked();                    ///< control charts and capability

private:
    void show(std::vector<StudyRecord> studies);
    [[nodiscard]] QWidget* makeKinds();
    [[nodiscard]] QWidget* makeKind(int number, const QString& name, const QString& answer,
                                    const QString& state, QWidget* button);
    [[nodiscard]] QWidget* makeStudy(const StudyRecord& study);
    void fillKinds();
    void fillStudies();
    [[nodiscard]] QString standing(const StudyStanding& standing) const;
    [[nodiscard]] static QString finished(const StudyRecord& last, StudyKind kind);
    [[nodiscard]] QString transferStanding() const;
    [[nodiscard]] QString advice() const;

    Workbench* m_workbench;
    std::vector<StudyRecord> m_studies;
    QString m_serial; ///< of the gripper whose standing is shown; empty: of any
    QLabel* m_advice;
    QWidget *m_open, *m_kinds, *m_done;
    QVBoxLayout *m_openRows, *m_kindRows, *m_doneRows;
};

/// What a study is to be, before its first squeeze. It says what is missing, and how many squeezes it takes.
class StudyForm : public QWidget {
    Q_OBJECT
public:
    explicit StudyForm(Workbench& workbench, QWidget* parent = nullptr);
    void begin(StudyKind kind, const QString& name); ///< with what is usual for that kind
    [[nodiscard]] StudyRequest request() const;
    void focusField();
    void submit(); ///< as Enter does

signals:
    void submitted(const gripscope::StudyRequest& request);
    void cancelled();

private:
    void build();
    void addFields(QFormLayout* form);
    [[nodiscard]] QWidget* makeTolerances();
    [[nodiscard]] QWidget* makeButtons();
    void showRow(QWidget* field, bool on);
    void fillRecipes();
    void askForReferences();
    [[nodiscard]] ShownUnit referenceUnit() const; ///< in which references are typed
    void refresh();
    [[nodiscard]] PlanDesign design() const;
    [[nodiscard]] QString problem() const;

    Workbench* m_workbench;
    StudyKind m_kind = StudyKind::Gauge;
    std::uint64_t m_seed = 1; ///< of the order; nobody is shown it
    QFormLayout* m_form;
    QLabel *m_title, *m_answer, *m_hint;
    QLineEdit *m_name, *m_labels, *m_operators, *m_references;
    QSpinBox *m_parts, *m_trials;
    QComboBox *m_order, *m_quantity, *m_recipe;
    QWidget* m_tolerances;
    std::array<QuantityBox*, 3> m_tolerance{}; ///< m, b, k; 0: not stated
    QPushButton *m_back = nullptr, *m_begin = nullptr;
    std::vector<Recipe> m_recipes;
};

/// Leads through a study: who puts in which part, its squeeze or verdict, how far it is. Of what was measured
/// nothing is seen. A part may be told by its label or a scanner before its squeeze: another one than is
/// asked for is refused. Enter in that field never squeezes.
class StudyLead : public QWidget {
    Q_OBJECT
public:
    explicit StudyLead(Workbench& workbench, QWidget* parent = nullptr);
    void refresh();
    void focusNext(); ///< where Space or the scanner is to go
    void act();       ///< Space: squeezes, or finishes when all is through
    void undo();

signals:
    void paused();

private:
    [[nodiscard]] QWidget* makeTask();
    [[nodiscard]] QWidget* makePart(QWidget* parent);
    [[nodiscard]] QWidget* makeRating(QWidget* parent);
    [[nodiscard]] QWidget* makeSide();
    void refreshTask();
    void refreshButtons();
    void refreshLast();
    [[nodiscard]] QString hint() const;
    [[nodiscard]] bool rated() const; ///< people judge; nothing is squeezed
    [[nodiscard]] bool through() const;
    [[nodiscard]] bool mayGoOn() const; ///< the right part is known to be in
    void takeLabel();
    void squeeze();
    void rate(const QString& word);
    void fillRatings();
    void askSkip();
    void askEnd();
    void tell(const Expected<void>& done);

    Workbench* m_workbench;
    QLabel *m_name, *m_who, *m_part, *m_trial, *m_hint, *m_words, *m_last, *m_wrongPart;
    ProgressRing* m_ring;
    QLineEdit *m_label, *m_word;
    QCheckBox* m_scanFirst;
    QWidget *m_labelBox, *m_ratingBox;
    QHBoxLayout* m_ratings;
    QPushButton *m_arm, *m_act, *m_undo, *m_skip, *m_pause, *m_end;
    std::optional<std::size_t> m_row;      ///< shown
    std::optional<std::size_t> m_labelled; ///< the row whose part was told
    bool m_wrong = false;                  ///< another part was told
    int m_shown = -1;                      ///< state of the session, and whether it is ready
};

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
