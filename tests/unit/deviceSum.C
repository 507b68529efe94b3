#include "deviceSum.hpp"
