// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/openfoam/plugin/session.hpp"

#include <fmt/format.h>
#include <fvc.H>
#include <surfaceFields.H>

#include <algorithm>
#include <cmath>

#include "bridge/checkpoint/archive.hpp"
#include "bridge/results/seconds.hpp"
#include "bridge/results/stopwatch.hpp"
#include "bridge/wire/way_in_window.hpp"

namespace blockweir::openfoam {

defineTypeNameAndDebug(Session, 0);

namespace {

using Clock = std::chrono::steady_clock;

const char* const name_in_registry = "blockweirSession";

Foam::IOobject place_in_registry(const Foam::fvMesh& mesh) {
  return Foam::IOobject(name_in_registry, mesh.time().timeName(), mesh, Foam::IOobject::NO_READ,
                        Foam::IOobject::NO_WRITE);
}

Foam::IOobject place_of_dictionary(const Foam::fvMesh& mesh) {
  return Foam::IOobject("blockweir", mesh.time().constant(), mesh.time(), Foam::IOobject::MUST_READ,
                        Foam::IOobject::NO_WRITE);
}

/// Where blocks would have set out from, given their velocities at both ends of a window.
std::vector<Pose> set_out_from(const wire::Motion& end, const std::vector<Pose>& first_velocity, double window_s) {
  std::vector<Pose> start = end.displacement.values();
  for (std::size_t b = 0; b < start.size(); ++b) {
    for (std::size_t k = 0; k < start[b].size(); ++k) {
      start[b][k] -= window_s * (first_velocity[b][k] + end.velocity[b][k]) / 2;
    }
  }
  return start;
}

/// On the cubic that leaves and arrives with the solid's own velocities.
void on_the_way(const Course& c, double part, std::vector<Pose>& into) {
  into.resize(c.end.size());
  for (std::size_t b = 0; b < into.size(); ++b) {
    for (std::size_t k = 0; k < into[b].size(); ++k) {
      const double way = c.end[b][k] - c.start[b][k];
      const double from = c.duration_s * c.start_velocity[b][k];
      const double to = c.duration_s * c.end_velocity[b][k];
      into[b][k] = wire::way_in_window(c.start[b][k], way, from, to, part);
    }
  }
}

}  // namespace

Session::Session(const Foam::fvMesh& mesh)
    : Foam::regIOobject(place_in_registry(mesh)),
      mesh_(mesh),
      time_(const_cast<Foam::Time&>(mesh.time())),
      dict_(place_of_dictionary(mesh)),
      interface_(read_interface(dict_)),
      partner_(interface_),
      checkpoints_(std::string(mesh.time().globalPath()), "openfoam", interface_.hello.scene_digest, 0),
      blocks_(mesh, interface_),
      water_(mesh, blocks_),
      levels_(mesh, dict_, blocks_),
      edges_(blocks_, water_),
      flow_(interface_.flow_in_joints ? std::make_unique<JointFlow>(mesh, blocks_) : nullptr),
      added_mass_(mesh, blocks_, edges_),
      breach_(mesh, dict_, blocks_),
      rest_(mesh, dict_, blocks_, levels_),
      record_(mesh, blocks_, interface_.hello.first_window > 0) {
  check_agreement();
  if (dict_.found("groundAccelerationX")) {
    ground_x_ = Foam::Function1<Foam::scalar>::New("groundAccelerationX", dict_);
    ground_y_ = Foam::Function1<Foam::scalar>::New("groundAccelerationY", dict_);
  }
  if (dict_.get<Foam::Switch>("openEnds")) {
    for (const auto side : {OpenEnd::Side::upstream, OpenEnd::Side::downstream}) {
      const bool upstream = side == OpenEnd::Side::upstream;
      if (dict_.found(upstream ? "upstreamLevel" : "downstreamLevel"))
        open_ends_.emplace_back(mesh, blocks_, dict_, side);
    }
  }
  if (interface_.hello.first_window > 0) {
    resume();
    return;
  }
  const auto first = partner_.receive(0);
  if (!first) partner_.fail("the solid process ended the run before it began");
  course_.end = first->displacement.values();
  course_.end_velocity = first->velocity.values();
  place_blocks();
  if (interface_.own_case) {
    const std::string unfit = levels_.unfit_at_start();
    if (!unfit.empty()) partner_.fail(unfit);
  }
  exchange();
}

/// Where they were told to be last, at rest.
void Session::place_blocks() {
  const Stopwatch watch(mapping_s_);
  blocks_.move(course_.end, course_.end, 1);
}

/// interFoam has read its fields of that time by itself.
void Session::resume() {
  const std::uint64_t next = interface_.hello.first_window;
  double field_time_s = 0;
  std::vector<Pose> cut_at;
  std::string flow;
  checkpoint::unpack(checkpoints_.read(next), field_time_s, time_s_, course_.end, course_.end_velocity, cut_at,
                     added_mass_, breach_, record_, flow);
  if (flow_) flow_->restore(flow);
  if (std::abs(field_time_s - time_.value()) > 1e-9 * interface_.hello.window_s) {
    partner_.fail(fmt::format("checkpoint {} is of {:.9g} s, but interFoam starts at {:.9g} s", next, field_time_s,
                              time_.value()));
  }
  window_ = next - 1;
  blocks_.cut_again(cut_at);
  place_blocks();
  if (const auto motion = await_motion()) start_window(*motion);
}

/// Fields are saved in a time folder of their own, other data beside it once all ranks have written theirs.
void Session::save() {
  time_.writeNow();
  bool all_have = true;
  Foam::reduce(all_have, Foam::andOp<bool>());  // waits for them
  if (!Foam::Pstream::master()) return;
  checkpoints_.write(window_ + 1,
                     checkpoint::pack(time_.value(), time_s_, course_.end, course_.end_velocity, blocks_.poses(),
                                      added_mass_, breach_, record_, flow_ ? flow_->state() : std::string()));
}

Session::~Session() = default;

/// A case that somebody has changed, or a user's own, must speak of the same water.
void Session::check_agreement() {
  constexpr double rounding = 1e-9;
  if (std::abs(water_.water_density() / interface_.water_density - 1) > rounding) {
    partner_.fail(fmt::format(
        "water density: constant/transportProperties has {:.10g} kg/m3, the scene {:.10g}; make density_kg_per_m3 in "
        "[water] and rho of water the same",
        water_.water_density(), interface_.water_density));
  }
  if (!(water_.air_density() > 0 && water_.air_density() < water_.water_density())) {
    partner_.fail(
        fmt::format("air density: constant/transportProperties has {:.10g} kg/m3; expected one above 0 and below the "
                    "water's {:.10g}",
                    water_.air_density(), water_.water_density()));
  }
  const auto& g = time_.lookupObject<Foam::uniformDimensionedVectorField>("g").value();
  if (Foam::mag(g - Foam::vector(0, -interface_.gravity, 0)) > rounding * interface_.gravity) {
    partner_.fail(fmt::format(
        "gravity: constant/g has ({:.10g} {:.10g} {:.10g}) m/s2, the scene (0 {:.10g} 0); make gravity_m_per_s2 in "
        "[analysis] and constant/g the same",
        g.x(), g.y(), g.z(), -interface_.gravity));
  }
}

Session* Session::of(const Foam::fvMesh& mesh) {
  return mesh.foundObject<Session>(name_in_registry) ? &mesh.lookupObjectRef<Session>(name_in_registry) : nullptr;
}

void Session::begin_step() {
  if (placed_at_ == time_.timeIndex()) return;
  placed_at_ = time_.timeIndex();
  if (!attached_) {
    partner_.fail(
        "system/controlDict has no function object of type blockweirSchedule: the water would run without the blocks");
  }
  on_the_way(course_, static_cast<double>(step_) / steps_, step_start_);
  on_the_way(course_, static_cast<double>(step_ + 1) / steps_, step_end_);
  if (step_ + 1 == steps_) step_end_ = course_.end;
  const Stopwatch watch(mapping_s_);
  blocks_.move(step_start_, step_end_, time_.deltaTValue());
  for (OpenEnd& end : open_ends_) end.set(time_.value());
}

void Session::end_step() {
  if (++step_ == steps_) return exchange();
  partner_.come_further(fmt::format("window {}: step {} of {}", window_, step_, steps_));
}

/// Pressures of now are said, the blocks' next places are heard: at once again, while nothing happens until then.
void Session::exchange() {
  if (windows_ > 0) steps_s_ += seconds_since(begun_) - (mapping_s_ - mapped_before_s_);
  sample();
  for (;;) {
    say();
    const auto motion = await_motion();
    if (!motion) return;
    const bool stores = flow_ && flow_->changes_by_itself();
    if (stores || !rest_.lasts(*motion, time_s_, course_.end)) return start_window(*motion);
    pass(*motion);
  }
}

void Session::say() {
  partner_.send(load_);
  const Stopwatch watch(output_s_);
  record_.add(load_.time_s, load_, course_.end_velocity, ground_acceleration().x());
  if (flow_) flow_->record(load_.time_s);
}

/// A window without a step: interFoam's clock is put to its end, its fields and the pressures stay as they are.
void Session::pass(const wire::Motion& motion) {
  ++window_;
  ++passed_;
  time_s_ = motion.time_s;
  time_.setTime(time_s_, time_.timeIndex());
  course_.end = motion.displacement.values();
  course_.end_velocity = motion.velocity.values();
  load_.window = window_;
  load_.time_s = time_s_;
}

void Session::sample() {
  const Stopwatch watch(mapping_s_);
  const std::string strayed = blocks_.strayed();
  if (!strayed.empty()) partner_.fail(strayed);
  load_.window = window_;
  load_.time_s = time_s_;
  load_.upstream_level_m = levels_.upstream_m(load_.time_s);
  load_.downstream_level_m = levels_.downstream_m(load_.time_s);
  if (flow_) flow_->begin(course_.end, load_);
  edges_.sample(flow_.get(), load_);
  load_.breached = breach_.look();
  added_mass_.measure(load_.added_mass.own());
  rest_.look(time_s_, course_.end);
}

/// The next window's motion, after a checkpoint where one is asked for; nothing when the solid has ended the run.
std::optional<wire::Motion> Session::await_motion() {
  for (std::uint64_t next = window_ + 1;; ++next) {
    auto motion = partner_.receive(next);
    if (!motion) {
      Foam::Info << "blockweir: the solid process has ended the run after window " << Foam::label(window_)
                 << Foam::endl;
      write_report();
      time_.writeAndEnd();
      return std::nullopt;
    }
    const bool begun = time_.timeIndex() > time_.startTimeIndex();  // at the start there is nothing to continue from
    if (motion->order != wire::Order::compute && begun) save();
    if (motion->order != wire::Order::save) return motion;  // else the solid says next why it stops
  }
}

void Session::start_window(const wire::Motion& motion) {
  ++window_;
  ++windows_;
  step_ = 0;
  const double from_s = time_s_;
  const double to_s = time_s_ = motion.time_s;
  // With the first pressures the blocks have settled before they moved: the water is not to feel that as a blow.
  course_.duration_s = to_s - from_s;
  course_.start = window_ == 1 ? set_out_from(motion, course_.end_velocity, course_.duration_s) : course_.end;
  course_.start_velocity = course_.end_velocity;
  course_.end = motion.displacement.values();
  course_.end_velocity = motion.velocity.values();
  const double wanted = (to_s - from_s) * crossings_per_s() / interface_.max_courant;
  constexpr double most_steps = 1e4;
  if (!(wanted < most_steps)) {
    partner_.fail("the water moves so fast that a window would take over 10,000 steps: the solution has diverged");
  }
  steps_ = std::max(interface_.steps_per_window, static_cast<int>(std::ceil(wanted)));
  time_.setDeltaT((to_s - from_s) / steps_, false);
  levels_.set(to_s);
  begun_ = Clock::now();
  mapped_before_s_ = mapping_s_;
}

Foam::vector Session::ground_acceleration() const {
  if (!ground_x_) return Foam::vector::zero;
  return {ground_x_->value(time_.value()), ground_y_->value(time_.value()), 0};
}

/// How often the water now crosses a cell, the largest of all: the Courant number of a step of 1 s.
double Session::crossings_per_s() const {
  if (!mesh_.foundObject<Foam::surfaceScalarField>("phi")) return 0;
  const auto& phi = mesh_.lookupObject<Foam::surfaceScalarField>("phi");
  const Foam::scalarField flux(Foam::fvc::surfaceSum(Foam::mag(phi))().primitiveField());
  return 0.5 * Foam::gMax(Foam::scalarField(flux / mesh_.V().field()));
}

}  // namespace blockweir::openfoam
