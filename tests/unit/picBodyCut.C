#include "picBodyCut.hpp"
