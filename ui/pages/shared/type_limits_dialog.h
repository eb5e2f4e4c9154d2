// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/library/records/type_record.h"
#include "ui/windows/dialog.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gripscope {

class Workbench;

/// The limits of m, b and k as a person types them, a lower and an upper one each; empty: open. What nobody
/// typed over comes out as it went in, whatever unit it is shown in.
class LimitFields : public QWidget {
    Q_OBJECT
public:
    explicit LimitFields(QWidget* parent = nullptr);

    /// The type's own, in the units that are read for its channels.
    void showType(const TypeRecord& type);
    /// As they are typed; rule and risk are not among them. Nothing while one of them is no number.
    [[nodiscard]] std::optional<PartLimits> limits() const;

signals:
    void changed();

private:
    struct Field {
        QLineEdit* edit = nullptr;
        std::optional<double> was; ///< what its text stands for until it is edited
        QString text;
    };
    struct Row {
        Field lower, upper;
        QLabel* unit = nullptr;
        double factor = 1; ///< shown number = stored number * factor
    };
    [[nodiscard]] Field makeField(const QString& name, const char* objectName);
    static void fill(Field& field, std::optional<double> value, double factor);
    [[nodiscard]] static bool read(const Field& field, double factor, std::optional<double>& value);

    std::array<Row, 3> m_rows; ///< m, b, k
};

/// What m, b and k of the parts of a type may be, by which rule that is decided, and what such limits risk by
/// the squeezes of that type which are there. Changed as the other properties of types: with a reason, by who
/// may change types.
class TypeLimitsDialog : public Dialog {
    Q_OBJECT
public:
    /// `type`: shown first, by name; empty: the first one.
    explicit TypeLimitsDialog(Workbench& workbench, const QString& type = {}, QWidget* parent = nullptr);

private:
    void build();
    void load(const QString& type);
    void showTypes(std::vector<TypeRecord> types, const QString& first);
    void showType();
    void refresh();
    void tellProblem(const QString& problem);
    void askRisks();
    void showRisks(const PartLimits& limits, const LimitRisks& risks);
    void keep();
    [[nodiscard]] const TypeRecord* type() const;
    /// As typed; nothing, with what is wrong in `problem`.
    [[nodiscard]] std::optional<PartLimits> wanted(QString& problem) const;

    Workbench* m_workbench;
    std::vector<TypeRecord> m_listed; ///< those in use
    std::vector<MeasuredValues> m_measured;
    int m_asked = 0; ///< answers to older questions are dropped
    QTimer m_soon;
    QComboBox *m_type, *m_rule;
    LimitFields* m_fields;
    QDoubleSpinBox* m_risk;
    QLabel *m_risks, *m_problem;
    QLineEdit* m_reason;
    QPushButton* m_keep;
};

} // namespace gripscope
