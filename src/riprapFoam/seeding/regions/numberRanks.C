// SPDX-License-Identifier: GPL-3.0-or-later

#include "numberRanks.H"
#include "allRanks.H"
#include "pstreamTransport.H"
#include "wholeBoundary.H"

#include <algorithm>

namespace Foam
{

using bytesOfRanks = std::vector<riprap::RankBytes>;


// The process that answers for a number
static int rankOf(std::int64_t number, std::int64_t numbers)
{
    return int(number/(numbers/Pstream::nProcs() + 1));
}


// May points be on the surfaces of their cells? Of warped faces all that is near
class cellSurface
{
    const polyMesh& mesh_;
    scalarField room_;              // of each face: it is no further from its plane

public:

    explicit cellSurface(const polyMesh& mesh) : mesh_(mesh), room_(mesh.nFaces(), Zero)
    {
        forAll(room_, f)
        {
            const vector n(unitNormal(f));
            const point& middle = mesh.faceCentres()[f];
            const point& inside = mesh.cellCentres()[mesh.faceOwner()[f]];
            for (const label v : mesh.faces()[f])
                room_[f] = max(room_[f], mag((mesh.points()[v] - middle) & n));
            room_[f] += 1e-6*mag((middle - inside) & n);
        }
    }

    vector unitNormal(label f) const
    {
        return mesh_.faceAreas()[f]/max(mag(mesh_.faceAreas()[f]), VSMALL);
    }

    bool has(const point& p, label cell) const
    {
        for (const label f : mesh_.cells()[cell])
        {
            const scalar outward = mesh_.faceOwner()[f] == cell ? 1 : -1;
            if (outward*((p - mesh_.faceCentres()[f]) & unitNormal(f)) > -room_[f]) return true;
        }
        return false;
    }
};


struct claimedPoint
{
    std::int64_t number, cell;
};


// Of all claims those that have the lowest cell of their number, a byte each
static bytesOfRanks judge(const bytesOfRanks& claims)
{
    struct claim
    {
        claimedPoint point;
        std::size_t rank, entry;
    };
    std::vector<claim> all;
    bytesOfRanks answers(claims.size());
    for (std::size_t rank = 0; rank < claims.size(); ++rank)
    {
        const unsigned char* from = claims[rank].data();
        const std::size_t n = claims[rank].size()/sizeof(claimedPoint);
        answers[rank].assign(n, 0);
        for (std::size_t i = 0; i < n; ++i)
        {
            claimedPoint point;
            takeBytes(from, &point);
            all.push_back({point, rank, i});
        }
    }
    std::sort(all.begin(), all.end(), [](const claim& a, const claim& b)
    {
        return a.point.number != b.point.number ? a.point.number < b.point.number
                                                : a.point.cell < b.point.cell;
    });
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        if (i == 0 || all[i].point.number != all[i - 1].point.number)
            answers[all[i].rank][all[i].entry] = 1;
    }
    return answers;
}


// Numbers that follow each other, and how many
struct numberRun
{
    std::int64_t first, size;
};


// Runs end at the ends of blocks
static std::vector<numberRun> runsOf(const particleRegion& region)
{
    std::vector<numberRun> runs;
    for (const std::int64_t n : region.number)
    {
        const bool goesOn = !runs.empty() && n == runs.back().first + runs.back().size
            && rankOf(n, region.numbers) == rankOf(runs.back().first, region.numbers);
        if (goesOn) ++runs.back().size;
        else runs.push_back({n, 1});
    }
    return runs;
}


// Of each run the ids begin at `before` and the number of points in lower ones, those of the blocks
// before among them. before becomes larger by all
static bytesOfRanks numberRuns(const bytesOfRanks& asked, std::int64_t& before)
{
    struct place
    {
        numberRun run;
        std::size_t rank, entry;
    };
    std::vector<place> all;
    std::vector<std::vector<std::int64_t>> begin(asked.size());
    std::vector<std::int64_t> sums(asked.size(), 0);
    for (std::size_t rank = 0; rank < asked.size(); ++rank)
    {
        const unsigned char* from = asked[rank].data();
        begin[rank].resize(asked[rank].size()/sizeof(numberRun));
        for (std::size_t i = 0; i < begin[rank].size(); ++i)
        {
            numberRun run;
            takeBytes(from, &run);
            all.push_back({run, rank, i});
            sums[Pstream::myProcNo()] += run.size;
        }
    }
    std::sort(all.begin(), all.end(),
        [](const place& a, const place& b) { return a.run.first < b.run.first; });

    pstreamTransport().sum(sums);
    std::int64_t id = before, end = -1;
    for (std::size_t rank = 0; rank < sums.size(); ++rank)
    {
        if (int(rank) < Pstream::myProcNo()) id += sums[rank];
        before += sums[rank];
    }
    bool twice = false;
    for (const place& p : all)
    {
        twice = twice || p.run.first < end;
        end = p.run.first + p.run.size;
        begin[p.rank][p.entry] = id;
        id += p.run.size;
    }
    stopIfAny(twice ? "Two processes have the same particle" : "");

    bytesOfRanks answers(asked.size());
    for (std::size_t rank = 0; rank < begin.size(); ++rank)
        riprap::putValues(answers[rank], begin[rank].data(), begin[rank].size());
    return answers;
}

} // namespace Foam


Foam::wholeCells::wholeCells(const polyMesh& mesh)
:
    number_(processorAddressing(mesh, "cellProcAddressing"))
{
    if (!onAllRanks(number_.size() == mesh.nCells())) number_.clear();
}


std::int64_t Foam::wholeCells::operator()(label cell) const
{
    return number_.size() ? std::int64_t(number_[cell])
                          : (std::int64_t(Pstream::myProcNo()) << 31) + cell;
}


void Foam::keepLowestCell(const polyMesh& mesh, particleRegion& region)
{
    pstreamTransport ranks;
    const wholeCells whole(mesh);
    const cellSurface surface(mesh);

    // In the order of numbers, as are the processes that are asked
    bytesOfRanks claims(ranks.size()), asked, answers;
    std::vector<label> claimed;
    forAll(region.position, i)
    {
        if (!surface.has(region.position[i], region.cell[i])) continue;
        const claimedPoint claim{region.number[i], whole(region.cell[i])};
        riprap::putValues(claims[rankOf(claim.number, region.numbers)], &claim);
        claimed.push_back(i);
    }
    ranks.exchange(claims, asked);
    ranks.exchange(judge(asked), answers);

    boolList good(region.size(), true);
    std::size_t next = 0;
    for (const riprap::RankBytes& answer : answers)
    {
        for (const unsigned char mine : answer) good[claimed[next++]] = mine;
    }
    region.keep(good);
}


Foam::labelField Foam::idsOfRanks(const particleRegion& region, std::int64_t& before)
{
    pstreamTransport ranks;
    const std::vector<numberRun> runs(runsOf(region));
    bytesOfRanks out(ranks.size()), asked, answers;
    for (const numberRun& run : runs)
        riprap::putValues(out[rankOf(run.first, region.numbers)], &run);
    ranks.exchange(out, asked);
    ranks.exchange(numberRuns(asked, before), answers);

    labelField ids(region.size());
    std::size_t next = 0;
    label i = 0;
    for (const riprap::RankBytes& answer : answers)
    {
        const unsigned char* from = answer.data();
        for (std::size_t k = 0; k < answer.size()/sizeof(std::int64_t); ++k)
        {
            std::int64_t id;
            takeBytes(from, &id);
            for (std::int64_t n = 0; n < runs[next].size; ++n) ids[i++] = label(id + n);
            ++next;
        }
    }
    return ids;
}
