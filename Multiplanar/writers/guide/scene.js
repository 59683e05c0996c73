// The model, what three.js draws of it, and the state of the page. The other scripts of the page follow it in the same
// function and share its names.

const model = JSON.parse(document.getElementById('model').textContent);
const $ = id => document.getElementById(id);
const last = model.steps.length; // state.step: 0 the finished model, 1..last a step
const state = {step: 0, explode: 0, labels: true, textures: true, ghost: false, selected: -1, playing: false};
const still = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
const vec = a => new THREE.Vector3(a[0], a[1], a[2]);
const up = vec(model.up);
const size = Math.hypot(...model.size);

function element(tag, text, className) {
  const e = document.createElement(tag);
  if (text !== undefined) e.textContent = text;
  if (className) e.className = className;
  return e;
}


let renderer;
try {
  const attributes = {antialias: true, alpha: true};
  // WebGL 2 where there is any: pictures of any size keep their pixels.
  const context = $('view').getContext('webgl2', attributes) || undefined;
  renderer = new THREE.WebGLRenderer({canvas: $('view'), context, ...attributes});
} catch (error) {
  $('stage').appendChild(element('div', 'This page needs WebGL, which this browser does not offer. ' +
      'assembly.pdf shows the same steps.', 'failed'));
  return;
}
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(30, 1, size / 100, size * 30);
camera.up.copy(up);
const controls = new THREE.OrbitControls(camera, $('view'));
controls.enableKeys = false;
controls.minDistance = size / 20;
controls.maxDistance = size * 10;
controls.addEventListener('change', draw);
scene.add(new THREE.HemisphereLight(0xffffff, 0xb9b2a6, 0.6));
const lamp = new THREE.DirectionalLight(0xffffff, 0.4);
lamp.position.set(-0.5, 0.8, 1);
camera.add(lamp);
scene.add(camera);
const all = new THREE.Group();
scene.add(all);

/// The solid of a part: group 0 the outer face, group 1 the rest.
function geometry(part) {
  const [o, u, v, n] = part.frame.map(vec), t = model.thickness;
  const loops = [part.outline].concat(part.holes), flat = [].concat(...loops);
  const at = (x, y, z) => o.clone().addScaledVector(u, x).addScaledVector(v, y).addScaledVector(n, -z);
  const positions = [], normals = [], uvs = [], index = [], lines = [];
  const picture = part.texture;
  const add = (p, normal, x, y) => {
    positions.push(p.x, p.y, p.z);
    normals.push(normal.x, normal.y, normal.z);
    uvs.push(picture ? (x - picture.origin[0]) / picture.width : 0, picture ? (y - picture.origin[1]) / picture.height : 0);
    return positions.length / 3 - 1;
  };
  const count = flat.length / 2, back = n.clone().negate();
  for (let i = 0; i < count; ++i) add(at(flat[2 * i], flat[2 * i + 1], 0), n, flat[2 * i], flat[2 * i + 1]);
  for (let i = 0; i < count; ++i) add(at(flat[2 * i], flat[2 * i + 1], t), back, 0, 0);
  for (const i of part.triangles) index.push(i);
  const outer = index.length;
  for (let i = 0; i < part.triangles.length; i += 3)
    index.push(count + part.triangles[i], count + part.triangles[i + 2], count + part.triangles[i + 1]);
  for (const loop of loops) {
    const m = loop.length / 2;
    for (let i = 0; i < m; ++i) {
      const j = (i + 1) % m, h = (i + m - 1) % m;
      const ax = loop[2 * i], ay = loop[2 * i + 1], bx = loop[2 * j], by = loop[2 * j + 1];
      const dx = bx - ax, dy = by - ay, length = Math.hypot(dx, dy);
      if (!(length > 0)) continue;
      const side = u.clone().multiplyScalar(dy / length).addScaledVector(v, -dx / length);
      const a0 = add(at(ax, ay, 0), side, 0, 0), a1 = add(at(ax, ay, t), side, 0, 0);
      const b1 = add(at(bx, by, t), side, 0, 0), b0 = add(at(bx, by, 0), side, 0, 0);
      index.push(a0, a1, b1, a0, b1, b0);
      const line = (p, q) => lines.push(p.x, p.y, p.z, q.x, q.y, q.z);
      line(at(ax, ay, 0), at(bx, by, 0));
      line(at(ax, ay, t), at(bx, by, t));
      const x = ax - loop[2 * h], y = ay - loop[2 * h + 1];
      if (Math.abs(Math.atan2(x * dy - y * dx, x * dx + y * dy)) > 0.4) line(at(ax, ay, 0), at(ax, ay, t));
    }
  }
  const solid = new THREE.BufferGeometry(), edges = new THREE.BufferGeometry();
  solid.setIndex(index);
  solid.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  solid.setAttribute('normal', new THREE.Float32BufferAttribute(normals, 3));
  solid.setAttribute('uv', new THREE.Float32BufferAttribute(uvs, 2));
  solid.addGroup(0, outer, 0);
  solid.addGroup(outer, index.length - outer, 1);
  edges.setAttribute('position', new THREE.Float32BufferAttribute(lines, 3));
  return {solid, edges};
}

const hasTextures = model.parts.some(p => p.texture);
model.parts.forEach((part, i) => {
  const shape = geometry(part);
  const faces = () => new THREE.MeshLambertMaterial({polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
  part.mesh = new THREE.Mesh(shape.solid, [faces(), faces()]);
  part.lines = new THREE.LineSegments(shape.edges, new THREE.LineBasicMaterial());
  part.mesh.userData.part = i;
  part.group = new THREE.Group();
  part.group.add(part.mesh, part.lines);
  all.add(part.group);
  part.explosion = vec(part.explode);
  part.normal = vec(part.frame[3]);
  part.middle = vec(part.frame[0]).addScaledVector(vec(part.frame[1]), part.label[0])
      .addScaledVector(vec(part.frame[2]), part.label[1]);
  if (part.texture) {
    part.image = new THREE.TextureLoader().load(part.texture.uri, () => refresh());
    part.image.anisotropy = renderer.capabilities.getMaxAnisotropy();
    if (!renderer.capabilities.isWebGL2) part.image.minFilter = THREE.LinearFilter;
  }
});

const arrow = new THREE.Group();
const arrowShaft = new THREE.Mesh(new THREE.CylinderBufferGeometry(1, 1, 1, 16), new THREE.MeshBasicMaterial());
const arrowHead = new THREE.Mesh(new THREE.ConeBufferGeometry(1, 1, 24), new THREE.MeshBasicMaterial());
arrow.add(arrowShaft, arrowHead);
scene.add(arrow);
