/*  The pressure with free bodies solved by several processes together: p, accelerations and
    iterations are those of one process, wherever borders cut bodies. Run by
    tests/regression/ranks.sh: rankTests, mpirun -np N rankTests -parallel.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#include <cstdlib>
#include <functional>
#include <iostream>
#include "../unitFoam/ballsInWater.hpp"
#include "../unitFoam/testTime.H"
#include "particlesOnRanks.H"
#include "pic/bodies/deflation.hpp"
#include "pressureSolver.H"
#include "processRanks.H"
#include "foamVersions/foamVersions.H"

namespace
{

using namespace Foam;
using riprap::CellCorner;
using riprap::ReducedSystem;

//- Which rank has a cell
using Division = std::function<int(const CellCorner&)>;

//- The rows of one rank, and what couples them to others
struct Part
{
    ReducedSystem system;
    std::vector<int> whole;         // row of the whole system of each
};

Part partOf(const ReducedSystem& s, const Division& division, int rank)
{
    Part part;
    ReducedSystem& p = part.system;
    p.divided = true;
    p.closed = s.closed;
    p.dimensions = s.dimensions;
    for (int d = 0; d < 3; ++d) { p.n[d] = s.n[d]; p.periodic[d] = s.periodic[d]; }
    std::vector<int> at(s.rows()), local(s.rows(), -1);
    for (int i = 0; i < s.rows(); ++i)
    {
        at[i] = division(riprap::cornerOf(s, s.cell[i]));
        if (at[i] != rank) continue;
        local[i] = p.rows();
        part.whole.push_back(i);
        p.cell.push_back(s.cell[i]);
        p.diagonal.push_back(s.diagonal[i]);
        p.rhs.push_back(s.rhs[i]);
        p.x.push_back(s.x[i]);
    }
    std::map<int, riprap::RankBorder> borders;
    for (std::size_t f = 0; f < s.owner.size(); ++f)
    {
        const int a = s.owner[f], b = s.neighbour[f];
        if (at[a] == rank && at[b] == rank)
        {
            p.owner.push_back(local[a]);
            p.neighbour.push_back(local[b]);
            p.offDiagonal.push_back(s.offDiagonal[f]);
        }
        else if (at[a] == rank || at[b] == rank)
        {
            riprap::RankBorder& border = borders[at[a] == rank ? at[b] : at[a]];
            border.row.push_back(local[at[a] == rank ? a : b]);
            border.offDiagonal.push_back(s.offDiagonal[f]);
        }
    }
    for (auto& border : borders)
    {
        border.second.rank = border.first;
        p.borders.push_back(border.second);
    }
    for (const riprap::BodyRows& b : s.bodies)
    {
        riprap::BodyRows here;
        here.modes = b.modes;
        here.light = b.light;
        for (std::size_t i = 0; i < b.row.size(); ++i)
        {
            if (local[b.row[i]] < 0) continue;
            here.row.push_back(local[b.row[i]]);
            here.u.insert(here.u.end(), b.u.begin() + i*b.modes, b.u.begin() + (i + 1)*b.modes);
        }
        p.bodies.push_back(here);
    }
    return part;
}

//- While it lives this process is by itself
struct Alone
{
    const bool before = UPstream::parRun();
    Alone() { UPstream::parRun() = false; }
    ~Alone() { UPstream::parRun() = before; }
};

double random(unsigned& seed)
{
    seed = seed*1664525u + 1013904223u;
    return seed/4294967296.0 - 0.5;
}

double largestOf(const std::vector<double>& a, const std::vector<double>* b = nullptr)
{
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::fabs(a[i] - (b ? (*b)[i] : 0)));
    return most;
}

//- What the test found, on all ranks
struct Found
{
    int mostRanksOfABody = 0, columns[2] = {0, 0}, emptyRanks = 0;
    double projection = 0, same = 0, lowest = 0;
};

//- Solves together with the other ranks, and hands back the whole p
class Together : public riprap::LinearSolver
{
public:
    Together(const std::string& controls, const Division& division)
        : solver_(testTime(), "p", entries(controls)), division_(division)
    {}

    Found found;

    riprap::PressureReport solve(ReducedSystem& s) override
    {
        Part part = partOf(s, division_, UPstream::myProcNo());
        const processRanks ranks(part.system, UPstream::worldComm);
        look(s, part, UPstream::parRun() ? &ranks : nullptr);
        const riprap::PressureReport r = solver_.solve(part.system);
        s.x = together(s, part, part.system.x);
        return r;
    }

private:
    static std::vector<double> together(
        const ReducedSystem& s, const Part& part, const std::vector<double>& x)
    {
        std::vector<double> all(s.rows(), 0.0);
        for (std::size_t i = 0; i < part.whole.size(); ++i) all[part.whole[i]] = x[i];
        if (UPstream::parRun()) processRanks(part.system, UPstream::worldComm).sum(all);
        return all;
    }

    //- Q = Z E^-1 Z^T is positive, takes Z to Z through A + U U^T, and is that of one process
    void look(const ReducedSystem& s, const Part& part, const riprap::Ranks* ranks)
    {
        std::vector<double> has;
        for (const riprap::BodyRows& b : part.system.bodies) has.push_back(b.row.empty() ? 0 : 1);
        has.push_back(part.whole.empty() ? 1 : 0);
        if (ranks) ranks->sum(has);
        found.emptyRanks = int(has.back());
        has.pop_back();
        for (const double h : has)
            found.mostRanksOfABody = std::max(found.mostRanksOfABody, int(h));

        riprap::DeflationControls controls;
        controls.heavyHats = true;
        const riprap::BodyDeflation one(s, controls), divided(part.system, controls, ranks);
        found.columns[0] = one.columns();
        found.columns[1] = divided.columns();
        unsigned seed = 3;
        std::vector<double> r(s.rows()), here;
        for (double& v : r) v = random(seed);
        for (const int i : part.whole) here.push_back(r[i]);
        std::vector<double> z(here.size(), 0.0), az(here.size()), back(here.size(), 0.0),
            reference(s.rows(), 0.0);
        divided.correct(here.data(), z.data());
        divided.product(z.data(), az.data());
        divided.correct(az.data(), back.data());
        one.correct(r.data(), reference.data());
        const std::vector<double> all = together(s, part, z), again = together(s, part, back);
        const double most = std::max(largestOf(all), 1e-300);
        found.projection = largestOf(all, &again)/most;
        found.same = largestOf(all, &reference)/most;
        for (int i = 0; i < s.rows(); ++i) found.lowest += all[i]*r[i];
    }

    pressureSolver solver_;
    const Division division_;
};

//- By the master alone, who tells the others
class ByItself : public riprap::LinearSolver
{
public:
    explicit ByItself(const std::string& controls) : solver_(testTime(), "p", entries(controls)) {}

    riprap::PressureReport solve(ReducedSystem& s) override
    {
        std::vector<double> told(s.rows() + 2, 0.0);
        if (UPstream::master())
        {
            const Alone alone;
            const riprap::PressureReport r = solver_.solve(s);
            std::copy(s.x.begin(), s.x.end(), told.begin() + 2);
            told[0] = r.iterations;
            told[1] = r.converged;
        }
        if (UPstream::parRun()) processRanks(s, UPstream::worldComm).sum(told);
        std::copy(told.begin() + 2, told.end(), s.x.begin());
        riprap::PressureReport r;
        r.iterations = int(told[0]);
        r.converged = told[1] > 0;
        return r;
    }

private:
    pressureSolver solver_;
};

int failures = 0;

void say(const std::string& name, const std::string& reason)
{
    if (!reason.empty()) ++failures;
    if (UPstream::master())
        std::cout << (reason.empty() ? "PASS " : "FAIL ") << "ranks." << UPstream::nProcs() << "."
                  << name << (reason.empty() ? "" : " " + reason) << std::endl;
}

//- What is looked for beside p and accelerations
struct Expected
{
    bool everywhere = false;        // a body is on all ranks
    int emptyRanks = 0;             // hold no water
};

template<int D>
void compare(const std::string& name, const std::function<BallsInWater<D>()>& make,
    const std::vector<double>& ratio, const std::string& preconditioner, const Division& division,
    const Expected& expected = Expected())
{
    const bool local = preconditioner != "diagonal";
    const std::string controls = local
        ? coupled(1e-13)
        : "solver coupledPCG; preconditioner diagonal; tolerance 1e-11; relTol 0; maxIter 1000;";
    BallsInWater<D> one = make(), divided = make();
    std::vector<double> ratios;
    for (std::size_t b = 0; b < one.bodies.size(); ++b) ratios.push_back(ratio[b % ratio.size()]);
    ByItself alone(controls);
    Together together(controls, division);
    one.project(ratios, alone);
    divided.project(ratios, together);
    const Found& f = together.found;
    double a = 0;
    for (int b = 0; b < int(one.bodies.size()); ++b)
        for (int m = 0; m < one.cut.terms[b].modes; ++m)
            a = std::max(a,
                std::fabs(one.acceleration(b, m) - divided.acceleration(b, m))
                    *(m < D ? 1 : one.bodies[b].reach)/one.g);
    const double p = largestOf(one.p, &divided.p)/largestOf(one.p);

    std::ostringstream why;
    if (!one.report.converged || !divided.report.converged) why << "not converged; ";
    if (!(p < 1e-8)) why << "p differs by " << p << "; ";
    if (!(a < 1e-8)) why << "accelerations differ by " << a << " g; ";
    // GAMG joins cells of one rank alone, and turns the order in which it does from one call to the
    // next: it is not quite the same preconditioner
    const int most = local ? one.report.iterations/5 : 2;
    if (std::abs(one.report.iterations - divided.report.iterations) > most)
        why << divided.report.iterations << " iterations, by one process " << one.report.iterations
            << "; ";
    if (f.columns[0] != f.columns[1])
        why << f.columns[1] << " columns, by one process " << f.columns[0] << "; ";
    if (!(f.projection < 1e-9)) why << "Q A Q is off Q by " << f.projection << "; ";
    if (!(f.same < 1e-8)) why << "Q is off that of one process by " << f.same << "; ";
    if (f.columns[0] && !(f.lowest > 0)) why << "Q is not positive; ";
    if (expected.everywhere && f.mostRanksOfABody != UPstream::nProcs())
        why << "no body is on all ranks; ";
    if (f.emptyRanks != expected.emptyRanks) why << f.emptyRanks << " ranks hold no water; ";
    if (UPstream::master())
        std::cout << name << ": p " << p << ", a " << a << " g, iterations "
                  << one.report.iterations << " " << divided.report.iterations << ", columns "
                  << f.columns[0] << ", Q " << f.projection << " " << f.same << ", ranks of a body "
                  << f.mostRanksOfABody << ", without rows " << f.emptyRanks << std::endl;
    say(name, why.str());
}

//- One in the middle, which planes through the middle of the grid cut, and others about it
BallsInWater<2> disks(bool closed)
{
    BallsInWater<2> s(64, 1.0/64);
    s.addBall({{0.503, 0.497}}, 8.2/64);
    fillWith(s, 9);
    if (closed) s.phi.assign(s.grid.cells(), -1);
    return s;
}

BallsInWater<3> spheres(bool closed)
{
    const int n = 24;
    BallsInWater<3> s(n, 1.0/n);
    s.addBall({{0.503, 0.497, 0.51}}, 4.3/n);
    for (const double x : {0.22, 0.77}) s.addBall({{x, 0.25, 0.28}}, 3.1/n);
    s.addBall({{0.25, 0.75, 0.76}}, 3.4/n);
    if (!closed)
        for (int i = 0; i < s.grid.cells(); ++i)
            s.phi[i] = (s.grid.cellIndex(i).c[2] + 0.5)*s.grid.h - 0.9;
    return s;
}

//- Halves; thirds beside each other; quarters that meet in the middle
Division parts(int side)
{
    const int ranks = UPstream::nProcs();
    return [=](const CellCorner& x)
    {
        if (ranks == 4) return (2*x[0] >= side ? 1 : 0) + (2*x[1] >= side ? 2 : 0);
        // the middle one is narrower than the body
        if (ranks == 3 && 7*x[0] >= 3*side) return 7*x[0] < 4*side ? 1 : 2;
        return ranks == 2 && 2*x[0] >= side ? 1 : 0;
    };
}

//- Blocks of cells here and there
Division blocks(int width)
{
    const int ranks = UPstream::nProcs();
    return [=](const CellCorner& x)
    {
        return (x[0]/width*5 + x[1]/width*3 + x[2]/width*7
                   + x[0]/width*(x[1]/width))
            % ranks;
    };
}

//- Layers up to a level, above which the last rank is
Division layers(int level)
{
    const int ranks = UPstream::nProcs();
    return [=](const CellCorner& x) { return std::min(ranks - 1, x[1]*(ranks - 1)/level); };
}

std::string name(const std::string& of, double ratio, const std::string& preconditioner)
{
    std::ostringstream os;
    os << of << "." << ratio << "." << preconditioner;
    return os.str();
}

} // namespace

int main(int argc, char* argv[])
{
    using namespace Foam;
    ParRunControl ranks;
    if (argc > 1 && std::string(argv[1]) == "-parallel") beginParallel(ranks, argc, argv);
    messageStream::level = 0;
    const int more = UPstream::nProcs() > 1;
    const std::vector<double> mixed{2.7, 1e-3, 1e3, 0.1, 1};
    for (const std::string& preconditioner : {std::string("GAMG"), std::string("diagonal")})
    {
        for (const double ratio : {1e-3, 1.0, 2.7, 1e3})
        {
            if (preconditioner == "diagonal" && (ratio == 1 || ratio == 2.7)) continue;
            compare<2>(name("disks", ratio, preconditioner), [] { return disks(false); }, {ratio},
                preconditioner, parts(64), {true, 0});
            compare<2>(name("closed", ratio, preconditioner), [] { return disks(true); }, {ratio},
                preconditioner, parts(64), {true, 0});
            compare<3>(name("spheres", ratio, preconditioner), [] { return spheres(false); },
                {ratio}, preconditioner, parts(24), {true, 0});
        }
        compare<2>(
            "blocks." + preconditioner, [] { return disks(false); }, mixed, preconditioner,
            blocks(9));
        compare<3>(
            "blocks3D." + preconditioner, [] { return spheres(true); }, mixed, preconditioner,
            blocks(7));
        compare<2>("layers." + preconditioner, [] { return disks(false); }, mixed, preconditioner,
            layers(52), {false, more});
    }
    failures += particlesOnRanks();
    return failures ? 1 : 0;
}
