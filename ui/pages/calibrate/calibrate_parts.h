// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "ui/windows/dialog.h"

#include <QWidget>

#include <memory>

class QAbstractItemModel;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableView;

namespace gripscope {

struct CalibrationRecord;
class GripperStep;
class QuantityBox;
class Workbench;

/// Of what was done before; a plot has the rest of the place.
inline constexpr int mostRowsBesidePlot = 5;

/// A table of a calibration: whole rows, no grid, the last column takes what is left.
[[nodiscard]] QTableView* makeCalibrationTable(QAbstractItemModel& model, QWidget* parent);

/// Calibrating the channels: how they stand, what was done before, and a new calibration, point by point.
class CalibrateSensors : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateSensors(Workbench& workbench, QWidget* parent = nullptr);
    ~CalibrateSensors() override;

    void setActive(bool active);
    void act();                          ///< what Space does
    void undo();                         ///< what Backspace does
    [[nodiscard]] bool underWay() const; ///< points were taken that are not accepted yet
    void reload();
    [[nodiscard]] bool loaded() const; ///< there are calibrations to be seen

signals:
    void takingChanged(bool taking); ///< points are being taken: nothing else should be in the way

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeOverview();
    QWidget* makeHistory();
    QLayout* makeStatus(QWidget* card);
    void refresh();
    void showStatus();
    void showSelected();
    void saveCertificate();
    void writeCertificateTo(const QString& file, const CalibrationRecord& record);
    [[nodiscard]] const CalibrationRecord* selected() const;

    struct Private;
    std::unique_ptr<Private> d;
};

/// The check on a reference spring before a shift: how the gripper stands, the check itself, and how the
/// checks went over time.
class CalibrateCheck : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateCheck(Workbench& workbench, QWidget* parent = nullptr);
    ~CalibrateCheck() override;

    void setActive(bool active);
    void act(); ///< what Space does
    void leave();
    [[nodiscard]] bool underWay() const;
    /// Asks for the checks of the gripper anew.
    void reload();
    [[nodiscard]] bool loaded() const; ///< there are checks to be seen

private:
    QWidget* makeCheck();
    QWidget* makeHistory();
    void showStanding();
    void showChecks(std::vector<ReferenceCheckRecord> checks);
    void editReference();
    void keepReference(const ReferenceObject& reference);
    void storeReference(const ReferenceObject& stated, const QString& reason);
    [[nodiscard]] QString serial() const;

    struct Private;
    std::unique_ptr<Private> d;
};

/// What is known of a reference object, and how often a gripper is to be checked on it. Says at once what is
/// wrong.
class ReferenceDialog : public Dialog {
    Q_OBJECT
public:
    explicit ReferenceDialog(const ReferenceObject& reference, QWidget* parent = nullptr);
    [[nodiscard]] ReferenceObject reference() const;

private:
    struct Quantity {
        QCheckBox* stated;
        QuantityBox *value, *uncertainty, *tolerance; ///< the latter two as shares of the value
    };
    void build();
    void addQuantity(QGridLayout* grid, int row, std::size_t parameter);
    void show(const ReferenceObject& reference);
    void validate();

    ReferenceObject m_known; ///< what is not edited here
    QLineEdit *m_name, *m_certificate;
    std::array<Quantity, 3> m_quantities{}; ///< m, b, k
    QuantityBox *m_bias, *m_peak;
    QSpinBox* m_squeezes;
    QComboBox* m_interval;
    QLabel* m_words;
    QPushButton* m_keep;
};

/// What a gripper is characterised by, one after the other: the empty gripper, which is taken off the parts,
/// the frame, the lag. Beside it what is known of the connected one, and since when.
class CalibrateGripper : public QWidget {
    Q_OBJECT
public:
    explicit CalibrateGripper(Workbench& workbench, QWidget* parent = nullptr);
    ~CalibrateGripper() override;

    void act(); ///< what Space does
    void leave();
    /// Squeezes are, or a person looks at what they found and has not taken it yet.
    [[nodiscard]] bool underWay() const;

private:
    QWidget* makeMeasuring();
    QWidget* makeKnown();
    void follow(GripperStep* step);
    void reload(); ///< how it came to be known as it is
    void showKnown();
    void remove();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
