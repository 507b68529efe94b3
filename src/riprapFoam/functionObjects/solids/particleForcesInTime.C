/*---------------------------------------------------------------------------*\
    riprap: particles inside OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    particleForces: when is summed, means over time, impulse, and what a restart needs
\*---------------------------------------------------------------------------*/

#include "particleForces.H"

#include <algorithm>

namespace
{
    // Of the impulse, for a restart: its time, the impulse and the force then
    const Foam::word impulseProperty("impulse");
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

std::vector<double> Foam::functionObjects::particleForces::asNumbers
(
    const sums& first,
    const sums& second
)
{
    std::vector<double> all;
    for (const sums* list : {&first, &second})
    {
        for (const vector& v : *list) all.insert(all.end(), v.begin(), v.end());
    }
    return all;
}


void Foam::functionObjects::particleForces::fromNumbers
(
    const std::vector<double>& all,
    sums& first,
    sums& second
)
{
    auto from = all.begin();
    for (sums* list : {&first, &second})
    {
        for (vector& v : *list)
        {
            std::copy(from, from + vector::nComponents, v.begin());
            from += vector::nComponents;
        }
    }
}


void Foam::functionObjects::particleForces::sumForces()
{
    force_ = vector(Zero);
    moment_ = vector(Zero);

    if (parts_->fluid())
    {
        riprap::FluidScene& scene = parts_->fluid()->fluidScene();
        if (parts_->ofFluid().found(true))
        {
            addFluid(scene.forcesOnWalls(), parts_->ofFluid());
        }
        if (parts_->groups().found(true))
        {
            addFluid(scene.forcesOnSolids(), parts_->groups());
        }
    }
    addContactsOnWalls();
    addContactsOnGroups();
}


void Foam::functionObjects::particleForces::sample()
{
    if (sampledAt_ == time_.value()) return;

    sumForces();
    sampledAt_ = time_.value();
    if (mean_.on()) mean_.add(sampledAt_, asNumbers(force_, moment_), dict_, name());
    if (wantImpulse_) addImpulse();
}


void Foam::functionObjects::particleForces::readImpulse(const dictionary& dict)
{
    wantImpulse_ = dict.lookupOrDefault("impulse", false);
    if (!wantImpulse_ || impulseAt_ > -GREAT) return;

    impulse_ = vector(Zero);
    impulseForce_ = vector(Zero);
    const scalarList before(saved(impulseProperty));
    if (before.size() == 1 + 2*kinds*vector::nComponents)
    {
        impulseAt_ = before[0];
        fromNumbers({before.begin() + 1, before.end()}, impulse_, impulseForce_);
    }
}


//- Forces are linear between samples: the trapezoidal rule
void Foam::functionObjects::particleForces::addImpulse()
{
    const scalar step = impulseAt_ > -GREAT ? sampledAt_ - impulseAt_ : 0;
    forAll(impulse_, k)
    {
        impulse_[k] += 0.5*step*(impulseForce_[k] + force_[k]);
    }
    impulseForce_ = force_;
    impulseAt_ = sampledAt_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::particleForces::executeSample()
{
    if (mean_.on() || wantImpulse_) sample();

    if (time_.writeTime())
    {
        save(mean_);
        if (wantImpulse_)
        {
            scalarList kept(1, impulseAt_);
            for (const double number : asNumbers(impulse_, impulseForce_)) kept.append(number);
            keep(impulseProperty, kept);
        }
    }
    return true;
}


// ************************************************************************* //
