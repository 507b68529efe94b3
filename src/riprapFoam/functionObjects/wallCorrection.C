/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallCorrection.H"

void Foam::functionObjects::wallCorrection::clear()
{
    walls_.clear();
    coverage_.clear();
}


void Foam::functionObjects::wallCorrection::update
(
    const sphSceneObject& sph,
    const pointField& points
)
{
    std::vector<double> walls(sph.scene().walls().position);

    if (walls == walls_ && label(coverage_.size()) == points.size())
    {
        return;
    }
    walls_ = std::move(walls);

    const riprap::WallCoverage all(sph.config(), walls_);

    coverage_.resize(points.size());
    forAll(points, i)
    {
        const point& p = points[i];
        coverage_[i] = all.at({{p.x(), p.y(), p.z()}});
    }
}


Foam::scalar Foam::functionObjects::wallCorrection::pressure
(
    const riprap::SphConfig& config,
    const label i
) const
{
    const vector g(config.gravity[0], config.gravity[1], config.gravity[2]);

    return -config.density*(g & offset(i));
}
