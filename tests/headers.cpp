// SPDX-License-Identifier: AGPL-3.0-or-later
// Gives the precompiled headers of the tests their flags.
