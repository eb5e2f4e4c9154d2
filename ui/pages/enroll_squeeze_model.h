// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enroll_session.h"
#include "ui/widgets/number_format.h"

#include <QAbstractTableModel>

#include <map>

namespace gripscope {

/// The squeezes of an enrolment as rows, ready to read.
class EnrollSqueezeModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Part, Stiffness, Damping, Mass, Fit, Verdict, Count };
    using QAbstractTableModel::QAbstractTableModel;

    /// Takes over what the session holds; cheap when nothing changed.
    /// `outliers`: by row, why the squeeze does not go with the others.
    void refresh(const std::vector<EnrollSqueeze>& squeezes, const std::map<int, QString>& outliers = {});
    [[nodiscard]] bool isAccepted(int row) const;
    [[nodiscard]] bool hasParts() const; ///< some squeeze says which part it was of

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
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
