#include "CommandTest.h"
