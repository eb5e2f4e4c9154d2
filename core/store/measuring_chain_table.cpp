// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/measuring_chain_table.h"

#include "core/words.h"

namespace gripscope::measuring_chain_table {

using namespace Qt::StringLiterals;

namespace {

MeasuringChainRecord take(Statement& row, const QString& gripperSerial)
{
    MeasuringChainRecord record;
    record.gripperSerial = gripperSerial;
    record.measured = row.takeUtc();
    record.operatorName = row.takeText();
    record.basis = row.takeText();
    record.forceLag_s = row.takeReal();
    MeasuringChain& chain = record.chain;
    for (double* value :
         {&chain.forceLagUncertainty_s, &chain.forceNoiseDeviation, &chain.forceScaleUncertainty,
          &chain.positionScaleUncertainty, &chain.frameCompliance, &chain.frameComplianceUncertainty})
        *value = row.takeReal();
    GripperBaseline baseline;
    bool complete = true;
    for (auto* values : {&baseline.parameters, &baseline.standardErrors})
        for (double& value : *values) {
            const std::optional<double> stored = row.takeOptionalReal();
            complete = complete && stored;
            value = stored.value_or(0);
        }
    if (complete)
        chain.baseline = baseline;
    return record;
}

} // namespace

Expected<void> insert(Database& database, const RowStamp& stamp, const NewMeasuringChain& measured)
{
    Statement row(
        database, Words::tr("store what was measured of the gripper"),
        u"INSERT INTO measuring_chains (id, station, created_utc, gripper_serial, operator_name, basis, "
        u"force_lag_s, "
        "force_lag_uncertainty_s, force_noise_deviation, force_scale_uncertainty, "
        "position_scale_uncertainty, frame_compliance, "
        "frame_compliance_uncertainty, baseline_m, baseline_b, baseline_k, baseline_error_m, "
        "baseline_error_b, "
        "baseline_error_k) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"_s);
    const MeasuringChain& chain = measured.chain;
    row.bind(stamp.id).bind(stamp.station).bind(stamp.utc);
    row.bind(measured.gripperSerial).bind(measured.operatorName).bind(measured.basis);
    row.bind(measured.forceLag_s)
        .bind(chain.forceLagUncertainty_s)
        .bind(chain.forceNoiseDeviation)
        .bind(chain.forceScaleUncertainty);
    row.bind(chain.positionScaleUncertainty)
        .bind(chain.frameCompliance)
        .bind(chain.frameComplianceUncertainty);
    for (const auto member : {&GripperBaseline::parameters, &GripperBaseline::standardErrors})
        for (std::size_t i = 0; i < 3; ++i)
            row.bind(chain.baseline ? std::optional((*chain.baseline.*member)[i]) : std::nullopt);
    return row.run();
}

Expected<std::optional<MeasuringChainRecord>> newest(Database& database, const QString& gripperSerial)
{
    std::optional<MeasuringChainRecord> found;
    Statement query(
        database, Words::tr("read what is known of the gripper"),
        u"SELECT created_utc, operator_name, basis, force_lag_s, force_lag_uncertainty_s, "
        u"force_noise_deviation, force_scale_uncertainty, "
        "position_scale_uncertainty, frame_compliance, frame_compliance_uncertainty, baseline_m, baseline_b, "
        "baseline_k, baseline_error_m, baseline_error_b, baseline_error_k FROM measuring_chains "
        "WHERE gripper_serial = ? ORDER BY created_utc DESC, id DESC LIMIT 1"_s);
    auto done = query.bind(gripperSerial).forEach([&](Statement& row) { found = take(row, gripperSerial); });
    if (!done)
        return tl::unexpected(done.error());
    return found;
}

} // namespace gripscope::measuring_chain_table
