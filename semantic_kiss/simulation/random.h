// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_SIMULATION_RANDOM_H_
#define SEMANTIC_KISS_SIMULATION_RANDOM_H_

#include <cstdint>
#include <initializer_list>

// Random numbers without state that is shared: each is a hash of what it is for (seed, object,
// scan, beam, ...). So neither threads nor the order of work can change a simulated byte.
namespace semantic_kiss::simulation {

// A bijection of 64 bits that leaves no visible pattern (the finalizer of splitmix64).
constexpr uint64_t Scramble(uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
  value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
  return value ^ (value >> 31);
}

// Hash of a list of numbers; their order counts.
constexpr uint64_t HashKey(std::initializer_list<uint64_t> key) {
  uint64_t hash = 0x9e3779b97f4a7c15;
  for (const uint64_t part : key) hash = Scramble(hash + 0x9e3779b97f4a7c15 * (part + 1));
  return hash;
}

// In [0, 1).
constexpr double ToUniform(uint64_t hash) { return (hash >> 11) * 0x1p-53; }

// Purposes that share a key otherwise: keeps, say, a tree's place apart from its height.
enum class Purpose : uint64_t {
  kBeam,
  kRay,
  kSurface,
  kRoute,
  kHills,
  kRelief,
  kStreet,
  kBuilding,
  kVehicle,
  kVegetation,
  kFurniture,
  kPerson,
  kTraffic,
  kMotion,
  kLabel,
  kWander,
};

// The sequence of random numbers that belongs to a key.
class Random {
 public:
  Random(uint64_t seed, Purpose purpose, uint64_t a = 0, uint64_t b = 0)
      : state_(HashKey({seed, static_cast<uint64_t>(purpose), a, b})) {}
  explicit Random(uint64_t key) : state_(key) {}

  uint64_t Next() { return Scramble(state_ += 0x9e3779b97f4a7c15); }
  double Uniform() { return ToUniform(Next()); }                                      // [0, 1)
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }  // [low, high)
  bool Chance(double probability) { return Uniform() < probability; }
  // In 0..size-1; size > 0.
  int Index(int size) { return static_cast<int>(Uniform() * size); }
  // Standard normal.
  double Normal();
  // Nearly so, for noise in bulk: the sum of eight small numbers, never beyond 4.9.
  double QuickNormal();

 private:
  uint64_t state_;
};

// Smooth noise in the plane (value noise on the unit lattice, continuously differentiable), zero
// mean, within [-1, 1], standard deviation near 0.4.
double SmoothNoise(uint64_t key, double x, double y);

// Two octaves of SmoothNoise scaled to standard deviation near 1; features of size 1.
double Roughness(uint64_t key, double x, double y);

}  // namespace semantic_kiss::simulation

#endif  // SEMANTIC_KISS_SIMULATION_RANDOM_H_
