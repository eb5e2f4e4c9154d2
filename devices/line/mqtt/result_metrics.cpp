// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/result_metrics.h"

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using MetricValue = SparkplugMetric::Value;

struct MetricOfResult {
    const char16_t* name;
    SparkplugType type;
    MetricValue (*value)(const LineReport& report);
};

MetricValue wordOrNull(const QString& text)
{
    return text.isEmpty() ? MetricValue() : MetricValue(text);
}

template <std::size_t which>
MetricValue quantityOf(const LineReport& report)
{
    const auto& quantity = report.result.quantities[which];
    return quantity && std::isfinite(quantity->value) ? MetricValue(quantity->value) : MetricValue();
}

template <std::size_t which>
MetricValue uncertaintyOf(const LineReport& report)
{
    const auto& quantity = report.result.quantities[which];
    return quantity && quantity->standardUncertainty && std::isfinite(*quantity->standardUncertainty)
               ? MetricValue(*quantity->standardUncertainty)
               : MetricValue();
}

template <typename Word>
MetricValue numberOf(Word word)
{
    return MetricValue(static_cast<quint64>(word));
}

const MetricOfResult metricsOfResult[] = {
    {u"Sequence", SparkplugType::UInt64, [](const LineReport& r) { return MetricValue(r.sequence); }},
    {u"Time", SparkplugType::DateTime,
     [](const LineReport& r) { return numberOf(r.result.utc.toMSecsSinceEpoch()); }},
    {u"Part", SparkplugType::String, [](const LineReport& r) { return wordOrNull(r.part); }},
    {u"Expected Type", SparkplugType::String, [](const LineReport& r) { return wordOrNull(r.expectedType); }},
    {u"Type", SparkplugType::String, [](const LineReport& r) { return wordOrNull(r.typeFound); }},
    {u"Result State", SparkplugType::UInt16, [](const LineReport& r) { return numberOf(r.result.state); }},
    {u"Evaluation", SparkplugType::UInt16, [](const LineReport& r) { return numberOf(r.result.evaluation); }},
    {u"Reason", SparkplugType::UInt16, [](const LineReport& r) { return numberOf(r.result.reason); }},
    {u"Is Partial", SparkplugType::Boolean,
     [](const LineReport& r) { return MetricValue(r.result.partial); }},
    {u"Is Simulated", SparkplugType::Boolean,
     [](const LineReport& r) { return MetricValue(r.result.simulated); }},
    {u"Mass", SparkplugType::Double, quantityOf<0>},
    {u"Mass Standard Uncertainty", SparkplugType::Double, uncertaintyOf<0>},
    {u"Damping", SparkplugType::Double, quantityOf<1>},
    {u"Damping Standard Uncertainty", SparkplugType::Double, uncertaintyOf<1>},
    {u"Stiffness", SparkplugType::Double, quantityOf<2>},
    {u"Stiffness Standard Uncertainty", SparkplugType::Double, uncertaintyOf<2>},
    {u"Clock Offset", SparkplugType::Double,
     [](const LineReport& r) { return r.clock ? MetricValue(r.clock->offset_s) : MetricValue(); }},
    {u"Clock Dispersion", SparkplugType::Double,
     [](const LineReport& r) { return r.clock ? MetricValue(r.clock->dispersion_s) : MetricValue(); }},
};
static_assert(std::size(metricsOfResult) <= aliasesOfDevice);

} // namespace

std::vector<SparkplugMetric> resultMetrics(const LineReport* report, std::uint64_t firstAlias, MetricsFor use)
{
    std::vector<SparkplugMetric> metrics;
    std::uint64_t alias = firstAlias;
    for (const MetricOfResult& one : metricsOfResult) {
        SparkplugMetric metric;
        if (use == MetricsFor::Birth)
            metric.name = QString::fromUtf16(one.name);
        metric.typed = use == MetricsFor::Birth;
        metric.alias = alias++;
        metric.type = one.type;
        if (report != nullptr)
            metric.value = one.value(*report);
        metrics.push_back(std::move(metric));
    }
    return metrics;
}

} // namespace gripscope
