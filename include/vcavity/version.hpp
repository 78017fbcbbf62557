// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The version of vcavity, in semantic versioning. This is the one place where it stands: CMake reads it from
/// here.

#define VCAVITY_VERSION_MAJOR 0
#define VCAVITY_VERSION_MINOR 1
#define VCAVITY_VERSION_PATCH 0
#define VCAVITY_VERSION "0.1.0"
