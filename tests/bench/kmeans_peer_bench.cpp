// SPDX-License-Identifier: GPL-3.0-or-later
// K-means on a million items. With GRIPSCOPE_PEER_FOLDER set, tables, starts and results are written there
// for kmeans_peer.py, which times scikit-learn on the same.
#include "core/clustering/kmeans.h"
#include "core/math/gaussian.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <benchmark/benchmark.h>
#include <chrono>

namespace gripscope {

namespace {

using namespace Qt::StringLiterals;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Eigen::Index items = 1'000'000;
constexpr int iterations = 100;

/// `groups` round clouds that overlap a little, in the unit cube.
Rows table(int groups)
{
    GaussianNoise noise(1);
    Rows centres(groups, 3);
    for (double& x : centres.reshaped())
        x = noise.uniform();
    Rows all(items, 3);
    for (Eigen::Index i = 0; i < items; ++i)
        for (Eigen::Index j = 0; j < 3; ++j)
            all(i, j) = centres(i % groups, j) + 0.1 * noise();
    return all;
}

void write(const QString& file, const void* data, std::size_t bytes)
{
    QFile out(file);
    if (!out.open(QIODevice::WriteOnly) || out.write(static_cast<const char*>(data), qint64(bytes)) < 0)
        qFatal("cannot write for the peer");
}

void writeForPeer(const Rows& all, const Rows& start, const KMeansResult& result, double seconds)
{
    const QString folder = qEnvironmentVariable("GRIPSCOPE_PEER_FOLDER");
    if (folder.isEmpty())
        return;
    const QString base = QDir(folder).filePath(u"kmeans_%1"_s.arg(start.rows()));
    write(base + u".items"_s, all.data(), std::size_t(all.size()) * sizeof(double));
    write(base + u".start"_s, start.data(), std::size_t(start.size()) * sizeof(double));
    write(base + u".labels"_s, result.labels.data(), result.labels.size() * sizeof(int));
    const QByteArray json = QJsonDocument(QJsonObject{{u"features"_s, 3},
                                                      {u"iterations"_s, result.iterations},
                                                      {u"inertia"_s, result.inertia},
                                                      {u"seconds"_s, seconds}})
                                .toJson();
    write(base + u".json"_s, json.constData(), std::size_t(json.size()));
}

/// The first items as the start: more to do than from k-means++, which scikit-learn gets as well.
void clusterMillion(benchmark::State& state)
{
    const Rows all = table(int(state.range(0)));
    const Rows start = all.topRows(state.range(0));
    const Eigen::MatrixXd columns = all;
    KMeansOptions options;
    options.maxIterations = iterations;
    options.recordSteps = false;
    KMeansResult result;
    double seconds = 1e9;
    for (auto _ : state) {
        const auto begin = std::chrono::steady_clock::now();
        result = kMeansFrom(columns, start, options).value();
        seconds = std::min(seconds,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    writeForPeer(all, start, result, seconds);
}
BENCHMARK(clusterMillion)->Arg(4)->Arg(64)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

} // namespace gripscope
