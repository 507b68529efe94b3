/*  What the experiments found, beside theory: printed as it comes, and as CSV.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include <cmath>
#include <string>
#include <vector>
#include "api/sphScene.hpp"
#include "experiments.hpp"

namespace riprap
{

struct Result
{
    std::string test;           // acoustic, viscous, force, tensile, passage, faces, wild
    std::string kernel;
    double ratio = 0;           // h/dp
    std::string integrator, terms, walls;
    std::string quantity;
    double measured = NAN, theory = NAN;
    std::string note;
};

class ResultTable
{
public:
    explicit ResultTable(std::string csv) : csv_(std::move(csv)) {}
    void add(const Result&);
    void write() const;

private:
    std::string csv_;
    std::vector<Result> rows_;
};


//- The experiments; quick: fewer kernels, terms and bisections
void acoustic(ResultTable&, bool quick);
void viscous(ResultTable&, bool quick);
void impactForce(ResultTable&, bool quick);
void tensile(ResultTable&, bool quick);
void passage(ResultTable&, bool quick);
void wallFaces(ResultTable&, bool quick);
void wildRule(ResultTable&, bool quick);

} // namespace riprap
