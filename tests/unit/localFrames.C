#include "localFrames.hpp"
