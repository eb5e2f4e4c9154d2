// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"

#include <QFrame>

class QLabel;

namespace gripscope {

class TypeMap;

/// What was measured of the last part: m, b, k with their intervals, and where they lie among the types.
class InspectMeasurement : public QFrame {
    Q_OBJECT
public:
    explicit InspectMeasurement(QWidget* parent = nullptr);
    void setTypes(const TypeModels& models);
    void showResult(const std::optional<InspectSession::Result>& result);

private:
    void showObject(const InspectSession::Result& result, const CorrectedParameters& object);
    QLabel *m_m, *m_b, *m_k;
    TypeMap* m_map;
    QLabel* m_note; ///< in the map's place, where the measurement says nothing of the part
};

} // namespace gripscope
