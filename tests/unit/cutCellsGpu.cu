#include "cutCells.hpp"
