// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include "core/calibration/observe_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace planewright {

namespace {

/// Two errors explain the same where they are correlated by more than this.
constexpr double kTangled = 0.9;

using Places = std::vector<int>;

Eigen::MatrixXd part(const ErrorMatrix& matrix, const Places& rows, const Places& columns)
{
    Eigen::MatrixXd some(rows.size(), columns.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t j = 0; j < columns.size(); ++j)
            some(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matrix(rows[i], columns[j]);
    }
    return some;
}

ErrorVector usefulSigmas()
{
    return Eigen::Map<const ErrorVector>(kUsefulSigma.data());
}

/// The inverse of an information, in which a direction without any has a very large variance.
Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& information)
{
    constexpr double kLeast = 1e-9;  // in units of what is useful
    if (information.size() == 0)
        return information;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(information);
    const Eigen::VectorXd variances = axes.eigenvalues().cwiseMax(kLeast).cwiseInverse();
    return axes.eigenvectors() * variances.asDiagonal() * axes.eigenvectors().transpose();
}

/// The solution for some errors while the others stay, in units of the useful limits.
struct Partial {
    Places asked, left;
    Eigen::MatrixXd own;         // covariance where the others were known
    Eigen::MatrixXd byLeft;      // of the asked by the left
    Eigen::MatrixXd covariance;  // of the asked, with what the left may be
};

Partial solve(const ErrorMatrix& information, Places asked)
{
    Partial partial;
    partial.asked = std::move(asked);
    for (int i = 0; i < kScannerErrors; ++i) {
        if (std::find(partial.asked.begin(), partial.asked.end(), i) == partial.asked.end())
            partial.left.push_back(i);
    }
    partial.own = inverseOf(part(information, partial.asked, partial.asked));
    partial.byLeft = -partial.own * part(information, partial.asked, partial.left);
    Eigen::VectorXd unknown(partial.left.size());
    for (std::size_t i = 0; i < partial.left.size(); ++i) {
        const auto place = static_cast<std::size_t>(partial.left[i]);
        const double sigma = kUnknownSigma[place] / kUsefulSigma[place];
        unknown[static_cast<Eigen::Index>(i)] = sigma * sigma;
    }
    partial.covariance = partial.own + partial.byLeft * unknown.asDiagonal() * partial.byLeft.transpose();
    return partial;
}

}  // namespace

ObservedErrors observeErrors(const ErrorEvidence& evidence, const std::array<bool, kScannerErrors>& asked)
{
    const ErrorVector units = usefulSigmas();
    const ErrorMatrix information = units.asDiagonal() * evidence.information * units.asDiagonal();
    const ErrorVector gradient = units.asDiagonal() * evidence.gradient;
    ObservedErrors observed;
    Places places;
    for (int i = 0; i < kScannerErrors; ++i) {
        ObservedErrors::One& one = observed.errors[static_cast<std::size_t>(i)];
        one.sigma = information(i, i) > 1e-9 ? units[i] / std::sqrt(information(i, i))
                                             : std::numeric_limits<double>::infinity();
        if (asked[static_cast<std::size_t>(i)] && information(i, i) > 1.0)
            places.push_back(i);
    }

    Partial partial = solve(information, places);
    while (!places.empty()) {
        Eigen::Index worst = 0;
        if (partial.covariance.diagonal().maxCoeff(&worst) <= 1.0)
            break;
        ObservedErrors::One& one = observed.errors[static_cast<std::size_t>(places[static_cast<std::size_t>(worst)])];
        one.sigma = std::sqrt(partial.covariance(worst, worst)) * units[places[static_cast<std::size_t>(worst)]];
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto other = static_cast<Eigen::Index>(i);
            const double both = std::sqrt(partial.own(worst, worst) * partial.own(other, other));
            if (other != worst && std::abs(partial.own(worst, other)) > kTangled * both)
                one.tangled.push_back(static_cast<ScannerError>(places[i]));
        }
        for (std::size_t i = 0; i < partial.left.size(); ++i) {
            const auto place = static_cast<std::size_t>(partial.left[i]);
            const double sigma = kUnknownSigma[place] / kUsefulSigma[place];
            if (std::abs(partial.byLeft(worst, static_cast<Eigen::Index>(i))) * sigma > 1.0)
                one.tangled.push_back(static_cast<ScannerError>(partial.left[i]));
        }
        places.erase(places.begin() + worst);
        partial = solve(information, places);
    }

    Eigen::VectorXd side(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        side[static_cast<Eigen::Index>(i)] = gradient[places[i]];
    const Eigen::VectorXd move = -partial.own * side;
    for (const int left : partial.left) {
        const double sigma = kUnknownSigma[static_cast<std::size_t>(left)];
        observed.covariance(left, left) = sigma * sigma;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const int place = places[i];
        observed.errors[static_cast<std::size_t>(place)] = {
            true, units[place] * move[row], units[place] * std::sqrt(partial.covariance(row, row)), {}};
        for (std::size_t j = 0; j < places.size(); ++j)
            observed.covariance(place, places[j]) =
                units[place] * partial.covariance(row, static_cast<Eigen::Index>(j)) * units[places[j]];
        for (std::size_t j = 0; j < partial.left.size(); ++j) {
            const int left = partial.left[j];
            const double sigma = kUnknownSigma[static_cast<std::size_t>(left)];
            const double both =
                units[place] * partial.byLeft(row, static_cast<Eigen::Index>(j)) * sigma * sigma / units[left];
            observed.covariance(place, left) = both;
            observed.covariance(left, place) = both;
        }
    }
    return observed;
}

}  // namespace planewright
