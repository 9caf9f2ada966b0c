// SPDX-License-Identifier: GPL-3.0-or-later
#include "fluid/joints/flow_scene.hpp"

#include "bridge/checkpoint/archive.hpp"

namespace blockweir::scene {

template <class Archive>
void serialize(Archive& archive, Material& material) {
  archive(material.density_kg_per_m3);
}
template <class Archive>
void serialize(Archive& archive, Block& block) {
  archive(block.name, block.material, block.vertices, block.fixed);
}
template <class Archive>
void serialize(Archive& archive, JointLaw& law) {
  archive(law.uplift, law.hydraulic_aperture_m, law.least_aperture_m, law.largest_aperture_m,
          law.aperture_stiffness_pa_per_m, law.aperture_pressure_pa);
}
template <class Archive>
void serialize(Archive& archive, Joint& joint) {
  archive(joint.name, joint.between, joint.law);
}
template <class Archive>
void serialize(Archive& archive, Support& support) {
  archive(support.block);
}
template <class Archive>
void serialize(Archive& archive, ViscousFace& face) {
  archive(face.block);
}
template <class Archive>
void serialize(Archive& archive, DrainLine& drain) {
  archive(drain.name, drain.from_m, drain.to_m, drain.head_m, drain.efficiency);
}
template <class Archive>
void serialize(Archive& archive, Grout& grout) {
  archive(grout.name, grout.outline_m, grout.aperture_factor);
}
template <class Archive>
void serialize(Archive& archive, JointFlow& flow) {
  archive(flow.kind, flow.viscosity_pa_s, flow.bulk_modulus_pa, flow.panels_per_joint, flow.drains, flow.grouts);
}
template <class Archive>
void serialize(Archive& archive, Scene& scene) {
  archive(scene.materials, scene.blocks, scene.default_joint, scene.joints, scene.supports, scene.viscous_faces,
          scene.joint_flow, scene.fluid);
  archive(scene.water.density_kg_per_m3, scene.water.open_crack_width_m, scene.water.elements_per_face);
  archive(scene.analysis.gravity_m_per_s2, scene.analysis.reuse_factors);
  archive(scene.output.history_every_s, scene.output.frame_every_s);
}

}  // namespace blockweir::scene

namespace blockweir::joints {

template <class Archive>
void serialize(Archive& archive, GroundCut& cut) {
  archive(cut.left, cut.right, cut.bottom_m);
}
template <class Archive>
void serialize(Archive& archive, FlowScene& scene) {
  archive(scene.scene, scene.ground);
}

std::string pack(const FlowScene& scene) {
  return checkpoint::pack(scene);
}

FlowScene unpack_flow_scene(const std::string& bytes) {
  FlowScene scene;
  checkpoint::unpack(bytes, scene);
  return scene;
}

}  // namespace blockweir::joints
