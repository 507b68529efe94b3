#include "cellGrid.hpp"
