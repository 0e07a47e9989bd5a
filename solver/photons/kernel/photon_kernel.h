// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "solver/photons/kernel/photon_scene.h"

namespace etendue {

/// Asked by the thread that walks histories, some thousand times a second: `ended` of them have ended since
/// the last time. False ends the walk at once, with histories that are cut short.
struct WalkWatch {
  bool (*goes_on)(void* watcher, std::uint64_t ended) = nullptr;  ///< null: the walk continues to its end
  void* watcher = nullptr;
};

/// Histories that follow each other.
struct HistoryRange {
  std::span<const PhotonStart> starts;
  std::uint64_t first = 0;  ///< number of the first; the random numbers of each depend on its number alone
  std::uint64_t seed = 1;
  double roulette = 0;  ///< weight below which a photon plays for its life
  WalkWatch watch = {};
};

/// Functions that walk histories, compiled for one instruction set. Absorption and walls take from the weight
/// of a photon (implicit capture), scattering turns it, and it ends where nothing is left, by roulette, or
/// where it leaves (Lux and Koblinger 1991, chapter 5).
struct PhotonKernels {
  const char* name;
  /// From the light on: what the photons leave is added to the tally.
  PhotonCounts (*follow)(const PhotonSceneView& scene, const HistoryRange& range, const PhotonTally& tally);
  /// The same by time; histories end with the last bin.
  PhotonCounts (*follow_in_time)(const PhotonSceneView& scene, const HistoryRange& range,
                                 const TimedTally& tally);
  /// Traces histories from the lights and writes their hits into the buffers.
  PhotonCounts (*record)(const PhotonSceneView& scene, const HistoryRange& range, HitBuffers& buffers);
  /// Against the light: starts travel the path of the light in reverse. score[i] becomes the radiance that
  /// history i collects from media and walls, times its weight.
  PhotonCounts (*collect)(const PhotonSceneView& scene, const HistoryRange& range, double* score);
};

/// The widest that this machine has, or what ETENDUE_ISA names (baseline, avx2, avx512): the same bits.
PhotonKernels choose_photon_kernels();

}  // namespace etendue
