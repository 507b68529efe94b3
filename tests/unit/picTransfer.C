#include "picTransfer.hpp"
#include "picPaths.hpp"
