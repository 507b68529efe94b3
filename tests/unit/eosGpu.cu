#include "eos.hpp"
