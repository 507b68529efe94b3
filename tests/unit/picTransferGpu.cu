#include "picTransfer.hpp"
