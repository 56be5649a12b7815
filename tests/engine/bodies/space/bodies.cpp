#include "tests/engine/bodies/space/bodies.h"

#include <Eigen/Dense>

#include "models/space/rotation_vector.h"

namespace spoke::space::test {
namespace {

using ElementValues = Eigen::Matrix<double, 2 * kTwist, 1>;

/// Returns the coordinates of both nodes of an element, along its own axes.
ElementValues local_values(const FlexibleBody& body, int e, const Eigen::VectorXd& flex) {
  ElementValues values;
  const Matrix3 to_element = body.beam[static_cast<std::size_t>(e)].axes.transpose();
  for (int node = 0; node < 2; ++node) {
    Twist global = Twist::Zero();
    for (int c = 0; c < kTwist; ++c)
      if (const int at = body.coordinate(e + node, c); at >= 0) global[c] = flex[at];
    values.segment<kTwist>(kTwist * node) << to_element * linear(global),
        to_element * angular(global);
  }
  return values;
}

/// Returns the slots (r, t, d, g) of both nodes, along the axes of the element, less the place of
/// the node.
std::array<Position, kElementSlots> slot_changes(const ElementValues& x, double length) {
  std::array<Position, kElementSlots> slots;
  for (std::size_t node = 0; node < 2; ++node) {
    const Eigen::Index at = kTwist * static_cast<Eigen::Index>(node);
    const Position th = x.segment<3>(at + 3);
    slots[4 * node] = x.segment<3>(at);
    slots[4 * node + 1] = Position((x[6] - x[0]) / length, th.z(), -th.y());
    slots[4 * node + 2] = Position(-th.z(), 0.0, th.x());
    slots[4 * node + 3] = Position(th.y(), -th.x(), 0.0);
  }
  return slots;
}

/// Returns twice the energy that a tension by weights takes from an element.
double tension_form(const ElementStiffening& matrices, const Position& weights,
                    const ElementValues& x) {
  const Eigen::Vector4d v(x[1], x[5], x[7], x[11]), w(x[2], -x[4], x[8], -x[10]);
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double twist = x[9] - x[3];
    sum += weights[static_cast<int>(k)] *
           (v.dot(matrices.bending[k] * v) + w.dot(matrices.bending[k] * w) +
            matrices.torsion[k] * twist * twist);
  }
  return sum;
}

/// Returns twice the energy that the rotation of sections takes, to second order: a vector a of a
/// section becomes a + th x a + 1/2 th x (th x a), th linear between the nodes: by Gauss's rule of
/// two points.
double turning_form(const BeamElement& element, const Position& w, const ElementValues& x) {
  const Matrix3 W = skew(w);
  const Matrix3 P = element.axes.transpose() * element.stiffening.turning * element.axes;
  double sum = 0.0;
  for (const double xi : {-0.5 / std::sqrt(3.0), 0.5 / std::sqrt(3.0)}) {
    const Matrix3 th = skew(Position((0.5 - xi) * x.segment<3>(3) + (0.5 + xi) * x.segment<3>(9)));
    sum -= 0.5 * (W * th * th * P * W.transpose()).trace();
  }
  return sum;
}

/// Returns twice the energy that the rotation of small masses takes, to second order; `q`: of both
/// nodes, in B. A vector a of the section becomes a + th x a + 1/2 th x (th x a).
double inertia_form(const BeamElement& element, const Position& w, const ElementValues& local) {
  double sum = 0.0;
  ElementValues q;
  for (int block = 0; block < 4; ++block)
    q.segment<3>(3 * block) = element.axes * local.segment<3>(3 * block);
  for (const PointInertia& point : element.inertias) {
    const Matrix3 th = skew(point.rotation * q), W = skew(w);
    // The sum is |w x a|^2 to second order, over a a^T = P, less |w x (th x a)|^2, which slots
    // have.
    sum -= (W * th * th * point.second * W.transpose()).trace();
  }
  return sum;
}

}  // namespace

Position draw_vector(double size, std::mt19937& random) {
  std::uniform_real_distribution<double> draw(-size, size);
  return {draw(random), draw(random), draw(random)};
}

TestBody::TestBody(FlexibleBody made) : body(std::move(made)) {
  blocks = {make_elastic_block(body, kExplicit), make_elastic_block(body, kImplicit)};
  tension.carried = {{body.elements}};
  model = {&body, {&blocks[0], &blocks[1]}, &tension};
  q = v = q_elastic = v_elastic = Eigen::VectorXd::Zero(body.coordinates());
  memory.resize(count_work(body) / 2);
  work = place_work(body, reinterpret_cast<double*>(memory.data()));
}

Eigen::VectorXd TestBody::deformation_force() {
  calc_terms();
  Eigen::VectorXd force(body.coordinates());
  for (int k = 0; k < body.node_count(); ++k)
    for (int c = 0; c < kTwist; ++c)
      if (const int at = body.coordinate(k, c); at >= 0)
        force[at] = work.rows[kNodeRows * k + 4 * c + 3];
  return force;
}

void randomize_state(std::mt19937& random, TestBody& test) {
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (Eigen::Index i = 0; i < test.q.size(); ++i) {
    test.q[i] = 0.1 * draw(random);
    test.v[i] = draw(random);
    test.q_elastic[i] = 0.01 * draw(random);
    test.v_elastic[i] = draw(random);
  }
  test.motion = {draw_vector(3.0, random), draw_vector(3.0, random), draw_vector(9.0, random)};
  test.tension = {exponential(draw_vector(1.0, random)), draw_vector(2.0, random), {}};
  const int elements = test.body.elements;  // a child hangs in the middle, and one at the tip
  if (elements > 1) test.tension.carried.push_back({elements / 2, draw_vector(5.0, random), 2.9});
  test.tension.carried.push_back({elements, draw_vector(5.0, random), 1.7});
}

namespace {

std::unique_ptr<TestBody> make_body(Beam beam, int elements, ReferenceFrame frame,
                                    std::mt19937& random) {
  beam.damping << 1e-4, 2e-4, 3e-4, 4e-4, 5e-4, 6e-4;
  std::vector<int> handles{0, elements};
  if (elements > 2) handles.insert(handles.begin() + 1, elements / 2);
  auto test = std::make_unique<TestBody>(
      make_beam_body(beam, make_unequal_stations(beam, elements, random), frame, handles));
  test->damping = {0.3, 2e-3};
  randomize_state(random, *test);
  return test;
}

}  // namespace

std::unique_ptr<TestBody> make_random_body(const BeamOptions& options, int elements,
                                           ReferenceFrame frame, std::mt19937& random,
                                           bool is_nonlinear) {
  Beam beam = make_random_beam(options, random);
  beam.is_nonlinear = is_nonlinear;
  return make_body(std::move(beam), elements, frame, random);
}

std::unique_ptr<TestBody> make_decoupled_body(int elements, ReferenceFrame frame,
                                              std::mt19937& random) {
  SectionProperties section;
  section.axial_stiffness = 900.0;
  section.flap_stiffness = 3.0;
  section.lag_stiffness = 11.0;
  section.torsion_stiffness = 2.0;
  section.mass_per_length = 1.7;
  section.flap_inertia = 0.02;
  section.lag_inertia = 0.05;
  return make_body(make_uniform_beam(section, 2.5), elements, frame, random);
}

namespace {

/// Returns the mass that element `e` carries.
const CarriedMass& carried_by(int e, const TestBody& test) {
  const auto holds = [e](const CarriedMass& carried) { return e < carried.end; };
  return *std::find_if(test.tension.carried.begin(), test.tension.carried.end(), holds);
}

}  // namespace

double calc_kinetic(const TestBody& test, const Twist& twist, const Angular& hub_w,
                    const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  const FlexibleBody& body = test.body;
  const Position hub = test.tension.R_HB.inverse() * hub_w;
  // W0 = |w|^2 1 - w w^T, and its x row.
  const Position W0 = hub.squaredNorm() * Position::UnitX() - hub.x() * hub;
  double sum = 0.0;
  for (int e = 0; e < body.elements; ++e) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    const ElementValues x = local_values(body, e, q), rate = local_values(body, e, v);
    auto rho = slot_changes(x, element.length);
    const auto rho_rate = slot_changes(rate, element.length);
    const Matrix3 to_element = element.axes.transpose();
    const Position v0 = to_element * linear(twist), w = to_element * angular(twist);
    std::array<Position, kElementSlots> V;
    for (std::size_t i = 0; i < kElementSlots; ++i) {
      const std::size_t node = i / 4, slot = i % 4;
      rho[i] += slot == 0 ? Position(to_element * body.nodes[static_cast<std::size_t>(e) + node])
                          : Position(Position::Unit(static_cast<Eigen::Index>(slot) - 1));
      V[i] = cross(w, rho[i]) + rho_rate[i];
      if (slot == 0) V[i] += v0;
    }
    for (std::size_t i = 0; i < kElementSlots; ++i)
      for (std::size_t j = 0; j < kElementSlots; ++j)
        sum += element.mass(static_cast<int>(i), static_cast<int>(j)) * V[i].dot(V[j]);
    if (test.model.tension)
      sum -= tension_form(element.stiffening,
                          {W0.dot(carried_by(e, test).moment), W0.dot(test.tension.origin), W0.x()},
                          x) +
             turning_form(element, to_element * hub, x) + inertia_form(element, hub, x);
  }
  return 0.5 * sum;
}

double calc_tension_form(const TestBody& test, const Angular& hub_w, const Angular& turn,
                         const Eigen::VectorXd& q) {
  const FlexibleBody& body = test.body;
  const Position hub = test.tension.R_HB.inverse() * hub_w;
  const Position W0 = hub.squaredNorm() * Position::UnitX() - hub.x() * hub;
  double sum = 0.0;
  for (int e = 0; e < body.elements; ++e) {
    const BeamElement& element = body.beam[static_cast<std::size_t>(e)];
    const Matrix3 to_element = element.axes.transpose();
    ElementValues x = local_values(body, e, q);
    for (int node = 0; node < 2; ++node) {
      const Position& place = body.nodes[static_cast<std::size_t>(e + node)];
      x.segment<3>(kTwist * node) += to_element * cross(turn, place);
      x.segment<3>(kTwist * node + 3) += to_element * turn;
    }
    sum +=
        tension_form(element.stiffening,
                     {W0.dot(carried_by(e, test).moment), W0.dot(test.tension.origin), W0.x()}, x);
  }
  return sum;
}

double calc_potential(const TestBody& test, const Position& gravity, const Eigen::VectorXd& q) {
  const double along = (test.tension.R_HB.inverse() * gravity).x();
  double sum = q.dot(to_dense(test.body, test.body.K) * q);
  if (!test.model.tension) return 0.5 * sum;
  for (int e = 0; e < test.body.elements; ++e)
    sum += tension_form(test.body.beam[static_cast<std::size_t>(e)].stiffening,
                        along * Position(carried_by(e, test).mass, 1.0, 0.0),
                        local_values(test.body, e, q));
  return 0.5 * sum;
}

}  // namespace spoke::space::test
