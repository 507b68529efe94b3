// SPDX-License-Identifier: GPL-3.0-or-later
/*  source csv;  file "points.csv"; // in the case; first line: x,y,z or x,y,z,u,v,w or
                 x,y,z,u,v,w,p */

#include "addToRunTimeSelectionTable.H"
#include "csvFile.H"
#include "particleSource.H"

#include <algorithm>

namespace Foam
{

class csvSource
:
    public particleSource
{
    DynamicList<point> position_;
    DynamicList<vector> velocity_;
    DynamicList<scalar> pressure_;

public:

    TypeName("csv");

    csvSource(checkedDictionary& dict, const Time& time)
    {
        const csvFile file(dict, time);
        const std::vector<std::string> all{"x", "y", "z", "u", "v", "w", "p"};
        const std::vector<std::string>& head = file.head();
        const bool known = head.size() == 3 || head.size() == 6 || head.size() == 7;
        if (!known || !std::equal(head.begin(), head.end(), all.begin()))
        {
            std::string typed;
            for (const std::string& name : head) typed += (typed.empty() ? "" : ",") + name;
            file.fail(
                -1, "the header is '" + typed + "', not x,y,z or x,y,z,u,v,w or x,y,z,u,v,w,p");
        }

        for (label row = 0; row < file.size(); ++row)
        {
            scalar v[7] = {0, 0, 0, 0, 0, 0, 0};
            for (std::size_t i = 0; i < head.size(); ++i) v[i] = file.number(row, i);
            position_.append(point(v[0], v[1], v[2]));
            if (head.size() > 3) velocity_.append(vector(v[3], v[4], v[5]));
            if (head.size() > 6) pressure_.append(v[6]);
        }
    }

    void place
    (
        const particlePacking& packing,
        const boundBox&,
        pointField& position,
        vectorField& velocity
    ) const override
    {
        position = pointField(position_);
        velocity = vectorField(velocity_);
        for (point& p : position) p = packing.inPlane(p);
    }

    std::int64_t numbers(const particlePacking&, const boundBox&) const override
    {
        return position_.size();
    }

    // Each process has read the whole file
    void placePart
    (
        const particlePacking& packing,
        const boundBox&,
        const boundBox& part,
        std::int64_t first,
        std::int64_t end,
        numberedPoints& points
    ) const override
    {
        for (label i = label(first); i < label(end); ++i)
        {
            const point p(packing.inPlane(position_[i]));
            if (!part.contains(p)) continue;
            points.position.append(p);
            points.number.append(i);
            if (velocity_.size()) points.velocity.append(velocity_[i]);
            if (pressure_.size()) points.pressure.append(pressure_[i]);
        }
    }

    scalarField pressure() const override { return scalarField(pressure_); }

    scalar estimate(const particlePacking&, const boundBox&) const override
    {
        return position_.size();
    }

    bool regular() const override { return false; }
};

defineTypeNameAndDebug(csvSource, 0);
addToRunTimeSelectionTable(particleSource, csvSource, dictionary);

} // namespace Foam
