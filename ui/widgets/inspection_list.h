// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"

#include <QAbstractListModel>
#include <QListView>

#include <vector>

namespace gripscope {

/// What one line of the list says.
struct InspectionLine {
    qint64 number = 0;
    QString graspId;
    InspectionOutcome outcome = InspectionOutcome::NotValid;
    QString type; ///< the type named, else empty
    double seconds = 0;
};
[[nodiscard]] InspectionLine inspectionLine(const InspectionRecord& record);
[[nodiscard]] QString inWords(const InspectionLine& line); ///< "Inspection 12: A as expected"

class InspectionListModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { NumberRole = Qt::UserRole, OutcomeRole, TypeRole, SecondsRole, GraspRole };
    using QAbstractListModel::QAbstractListModel;
    void setLines(std::vector<InspectionLine> lines); ///< newest first
    [[nodiscard]] const std::vector<InspectionLine>& lines() const { return m_lines; }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<InspectionLine> m_lines;
};

/// The last inspections, numbered, each with the sign, word and colour of its outcome.
class InspectionList : public QListView {
    Q_OBJECT
public:
    explicit InspectionList(QWidget* parent = nullptr);
    void setLines(std::vector<InspectionLine> lines) { m_model.setLines(std::move(lines)); }
    [[nodiscard]] const InspectionListModel& lineModel() const { return m_model; }

signals:
    void opened(const QString& graspId, qint64 number); ///< by a click or Enter

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void open(const QModelIndex& index);
    InspectionListModel m_model;
};

} // namespace gripscope
