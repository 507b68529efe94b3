/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallCorrection.H"
#include "wallBodies.H"
#include "wallPoints.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::functionObjects::wallCorrection::sortWalls
(
    const sphSceneObject& sph
)
{
    const riprap::SphConfig& config = sph.config();
    const wallPoints& walls = sph.walls();
    const labelList bodyOfSource(sph.bodies().bodyOf(walls.names));

    kernel_.reset(new riprap::WallCoverage(config));

    // Faces of points that are just beyond the support are within it
    const scalar reach = kernel_->support() + config.wallSpacing;
    fixed_.reset(new riprap::WallPointSet(reach));
    moving_.assign(sph.bodies().size(), riprap::WallPointSet(reach));

    const auto solved = [&](const vector& v)
    {
        riprap::Vector3 x{{v.x(), v.y(), v.z()}};
        if (config.dimensions == 2) x[config.axes[2]] = 0;
        return x;
    };

    forAll(walls.position, i)
    {
        const label body = bodyOfSource[walls.source[i]];
        (body < 0 ? *fixed_ : moving_[body]).insert
        (
            solved(walls.position[i]),
            solved(walls.normal[i])
        );
    }
}


std::vector<riprap::Vector3> Foam::functionObjects::wallCorrection::images
(
    const riprap::SphConfig& config,
    const point& p,
    const riprap::Vector3& centre
)
{
    std::vector<riprap::Vector3> all{{{p.x(), p.y(), p.z()}}};
    if (config.dimensions == 2)
    {
        all[0][config.axes[2]] = 0;
    }

    for (label a = 0; a < 3; ++a)
    {
        const scalar length = config.domainMax[a] - config.domainMin[a];
        if (!config.periodic[a] || !(length > 0)) continue;

        for (riprap::Vector3& x : all)
        {
            x[a] -= length*std::floor((x[a] - centre[a])/length + 0.5);
        }
        const std::size_t n = all.size();
        for (std::size_t i = 0; i < n; ++i)
        {
            for (const scalar shift : {-length, length})
            {
                all.push_back(all[i]);
                all.back()[a] += shift;
            }
        }
    }

    return all;
}


std::vector<Foam::functionObjects::wallCorrection::movingPose>
Foam::functionObjects::wallCorrection::posesOf(const sphSceneObject& sph) const
{
    std::vector<movingPose> poses(moving_.size());
    for (std::size_t body = 0; body < poses.size(); ++body)
    {
        poses[body].pose = sph.bodies().pose(body, sph.scene().time());
        poses[body].centre = riprap::placed(poses[body].pose, moving_[body].centre());
    }
    return poses;
}


std::vector<riprap::WallNeighbour>
Foam::functionObjects::wallCorrection::nearMoving
(
    const riprap::SphConfig& config,
    const point& p,
    const std::vector<movingPose>& poses
) const
{
    std::vector<riprap::WallNeighbour> walls;
    for (std::size_t body = 0; body < moving_.size(); ++body)
    {
        for (const riprap::Vector3& x : images(config, p, poses[body].centre))
        {
            moving_[body].near(x, poses[body].pose, walls);
        }
    }
    return walls;
}


void Foam::functionObjects::wallCorrection::cover
(
    const riprap::SphConfig& config,
    place& p,
    const std::vector<riprap::WallNeighbour>& walls
)
{
    p.planes.clear();
    if (sight_)
    {
        if (riprap::dotOf(p.normal, p.normal) > 0)
        {
            p.planes.push_back({p.normal, 1e-3*config.wallSpacing});
        }
        riprap::addWallPlanes(walls, config.wallSpacing, p.planes);
    }
    p.coverage = kernel_->of(walls, p.planes);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::functionObjects::wallCorrection::reset(bool sight)
{
    sight_ = sight;
    places_.clear();
    kernel_.clear();
}


void Foam::functionObjects::wallCorrection::update
(
    const sphSceneObject& sph,
    const pointField& points,
    const vectorField& normals
)
{
    const riprap::SphConfig& config = sph.config();
    if (!kernel_.valid())
    {
        sortWalls(sph);
    }

    const std::vector<movingPose> poses(posesOf(sph));
    const bool fresh = places_.size() != std::size_t(points.size());
    places_.resize(points.size());

    forAll(points, i)
    {
        place& p = places_[i];
        const vector normal(normals.empty() ? vector(Zero) : normals[i]);
        const riprap::Vector3 at{{points[i].x(), points[i].y(), points[i].z()}};
        const riprap::Vector3 n{{normal.x(), normal.y(), normal.z()}};

        const bool moved = fresh || at != p.at || n != p.normal;
        if (!moved && moving_.empty()) continue;

        if (moved)
        {
            p.at = at;
            p.normal = n;
            p.fixed.clear();
            for (const riprap::Vector3& x : images(config, points[i], fixed_->centre()))
            {
                if (fixed_->mayReach(x)) fixed_->near(x, p.fixed);
            }
        }

        std::vector<riprap::WallNeighbour> walls(nearMoving(config, points[i], poses));
        if (moved || p.byMoving || !walls.empty())
        {
            p.byMoving = !walls.empty();
            walls.insert(walls.end(), p.fixed.begin(), p.fixed.end());
            cover(config, p, walls);
        }
    }
}


riprap::SightPlanes Foam::functionObjects::wallCorrection::planes() const
{
    riprap::SightPlanes all;
    all.first.push_back(0);
    for (const place& p : places_)
    {
        for (const riprap::SightPlane& plane : p.planes)
        {
            all.normal.insert
            (
                all.normal.end(),
                plane.normal.begin(),
                plane.normal.end()
            );
            all.depth.push_back(plane.depth);
        }
        all.first.push_back(all.depth.size());
    }
    return all;
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


// ************************************************************************* //
