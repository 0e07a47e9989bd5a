// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

// All of the library: docs/user/library.md.
#include <etendue/case.h>
#include <etendue/command.h>
#include <etendue/errors.h>
#include <etendue/mesh.h>
#include <etendue/solution.h>
#include <etendue/solve.h>
