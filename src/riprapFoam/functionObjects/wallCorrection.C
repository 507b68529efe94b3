/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallCorrection.H"
#include "sphDictionaries.H"

void Foam::functionObjects::wallCorrection::reset(const polyMesh& mesh)
{
    coverage_.clear();
    moving_ = !readSphSettings(mesh).walls.motion.empty();
}


void Foam::functionObjects::wallCorrection::update
(
    const sphSceneObject& sph,
    const pointField& points
)
{
    if (!moving_ && !coverage_.empty())
    {
        return;
    }

    const riprap::WallCoverage all
    (
        sph.config(),
        sph.scene().walls().position
    );

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
