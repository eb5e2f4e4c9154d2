// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/type_record.h"

#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QLineEdit;

namespace gripscope {

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

} // namespace gripscope
