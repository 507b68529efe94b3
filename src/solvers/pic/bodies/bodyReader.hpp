/*  Where bodies are, how fast, and how they give way: read from the scene of their solids.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "pic/shapes/sampledShape.hpp"
#include "solvers/pic/bodies/bodyTable.hpp"

namespace riprap
{

template<int D>
class BodyReader
{
public:

    static constexpr int modes = bodyModes<D>;
    using Modes = typename BodyTable<D>::Modes;
    using Shape = typename BodyTable<D>::Shape;
    using Body = typename BodyTable<D>::Body;
    using Now = typename BodyTable<D>::Now;

    BodyReader(const BodySetting<D>&, BodyTable<D>&, const std::vector<PicShape>&);

    //- \return has any moved since the last call, or is about to?
    bool read();

private:

    void setInverse(Now&, const double* orientation, const Vec<D, double>& centre) const;
    void directions(const DemGroup&, double along[D][D]) const;
    Modes axisOf(const Now&, const double* orientation, double& about) const;
    void setHinge(Now&, const double* orientation, const Vec<D, double>& centre) const;
    SampledShape<D> placed(
        int shape, const Vec<D, double>& centre, const double* orientation) const;

    const BodySetting<D>& set_;
    BodyTable<D>& table_;
    std::vector<PicShape> shapes_;
    std::vector<SampledShape<D>> unplaced_;     // of shapes_
    std::vector<double> reachOf_;
};

} // namespace riprap
