#include "pressureStep.hpp"
