#include "pressureMultigrid.hpp"
