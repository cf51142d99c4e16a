// messages/...: from the state of the simulation to messages.
#include <benchmark/benchmark.h>
#include <ros/serialization.h>

#include "ice_ice_baby/each_collider.h"
#include "ice_ice_baby/simulation.h"
#include "markers.h"
#include "measure.h"
#include "particle_cloud.h"
#include "water_scenes.h"

namespace ice_ice_baby::bench {
namespace {

void oneThread(benchmark::internal::Benchmark* b) { sizes(b, {6000, 30000, 100000}, {1}); }

void sampleParticles(benchmark::State& state) {
  const auto simulation = makeSimulation(stillPool(std::size_t(state.range(0))));
  std::vector<ParticleSample> samples;
  for (auto _ : state) simulation->sample(samples);
  countParticles(state, samples.size());
}

void writeParticles(benchmark::State& state) {
  const std::vector<ParticleSample> samples(std::size_t(state.range(0)));
  sensor_msgs::PointCloud2 cloud;
  for (auto _ : state) writeCloud(samples, Colouring::kScene, cloud);
  countParticles(state, samples.size());
}

void serialiseParticles(benchmark::State& state) {
  sensor_msgs::PointCloud2 cloud;
  const std::vector<ParticleSample> samples(std::size_t(state.range(0)));
  writeCloud(samples, Colouring::kScene, cloud);
  for (auto _ : state) benchmark::DoNotOptimize(ros::serialization::serializeMessage(cloud));
  countParticles(state, samples.size());
}

void markSprings(benchmark::State& state) {
  const std::vector<SpringSample> springs(std::size_t(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(springMarkers(springs, std_msgs::Header(), 0.01, false));
  }
  countParticles(state, springs.size());
}

void markColliders(benchmark::State& state) {
  const auto simulation = makeSimulation(stillPool(1000));
  const Scene& scene = simulation->scene();
  std::vector<Posed> poses;
  forEachCollider(scene, [&](const Collider& collider) {
    poses.push_back(simulation->colliderPose(collider.name));
  });
  for (auto _ : state) {
    benchmark::DoNotOptimize(colliderMarkers(scene, poses, std_msgs::Header()));
  }
}

BENCHMARK(sampleParticles)->Name("messages/sample")->Apply(oneThread);
BENCHMARK(writeParticles)->Name("messages/cloud")->Apply(oneThread);
BENCHMARK(serialiseParticles)->Name("messages/serialise")->Apply(oneThread);
BENCHMARK(markSprings)->Name("messages/springs")->Apply(oneThread);
BENCHMARK(markColliders)->Name("messages/colliders")->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace
}  // namespace ice_ice_baby::bench
