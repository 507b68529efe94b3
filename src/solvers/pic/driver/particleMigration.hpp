/*  Particles of a scene on several ranks, after a step has moved them: to the rank of their cell,
    and as ghosts to all whose parts have that cell.

    Each rank sends what it owned before the step: one round of messages. With a particle goes where
    it stood in the order of one process: the number of its former cell in the block, and its place
    in that. By these numbers what comes is merged into what stays, so that the sort by cells, which
    is stable, leaves the particles of a cell in the order of one process. Those that have come in
    through openings come after all others.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "solvers/pic/parts/picParts.hpp"

namespace riprap
{

template<class Backend, int D, class P>
class ParticleMigration
{
public:

    using real = typename P::real;

    explicit ParticleMigration(PicParts<Backend, D, P>& parts);

    //- Afterwards all that are here are in cells of this part, and wait for the sort
    void migrate(PicReport& report);

private:

    //- Where a particle stood; in which list it is now, and where in that
    struct Place
    {
        std::int64_t cell;
        int within, list, at;

        bool operator<(const Place& b) const
        {
            return cell < b.cell || (cell == b.cell && within < b.within);
        }
    };
    struct Left { std::int64_t cell; int within; std::int32_t id; double x[D]; };

    void readFields();
    void moveOne(int i, const Place& was);
    void put(RankBytes& to, int i, const Place& was) const;
    void takeFrom(const RankBytes& from, int list);
    void rebuild();
    void tellLeft(PicReport& report);

    PicParts<Backend, D, P>& p_;
    PicParticleFields<Backend, D, P>& particles_;
    const GridBricks<D>& bricks_;
    std::vector<RankBytes> field_;          // what is here
    std::size_t bytes_ = 0;                 // of a particle's fields
    std::vector<Place> stay_, came_;
    std::vector<RankBytes> out_, in_;
    std::vector<Left> left_;
    std::int64_t owned_ = 0;                // in cells of this brick from now on
};

template<class Backend, int D, class P>
ParticleMigration<Backend, D, P>::ParticleMigration(PicParts<Backend, D, P>& parts)
:
    p_(parts), particles_(parts.particles), bricks_(*parts.set.bricks), out_(bricks_.size())
{}

template<class Backend, int D, class P>
void ParticleMigration<Backend, D, P>::readFields()
{
    FieldSet<Backend>& values = particles_.values;
    field_.resize(values.fields());
    for (int k = 0; k < values.fields(); ++k)
    {
        bytes_ += values.elementBytes(k);
        field_[k].resize(std::size_t(particles_.n)*values.elementBytes(k));
        if (particles_.n)
            p_.set.context.toHost(field_[k].data(), values.bytes(k), field_[k].size());
    }
}

template<class Backend, int D, class P>
void ParticleMigration<Backend, D, P>::put(RankBytes& to, int i, const Place& was) const
{
    putValues(to, &was.cell);
    putValues(to, &was.within);
    for (int k = 0; k < int(field_.size()); ++k)
    {
        const std::size_t size = particles_.values.elementBytes(k);
        putValues(to, &field_[k][i*size], size);
    }
}

//- A particle that this rank has owned
template<class Backend, int D, class P>
void ParticleMigration<Backend, D, P>::moveOne(int i, const Place& was)
{
    const UniformGrid<D>& whole = bricks_.whole();
    Vec<D, double> x;
    for (int d = 0; d < D; ++d)
        std::memcpy(&x.c[d], &field_[particles_.at.x + d][i*sizeof(double)], sizeof(double));
    const typename UniformGrid<D>::Index c = InCell<D, real>(whole, x).index();
    bool in = true;
    for (int d = 0; d < D; ++d) in = in && c.c[d] >= 0 && c.c[d] < whole.n[d];
    if (!in)
    {
        Left left{was.cell, was.within, 0, {}};
        std::memcpy(&left.id, &field_[particles_.at.id][i*sizeof(std::int32_t)], sizeof(left.id));
        for (int d = 0; d < D; ++d) left.x[d] = x.c[d];
        left_.push_back(left);
        return;
    }
    for (const int r : bricks_.seenBy(c))
    {
        if (!bricks_.needs(r, c)) continue;
        if (r == bricks_.rank()) stay_.push_back(was);
        else put(out_[r], i, was);
    }
    if (bricks_.owner(c) == bricks_.rank()) ++owned_;
}

template<class Backend, int D, class P>
void ParticleMigration<Backend, D, P>::takeFrom(const RankBytes& from, int list)
{
    const std::size_t each = sizeof(std::int64_t) + sizeof(int) + bytes_;
    for (std::size_t at = 0; at < from.size(); at += each)
    {
        Place place{0, 0, list, int(at/each)};
        const unsigned char* next = from.data() + at;
        takeValues(next, &place.cell);
        takeValues(next, &place.within);
        came_.push_back(place);
        Vec<D, double> x;                   // the first fields
        takeValues(next, x.c, D);
        const auto c = InCell<D, real>(bricks_.whole(), x).index();
        if (bricks_.owner(c) != bricks_.rank()) continue;
        ++owned_;
        ++p_.set.meter->arrivals;
    }
}

//- All that stay and have come, in the order in which they stood
template<class Backend, int D, class P>
void ParticleMigration<Backend, D, P>::rebuild()
{
    std::sort(came_.begin(), came_.end());
    std::vector<Place> all(stay_.size() + came_.size());
    std::merge(stay_.begin(), stay_.end(), came_.begin(), came_.end(), all.begin());
    const std::size_t n = all.size(), each = sizeof(std::int64_t) + sizeof(int) + bytes_;
    FieldSet<Backend>& values = particles_.values;
    particles_.n = 0;                       // what is there is read already
    particles_.reserve(n);
    // Most stand side by side as they did
    std::vector<std::size_t> runs;
    for (std::size_t i = 0; i < n; ++i)
    {
        const bool goesOn = i && all[i].list < 0 && all[i - 1].list < 0
            && all[i].at == all[i - 1].at + 1;
        if (!goesOn) runs.push_back(i);
    }
    runs.push_back(n);
    std::size_t before = sizeof(std::int64_t) + sizeof(int);
    RankBytes merged;
    for (int k = 0; k < values.fields(); ++k)
    {
        const std::size_t size = values.elementBytes(k);
        merged.resize(n*size);
        for (std::size_t r = 0; r + 1 < runs.size(); ++r)
        {
            const std::size_t i = runs[r];
            const Place& p = all[i];
            std::memcpy(&merged[i*size],
                p.list < 0 ? &field_[k][p.at*size] : &in_[p.list][p.at*each + before],
                (runs[r + 1] - i)*size);
        }
        if (n) p_.set.context.toDevice(values.bytes(k), merged.data(), merged.size());
        before += size;
    }
    particles_.n = int(n);
}

//- On all ranks, in the order of one process. Those that have gone through an opening count as that
template<class Backend, int D, class P>
void ParticleMigration<Backend, D, P>::tellLeft(PicReport& report)
{
    join(bricks_.ranks(), left_);
    std::sort(left_.begin(), left_.end(), [](const Left& a, const Left& b)
        { return a.cell < b.cell || (a.cell == b.cell && a.within < b.within); });
    const double nowhere = p_.set.emptyCoordinate;
    for (const Left& left : left_)
    {
        Vec<D, double> x;
        for (int d = 0; d < D; ++d) x.c[d] = left.x[d];
        if (p_.openings.takeLeft(x)) continue;
        Vector3 at{{nowhere, nowhere, nowhere}};
        for (int d = 0; d < D; ++d)
            at[p_.set.config.axes[d]] = p_.set.grid.origin[d] + left.x[d];
        report.escaped.push_back(at);
        report.escapedId.push_back(left.id);
    }
}

template<class Backend, int D, class P>
void ParticleMigration<Backend, D, P>::migrate(PicReport& report)
{
    const UniformGrid<D>& grid = p_.set.grid;
    const UniformGrid<D>& whole = bricks_.whole();
    const CellBox& brick = bricks_.brick();
    readFields();
    std::vector<int> start = particles_.starts();
    std::vector<int>& entered = particles_.entered;
    const int before = particles_.n - int(entered.size());
    start.back() = before;                  // room was made for those that have come in
    typename UniformGrid<D>::Index c{{0, 0, 0}};
    for (c.c[2] = brick.low[2]; c.c[2] < brick.high[2]; ++c.c[2])
        for (c.c[1] = brick.low[1]; c.c[1] < brick.high[1]; ++c.c[1])
            for (c.c[0] = brick.low[0]; c.c[0] < brick.high[0]; ++c.c[0])
            {
                typename UniformGrid<D>::Index here = c;
                for (int d = 0; d < D; ++d) here.c[d] -= grid.first[d];
                const int cell = grid.cell(here);
                for (int i = start[cell]; i < start[cell + 1]; ++i)
                    moveOne(i, Place{whole.cell(c), i - start[cell], -1, i});
            }
    for (std::size_t k = 0; k < entered.size(); ++k)
        moveOne(before + int(k), Place{whole.cells(), entered[k], -1, before + int(k)});
    entered.clear();
    bricks_.ranks().exchange(out_, in_);
    for (int r = 0; r < bricks_.size(); ++r) takeFrom(in_[r], r);
    rebuild();
    std::vector<std::int64_t> sums{owned_, std::int64_t(left_.size())};
    bricks_.ranks().sum(sums);
    if (sums[0] + sums[1] != particles_.all())
        throw std::logic_error("particles were lost between processes");
    particles_.setAll(sums[0]);
    if (sums[1]) tellLeft(report);
}

} // namespace riprap
