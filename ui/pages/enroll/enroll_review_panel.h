// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/type_record.h"
#include "core/recognition/types/models_by_space.h"
#include "core/session/enroll/enrollment_advice.h"
#include "ui/windows/dialog.h"

#include <QString>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QTableWidget;

namespace gripscope {

class EnrollSession;
class Library;
class PartPictureView;
class TypeMap;
class Workbench;

/// What the enrolled squeezes are called by models that do not know them: a row for each type, and under it
/// what that proves.
class EnrollCheck : public QWidget {
    Q_OBJECT
public:
    explicit EnrollCheck(QWidget* parent = nullptr);
    /// The row of `type` stands out.
    void show(const HeldOutConfusion& confusion, const QString& type, const VerdictOptions& rates);
    void clear();

private:
    void fillRow(const HeldOutConfusion& confusion, int row, bool strong);
    QTableWidget* m_table;
    QLabel* m_words;
};

/// What the review says besides the table: outliers, overlap, parts against grips; a sentence each.
[[nodiscard]] QStringList reviewSentences(const EnrollmentReview& review);

/// What the accepted squeezes of a type have in common, in SI where the type's units are known.
struct ReviewedQuantity {
    TypeQuantity quantity = TypeQuantity::Stiffness;
    double mean = 0;
    std::optional<double> deviation; ///< standard, of a squeeze
    int squeezes = 0;                ///< that it is of
};

/// What a type looks like after its squeezes: made on the library's thread, shown before it is approved.
struct TypeReview {
    int squeezes = 0;
    std::vector<ReviewedQuantity> quantities; ///< that most of its squeezes determine
    QString forceUnit, positionUnit;          ///< of the type
    TypeModels models;                        ///< of all types it can be compared with, in m, b and k
    std::vector<TypeSqueeze> squeezesOfAll;   ///< of these types, in the units of the models
    QString nearest;                          ///< other type
    std::optional<double> nearestSd;          ///< how far, in standard deviations
    std::optional<double> gateSd;             ///< where a squeeze is called unknown at the false-reject rate
    double falseReject = 0;
};
[[nodiscard]] TypeReview reviewType(const std::vector<TypeSqueeze>& squeezes, const ModelsBySpace& types,
                                    const QString& name, const VerdictOptions& rates);

/// What was enrolled and how, a line each: squeezes and parts, recipe, crush limit.
[[nodiscard]] QStringList summaryLines(const EnrollSession& session);

/// A line of the review.
struct QuantityRow {
    QLabel *name = nullptr, *mean = nullptr, *spread = nullptr;
};

/// The review step: mean and spread, how far the nearest other type is, what overlaps, what held-out squeezes
/// are called, and approval.
class EnrollReviewPanel : public QWidget {
    Q_OBJECT
public:
    explicit EnrollReviewPanel(Workbench& workbench, QWidget* parent = nullptr);
    void load();

signals:
    void changed();

private:
    void show(const TypeReview& review);
    QWidget* makeFacts(QWidget* parent);
    void fitFacts();
    void loadCheck();
    Workbench* m_workbench;
    PartPictureView* m_picture;
    QLabel *m_title, *m_summary, *m_distance, *m_gate, *m_sentences;
    std::array<QuantityRow, mostDimensions> m_rows; ///< in order of allQuantities
    QScrollArea* m_facts = nullptr;
    TypeMap* m_map;
    EnrollCheck* m_check;
    QPushButton* m_approve;
};

/// What a part of a type, approved or not, would be called: a squeeze that is neither stored nor counted, and
/// says so.
class TrialDialog : public Dialog {
    Q_OBJECT
public:
    TrialDialog(Workbench& workbench, const QString& type, const Recipe& recipe, QWidget* parent = nullptr);
    ~TrialDialog() override;
    void done(int result) override;

private:
    void build();
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
