// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Functions of arrays, which are with their type.

#include "drjit/jit.h"
