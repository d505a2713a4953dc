#include "shared/surf/mesh/surface_elements.h"
