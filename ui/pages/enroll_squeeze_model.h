// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enroll_session.h"
#include "ui/models/row_table_model.h"
#include "ui/widgets/number_format.h"

#include <map>

namespace gripscope {

/// The squeezes of an enrolment as rows, ready to read.
class EnrollSqueezeModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Part, Stiffness, Damping, Mass, Fit, Verdict, Count };
    using RowTableModel::RowTableModel;

    /// Takes over what the session holds; cheap when nothing changed.
    /// `outliers`: by row, why the squeeze does not go with the others.
    void refresh(const std::vector<EnrollSqueeze>& squeezes, const std::map<int, QString>& outliers = {});
    [[nodiscard]] bool isAccepted(int row) const;
    [[nodiscard]] bool hasParts() const; ///< some squeeze says which part it was of

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int width() const override { return static_cast<int>(Column::Count); }
    [[nodiscard]] QVariant head(int column, int role) const override;

    struct Row {
        EnrollSqueeze::Decision decision = EnrollSqueeze::Decision::Pending;
        QString part, reason, fit, verdict, outlier;
        FormattedNumber stiffness, damping, mass;
        friend bool operator==(const Row&, const Row&) = default;
    };
    /// The unit that all numbers of a column share: it then stands in the header once. Empty: each has its
    /// own.
    [[nodiscard]] QString commonUnit(FormattedNumber Row::*column) const;
    [[nodiscard]] static Row makeRow(const EnrollSqueeze& squeeze);
    [[nodiscard]] QString text(const Row& row, int number, Column column) const;
    std::vector<Row> m_rows;
};

/// "valid", "suspect", "not valid"; a squeeze taken over from the library was judged when it was enrolled.
[[nodiscard]] QString validityWord(const EnrollSqueeze& squeeze);

} // namespace gripscope
