/*  What a contact law sees of two touching bodies A and B.

        n       unit vector from A to B                                             (paper 1, Eq. 2)
        delta   overlap, > 0: -U_n of Eq. 5, enlarged by the pair's gap (paper 2, Eq. 19)
        V_n     rate of approach, d(delta)/dt = -(v_B - v_A).n                       (Eq. 6)
        V_s     velocity of B's surface past A's: (v_B - v_A) - (a_A w_A + a_B w_B) x n, in the
                contact plane (Eq. 8), with arms a = R + U_n/2 to the middle of the overlap
        W       w_B - w_A without twist

    Forces are those on A: -f_n n + f_t, with f_t along V_s (B drags A along); B gets the reverse.
    The moment of f_t is a_A n x f_t on A and a_B n x f_t on B, since a_A + a_B = d: linear and
    angular momentum are kept to round-off. T is a scalar or a Pack: laws are free of branches on
    their arguments.

    SPDX-License-Identifier: GPL-3.0-or-later
*/
#pragma once

#include "dem/state/frame.hpp"

namespace riprap
{

template<int D, class T>
struct ContactGeometry
{
    Vec<D, T> n;
    T overlap;                  // delta [m]
    T approach;                 // V_n [m/s]
    Tangent<D, T> slip;         // V_s [m/s]
    Spin<D, T> roll;            // W [rad/s]
    T reducedMass;              // m* = m_A m_B/(m_A + m_B) [kg]
    T meanMass;                 // m_ij = (m_A + m_B)/2 [kg]
    T reducedRadius;            // R* = R_A R_B/(R_A + R_B) [m]
    T dt;                       // the step that led here [s]
    // [s] by which what is remembered grows: dt, or 0 where a force is but read once more
    T since;
};

//- What a normal law says
template<class T>
struct NormalForce
{
    T force;                    // f_n, pushes A along -n [N]
    T elastic;                  // f_n without its dashpot [N]
    T stiffness;                // df_n/d(delta) [N/m]
    T damping;                  // of the dashpot [N s/m]
    // by which friction and rolling are limited: f_n, and what adhesion adds to it [N]
    T load;
};

//- Forces and moments of a contact on A (force) and B (-force)
template<int D, class T>
struct ContactForce
{
    Vec<D, T> force;
    Spin<D, T> momentA, momentB;
};

} // namespace riprap
