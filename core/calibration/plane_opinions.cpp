// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/calibration/plane_system.h"
#include "core/types/square.h"

namespace planewright {

namespace {

/// Directions with a smaller share of the largest information tell nothing but rounding.
constexpr double kLeastShare = 1e-9;

}  // namespace

/// A plane's own equations in errors and plane: no other plane has a say in its pitches.
PlaneSystem::Equations PlaneSystem::equationsOf(std::size_t number) const
{
    Equations sum;
    const bool common = seen_.noise.pitchCommon && pitchNoise_ > 0.0;
    for (std::size_t i = 0; i < seen_.slices.size(); ++i) {
        Equations own;
        bool seenHere = false;
        for (std::size_t j = seen_.slices[i].first; j < seen_.slices[i].end; ++j) {
            if (seen_.segments[j].plane != number)
                continue;
            own.information += locals_[j].information;
            own.gradient += locals_[j].gradient;
            sum.weight += locals_[j].weight;
            seenHere = true;
        }
        if (!seenHere)
            continue;
        if (common) {
            const double pitch = own.information(kPitch, kPitch) + 1.0 / square(pitchNoise_);
            const double gradient = own.gradient[kPitch] + slices_[i].pitchError / square(pitchNoise_);
            const Eigen::Matrix<double, kLocal, 1> coupling = own.information.col(kPitch);
            own.information -= coupling * coupling.transpose() / pitch;
            own.gradient -= coupling * (gradient / pitch);
        }
        sum.information += own.information;
        sum.gradient += own.gradient;
    }
    const double known = 1.0 / square(planes_[number].bendSigma);
    sum.information.diagonal().tail<3>().array() += known;
    sum.gradient.tail<3>() += known * planes_[number].bend;
    return sum;
}

std::vector<PlaneSystem::Opinion> PlaneSystem::opinions(const std::vector<int>& errors) const
{
    const auto count = static_cast<Eigen::Index>(errors.size());
    std::vector<Opinion> all;
    for (std::size_t number = 0; number < planes_.size(); ++number) {
        const Equations e = equationsOf(number);
        const Eigen::LDLT<Eigen::Matrix<double, kOfPlane, kOfPlane>> own(
            e.information.bottomRightCorner<kOfPlane, kOfPlane>());
        const Eigen::Matrix<double, kOfPlane, kScannerErrors> coupling =
            e.information.bottomLeftCorner<kOfPlane, kScannerErrors>();
        const ErrorMatrix information =
            e.information.topLeftCorner<kScannerErrors, kScannerErrors>() - coupling.transpose() * own.solve(coupling);
        const ErrorVector gradient =
            e.gradient.head<kScannerErrors>() - coupling.transpose() * own.solve(e.gradient.tail<kOfPlane>());
        Eigen::MatrixXd asked(count, count);
        Eigen::VectorXd side(count);
        for (Eigen::Index a = 0; a < count; ++a) {
            side[a] = gradient[errors[static_cast<std::size_t>(a)]];
            for (Eigen::Index b = 0; b < count; ++b)
                asked(a, b) = information(errors[static_cast<std::size_t>(a)], errors[static_cast<std::size_t>(b)]);
        }
        Opinion opinion{0.0, 0, e.weight, planes_[number].trust};
        const double least = kLeastShare * e.information.diagonal().head<kScannerErrors>().maxCoeff();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(asked);
        for (Eigen::Index a = 0; a < count; ++a) {
            if (!(axes.eigenvalues()[a] > least))
                continue;
            opinion.chi += square(axes.eigenvectors().col(a).dot(side)) / axes.eigenvalues()[a];
            ++opinion.freedom;
        }
        all.push_back(opinion);
    }
    return all;
}

void PlaneSystem::setTrust(std::size_t plane, double trust)
{
    planes_[plane].trust = trust;
}

}  // namespace planewright
