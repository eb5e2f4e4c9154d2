// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/identification/result/identification_result.h"
#include "core/identification/uncertainty/uncertainty_budget.h"
#include "core/signal/preparation/preparation.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QTabWidget;
class QTableView;
class QVBoxLayout;

namespace gripscope {

class BudgetTableModel;
class ComparisonTableModel;
class ElidedLabel;
class EstimateTableModel;
class RegionPlot;
class ValidationPanel;

/// The estimators against each other: a table whose current row is the model that the plots show.
class EstimatorPanel : public QWidget {
    Q_OBJECT
public:
    explicit EstimatorPanel(QWidget* parent = nullptr);

    void setIdentification(const Identification& identification, const QString& forceUnit,
                           const QString& positionUnit);
    [[nodiscard]] EstimateTableModel* model() const { return m_model; }

signals:
    void estimatorChosen(gripscope::Estimator estimator);

private:
    void buildTable();

    EstimateTableModel* m_model;
    QTableView* m_table;
    QLabel* m_note;
};

/// A tick, a dash (nothing was judged), a warning or a cross, drawn; told apart by shape, and named for a
/// screen reader.
enum class CheckSign { Pass, Noted, Warning, Fail };

class CheckSignLabel : public QWidget {
    Q_OBJECT
public:
    explicit CheckSignLabel(CheckSign sign, QWidget* parent = nullptr);
    void setSign(CheckSign sign);
    QSize sizeHint() const override { return {20, 20}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    CheckSign m_sign;
};

/// The verdict on the measurement, with its sign: "Measurement valid".
class ValidityLine : public QWidget {
    Q_OBJECT
public:
    explicit ValidityLine(QWidget* parent = nullptr);
    void setVerdict(ValidityVerdict verdict);

private:
    CheckSignLabel* m_sign;
    QLabel* m_words;
};

/// Every check with what was found, those that failed first; then what was done to the recording before.
class CheckList : public QWidget {
    Q_OBJECT
public:
    explicit CheckList(QWidget* parent = nullptr);
    void setFindings(const Validity& validity, const std::vector<PreparationStep>& preparation);

private:
    QVBoxLayout* m_rows;
};

/// The uncertainty budget: a table of effects, and in words what the effect of the current row is.
class BudgetPanel : public QWidget {
    Q_OBJECT
public:
    explicit BudgetPanel(QWidget* parent = nullptr);

    void setBudget(const UncertaintyBudget& budget, const QString& forceUnit, const QString& positionUnit);
    [[nodiscard]] BudgetTableModel* model() const { return m_model; }

private:
    void showWords(int row);

    BudgetTableModel* m_model;
    QTableView* m_table;
    QLabel* m_words;
    QLabel* m_message;
};

/// What the error bars are worth: what would make them better, what they are made of, what else follows from
/// m, b and k.
class UncertaintyPanel : public QWidget {
    Q_OBJECT
public:
    explicit UncertaintyPanel(QWidget* parent = nullptr);

    void setIdentification(const Identification& identification, const QString& forceUnit,
                           const QString& positionUnit);

private:
    void showAdvice(const Identification& identification);
    void showBudget(const Identification& identification, const QString& forceUnit,
                    const QString& positionUnit);
    void showDerived(const Identification& identification);

    QLabel* m_adviceHead;
    QLabel* m_advice;
    QLabel* m_budgetHead;
    BudgetPanel* m_budget;
    QLabel* m_derivedHead;
    QGridLayout* m_derived;
};

/// Which model explains the squeeze, in one sentence and as a table; how it does on other data; and, where
/// the force repeats, what its periods tell.
class ModelPanel : public QWidget {
    Q_OBJECT
public:
    explicit ModelPanel(QWidget* parent = nullptr);

    void setIdentification(const Identification& identification, const QString& forceUnit,
                           const QString& positionUnit);
    void setComparison(const ModelComparison& comparison); ///< this part alone
    [[nodiscard]] ValidationPanel* validation() const { return m_validation; }

private:
    void setPeriods(const std::optional<PeriodicDiagnostics>& periods, const QString& forceUnit,
                    const QString& positionUnit);

    ComparisonTableModel* m_model;
    QLabel* m_sentence;
    QTableView* m_table;
    QLabel* m_note;
    ValidationPanel* m_validation;
    QWidget* m_periods;
    QLabel* m_periodWords;
    QGridLayout* m_periodFacts;
};

/// The right third of the Fit page. Always in view: what was squeezed, the verdict on the measurement, m, b
/// and k with their error bars. Behind tabs: the estimators against each other, the joint region, the checks,
/// what the uncertainty is made of, other models.
class FitSummary : public QWidget {
    Q_OBJECT
public:
    explicit FitSummary(QWidget* parent = nullptr);

    void show(const QString& title, const Identification& identification, double length_s,
              const QString& forceUnit, const QString& positionUnit);
    using QWidget::show;
    [[nodiscard]] EstimateTableModel* table() const;
    [[nodiscard]] RegionPlot* regionPlot() const { return m_region; }
    [[nodiscard]] ValidationPanel* validation() const;
    void showValidation(const Validation& validation);

signals:
    void estimatorChosen(gripscope::Estimator estimator); ///< a row of the table

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* buildHead();
    void buildTabs();
    void addTab(QWidget* body, const QString& title);
    void showBest();

    Identification m_identification;
    QString m_forceUnit, m_positionUnit;
    ElidedLabel* m_title;
    ValidityLine* m_verdict;
    ElidedLabel* m_facts;
    QGridLayout* m_best;
    QTabWidget* m_tabs;
    EstimatorPanel* m_estimators;
    RegionPlot* m_region;
    QLabel* m_regionWords;
    CheckList* m_checks;
    UncertaintyPanel* m_uncertainty;
    ModelPanel* m_models;
};

} // namespace gripscope
