// SPDX-License-Identifier: GPL-3.0-or-later

#include "dividedRegion.H"
#include "allRanks.H"
#include "clipOrStop.H"
#include "dividedCloud.H"
#include "numberRanks.H"
#include "OSspecific.H"
#include "sceneState.H"
#include "core/ranks/joinRanks.hpp"
#include "UIndirectList.H"

#include <algorithm>

namespace Foam
{

// Numbers of which points are made at once where they are counted alone
static constexpr std::int64_t chunk = 1 << 20;


// Of the processes on this machine
static scalar sumOfMachine(scalar own)
{
    const std::string host(hostName() + ' ');
    scalar sum = 0;
    for (const std::string& text : textsOfRanks(host + exact(own)))
    {
        if (text.compare(0, host.size(), host) == 0) sum += std::stod(text.substr(host.size()));
    }
    return sum;
}


static void checkCountOfRanks(const particleSource& source, const particlePacking& packing,
    const boundBox& limits, const boundBox& part, const particleRegion& region)
{
    const scalar all = source.estimate(packing, limits), most = labelMax;
    if (all > most)
    {
        FatalIOErrorInFunction(region.dict)
            << "Region " << region.name << " would hold about " << all << " particles, and ids "
            << "have 32 bits, for " << most << ": is the spacing meant?" << exit(FatalIOError);
    }
    boundBox here(part);
    if (part.valid())
    {
        here.min() = max(part.min(), limits.min());
        here.max() = min(part.max(), limits.max());
    }
    const scalar own = part.valid() ? source.estimate(packing, here) : 0;
    checkCount(region.dict, region.name, own, "spacing");
    checkCount(region.dict, region.name + " on this machine", sumOfMachine(own), "spacing");
}


// The first point that is in no cell of any process
static point firstOutside(const particleSource& source, const particlePacking& packing,
    const polyMesh& mesh, const boundBox& limits)
{
    const boundBox everywhere(-vector::one*GREAT, vector::one*GREAT);
    const std::int64_t n = source.numbers(packing, limits);
    for (std::int64_t first = 0; first < n; first += chunk)
    {
        numberedPoints some;
        source.placePart(packing, limits, everywhere, first, min(first + chunk, n), some);
        const boolList in(inAnyCell(mesh, pointField(some.position)));
        const label bad = in.find(false);
        if (bad >= 0) return some.position[bad];
    }
    return Zero;
}


// f(first, end) for this process's share of numbers, some at a time
template<class Function>
static void eachChunk(std::int64_t numbers, const Function& f)
{
    const std::int64_t ranks = Pstream::nProcs(), rank = Pstream::myProcNo();
    const std::int64_t share = numbers/ranks + 1, end = min((rank + 1)*share, numbers);
    for (std::int64_t first = rank*share; first < end; first += chunk)
        f(first, min(first + chunk, end));
}


// How many points there are: each process counts a share of the numbers
static std::int64_t countAll(
    const particleSource& source, const particlePacking& packing, const boundBox& limits)
{
    const boundBox everywhere(-vector::one*GREAT, vector::one*GREAT);
    std::int64_t found = 0;
    eachChunk(source.numbers(packing, limits), [&](std::int64_t first, std::int64_t end)
    {
        numberedPoints some;
        source.placePart(packing, limits, everywhere, first, end, some);
        found += some.position.size();
    });
    return sumOfRanks(found);
}


// Drop what is in no cell of this process
static void keepInCells(const polyMesh& mesh, particleRegion& region)
{
    region.cell = locateParticles(mesh, region.position, labelList(), false);
    boolList good(region.size());
    forAll(good, i) good[i] = region.cell[i] >= 0;
    region.keep(good);
}



// Numbers ascend in both
static void merge(const particleRegion& some, particleRegion& region)
{
    region.position.append(some.position);
    region.velocity.append(some.velocity);
    region.number.append(some.number);
    region.cell.append(some.cell);
    labelList order;
    sortedOrder(region.number, order);
    region.position = pointField(region.position, order);
    region.velocity = vectorField(region.velocity, order);
    region.number = List<std::int64_t>(UIndirectList<std::int64_t>(region.number, order));
    region.cell = labelList(UIndirectList<label>(region.cell, order));
}

} // namespace Foam


Foam::boundBox Foam::boxOfPart(const polyMesh& mesh)
{
    boundBox part(mesh.points(), false);
    if (mesh.nCells()) part.inflate(1e-6);
    return part;
}


void Foam::placePart
(
    const particleSource& source,
    const particlePacking& packing,
    const regionSpace& space,
    const boundBox& limits,
    particleRegion& region
)
{
    const polyMesh& mesh = space.mesh;
    const boundBox part(boxOfPart(mesh));
    checkCountOfRanks(source, packing, limits, part, region);

    // What the search in cells needs of all processes
    mesh.tetBasePtIs();
    region.numbers = source.numbers(packing, limits);
    {
        numberedPoints points;
        if (mesh.nCells())
            source.placePart(packing, limits, part, 0, region.numbers, points);
        region.position.transfer(points.position);
        region.velocity.transfer(points.velocity);
        region.pressure.transfer(points.pressure);
        region.number.transfer(points.number);
    }
    keepInCells(mesh, region);
    keepLowestCell(mesh, region);
    region.clipped = 0;

    const std::int64_t all = countAll(source, packing, limits);
    const std::int64_t outside = all - sumOfRanks(region.size());
    if (outside < 0)
    {
        FatalErrorInFunction
            << "Region " << region.name << ": processes have " << -outside
            << " particles more than there are" << exit(FatalError);
    }
    if (outside && !region.clip)
    {
        const point first(firstOutside(source, packing, mesh, limits));
        stopAtBad(region, outside, all, "outside the mesh", first);
    }
    if (Pstream::master()) region.clipped = label(outside);
}


std::vector<Foam::labelList> Foam::pointsNearParts(
    const polyMesh& mesh, const pointField& points, scalar reach)
{
    pstreamTransport ranks;
    riprap::RankBytes own;
    boundBox part(boxOfPart(mesh));
    if (mesh.nCells()) riprap::putValues(own, &part);
    std::vector<riprap::RankBytes> boxes;
    ranks.exchange(std::vector<riprap::RankBytes>(ranks.size(), own), boxes);

    std::vector<labelList> near(ranks.size());
    for (int rank = 0; rank < ranks.size(); ++rank)
    {
        if (rank == ranks.rank() || boxes[rank].empty()) continue;
        const unsigned char* from = boxes[rank].data();
        takeBytes(from, &part);
        part.min() -= reach*vector::one;
        part.max() += reach*vector::one;
        DynamicList<label> some;
        forAll(points, i) if (part.contains(points[i])) some.append(i);
        near[rank].transfer(some);
    }
    return near;
}


void Foam::clipOrStopAll(particleRegion& region, const boolList& good, const string& what)
{
    if (!Pstream::parRun())
    {
        clipOrStop(region, good, what);
        return;
    }
    label bad = 0;
    for (const bool g : good) bad += !g;
    const label i = good.find(false);
    point first(i < 0 ? point(Zero) : region.position[i]);
    if (!ofLeast(i < 0 ? noNumber : region.number[i], i >= 0, first)) return;

    if (!region.clip)
        stopAtBad(region, sumOfRanks(bad), sumOfRanks(region.size()), what, first);
    region.keep(good);
}


Foam::pointField Foam::joinRanks(const pointField& own)
{
    pstreamTransport ranks;
    std::vector<point> all(own.begin(), own.end());
    riprap::join(ranks, all);
    pointField joined(label(all.size()));
    std::copy(all.begin(), all.end(), joined.begin());
    return joined;
}


void Foam::gatherPoints(particleRegion& region)
{
    region.position = joinRanks(region.position);
    region.velocity = joinRanks(region.velocity);
    std::vector<std::int64_t> number(region.number.begin(), region.number.end());
    pstreamTransport ranks;
    riprap::join(ranks, number);
    region.number.setSize(label(number.size()));
    std::copy(number.begin(), number.end(), region.number.begin());

    labelList order;
    sortedOrder(region.number, order);
    region.position = pointField(region.position, order);
    region.velocity = vectorField(region.velocity, order);
    region.number = List<std::int64_t>(UIndirectList<std::int64_t>(region.number, order));
}


void Foam::eachShare(
    const latticeRows& rows, const std::function<void(const pointField&)>& f)
{
    const boundBox everywhere(-vector::one*GREAT, vector::one*GREAT);
    eachChunk(rows.numbers(), [&](std::int64_t first, std::int64_t end)
    {
        DynamicList<point> some;
        rows.each(
            everywhere, first, end, [&](const point& p, std::int64_t) { some.append(p); });
        f(pointField(std::move(some)));
    });
}


void Foam::takeBand(const polyMesh& mesh, const particleRegion& band,
    const List<std::int64_t>& former, particleRegion& region)
{
    mesh.tetBasePtIs();
    const wholeCells whole(mesh);
    const labelList cell(locateParticles(mesh, band.position, labelList(), false));
    const double none = -std::numeric_limits<double>::infinity();
    std::vector<double> claim(band.size(), none);
    forAll(cell, i) if (cell[i] >= 0) claim[i] = -double(whole(cell[i]));
    std::vector<double> best(claim);
    pstreamTransport().largest(best);

    boolList mine(band.size());
    forAll(mine, i)
    {
        mine[i] = best[i] > none
            ? claim[i] == best[i]
            : std::binary_search(former.begin(), former.end(), band.number[i]);
    }
    particleRegion own;
    own.position = band.position;
    own.velocity = band.velocity;
    own.number = band.number;
    own.cell = cell;
    own.keep(mine);
    own.cell = locateParticles(mesh, own.position, own.cell, true);
    merge(own, region);
}
