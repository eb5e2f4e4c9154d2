// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/inspect/inspect_session.h"
#include "ui/windows/dialog.h"

#include <QFrame>
#include <QPushButton>
#include <QString>

#include <functional>

class QBoxLayout;
class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QRadioButton;

namespace gripscope {

class ElidedLabel;
class FittedLabel;
class InspectBatch;
class InspectionList;
class Settings;
class TourScript;
class TypeMap;
class Workbench;
class YieldStrip;

/// What the Inspect page says where there is no verdict: a headline, and what to do.
struct InspectHint {
    QString headline, words;
};
/// `time`: how long a squeeze takes, in words.
[[nodiscard]] InspectHint inspectHint(Workbench& workbench, const QString& time);
/// The same where a verdict was reached that is no longer about the part in the jaws: it is told as the last
/// one.
[[nodiscard]] InspectHint pastHint(Workbench& workbench, const QString& time,
                                   const InspectSession::Result& last);

/// A code or name that no type has; `expected` stays what it was.
[[nodiscard]] InspectHint unknownCodeHint(const QString& code, const QString& expected);
[[nodiscard]] InspectHint expectedHint(const QString& expected);
/// The gripper's own button was pressed, and nothing may be squeezed.
[[nodiscard]] InspectHint buttonHint();

/// What was measured of the last part: m, b, k with their intervals, and where they lie among the types.
class InspectMeasurement : public QFrame {
    Q_OBJECT
public:
    explicit InspectMeasurement(QWidget* parent = nullptr);
    /// As TypeMap::setTypes.
    void setTypes(const TypeModels& models, bool elsewhere);
    void showResult(const std::optional<InspectSession::Result>& result);

private:
    void showObject(const InspectSession::Result& result, const CorrectedParameters& object);
    QLabel *m_m, *m_b, *m_k;
    QLabel* m_further; ///< friction, yielding: where the squeeze tells it
    TypeMap* m_map;
    QLabel* m_note; ///< in the map's place, where the measurement says nothing of the part
};

/// Under the verdict: what it rests on in numbers, the reason in one sentence, and the rates it is held to.
class InspectReason : public QWidget {
    Q_OBJECT
public:
    explicit InspectReason(QWidget* parent = nullptr);
    void showResult(const InspectSession::Result* result); ///< null: there is none
    void showRates(const VerdictOptions& rates);

private:
    ElidedLabel* m_facts;
    QLabel *m_rates, *m_reason;
};

/// The side of the Inspect page: the batch; how many parts of the shift, in all and by type, were as
/// expected; the last of them one by one, and their strip.
class InspectSummary : public QWidget {
    Q_OBJECT
public:
    explicit InspectSummary(Workbench& workbench, QWidget* parent = nullptr);

    /// Whose record of right and wrong is shown; empty: that of all types together.
    void setExpected(const QString& type);
    [[nodiscard]] InspectBatch& batch() const { return *m_batch; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildHead(QBoxLayout* column, QWidget* card);
    void refreshCounts();
    void refreshTypes(const InspectionCounts& shift);
    void refreshEvidence(const InspectionCounts& counts);
    void takeShift();  ///< where it began, from the settings
    void beginShift(); ///< behind the last inspection
    void askForShift();
    void reload();
    void open(const QString& graspId, qint64 number);
    Workbench* m_workbench;
    QString m_expected;
    qint64 m_shift = 0; ///< the inspection behind which it began
    FittedLabel* m_good;
    ElidedLabel* m_types;
    QLabel *m_period, *m_share, *m_split, *m_shown, *m_empty;
    QPushButton* m_newShift;
    InspectBatch* m_batch;
    InspectionList* m_list;
    YieldStrip* m_strip;
};

/// Switches the sound of verdicts on and off, for good.
class SoundButton : public QPushButton {
    Q_OBJECT
public:
    explicit SoundButton(Settings& settings, QWidget* parent = nullptr);

private:
    void refresh();
    Settings* m_settings;
};

/// The rates verdicts are held to, each with what it counts, and whether a squeeze may end early.
class RatesDialog : public Dialog {
    Q_OBJECT
public:
    RatesDialog(const VerdictOptions& rates, bool earlyEnd, QWidget* parent = nullptr);
    [[nodiscard]] VerdictOptions rates() const; ///< as they stand in the fields
    [[nodiscard]] bool earlyEnd() const;

private:
    QDoubleSpinBox* addRate(QFormLayout* form, const QString& name, const QString& meaning);
    void build();
    void fill(const VerdictOptions& rates, bool earlyEnd);
    VerdictOptions m_rates; ///< what has no field stays as it was
    QDoubleSpinBox *m_falseReject = nullptr, *m_wrongType = nullptr, *m_strangerAccept = nullptr;
    QRadioButton *m_average = nullptr, *m_confident = nullptr;
    QCheckBox *m_robust = nullptr, *m_early = nullptr;
};

/// Asks why an inspection does not count: the two reasons that there are every day by a press each, any other
/// in words.
class VoidDialog : public Dialog {
    Q_OBJECT
public:
    VoidDialog(qint64 number, QWidget* parent);

signals:
    void answered(const QString& reason); ///< accepted with this

private:
    void give(const QString& reason);
    QLineEdit* m_reason;
    QPushButton* m_accept;
};

/// Brings the Inspect page to a telling state: parts as expected, another type, a stranger. `expect` and
/// `squeeze` are what a person does on the page.
void addInspections(TourScript& tour, Workbench& workbench, const std::function<void()>& expect,
                    const std::function<void()>& squeeze);

} // namespace gripscope
