#include "terms.hpp"
