// Drawing, labels, the camera, and what moves.

let asked = false;
function draw() {
  if (asked) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    renderer.render(scene, camera);
    placeLabels();
  });
}

const labelOf = new Map();
function label(i) {
  if (!labelOf.has(i)) labelOf.set(i, $('labels').appendChild(element('span', model.parts[i].id)));
  return labelOf.get(i);
}
function placeLabels() {
  const w = $('stage').clientWidth, h = $('stage').clientHeight;
  model.parts.forEach((part, i) => {
    const fresh = isNew(part), wanted = isShown(part) && (fresh || i === state.selected || part.kind === 'panel') && state.labels;
    const p = part.middle.clone().add(part.group.position);
    const facing = part.normal.dot(camera.position.clone().sub(p).normalize());
    if (!wanted || (facing < 0.12 && !(fresh && part.kind === 'panel') && i !== state.selected) ||
        (part.kind !== 'panel' && i !== state.selected)) {
      if (labelOf.has(i)) labelOf.get(i).style.display = 'none';
      return;
    }
    p.project(camera);
    const tag = label(i);
    tag.className = fresh || i === state.selected ? 'new' : '';
    tag.style.display = '';
    tag.style.transform = `translate(${((p.x + 1) / 2 * w).toFixed(1)}px, ${((1 - p.y) / 2 * h).toFixed(1)}px) translate(-50%, -50%)`;
  });
}

function resize() {
  const w = $('stage').clientWidth, h = $('stage').clientHeight;
  renderer.setPixelRatio(window.devicePixelRatio || 1);
  renderer.setSize(w, h, false);
  camera.aspect = w / h;
  camera.setViewOffset(w, h, 0, Math.round(0.035 * h), w, h); // the bar is below
  camera.updateProjectionMatrix();
  draw();
}

// ---- The camera -----------------------------------------------------------------------------------------------------

const centre = vec(model.centre);
function distance() {
  const half = Math.tan(camera.fov * Math.PI / 360) * Math.min(1, camera.aspect);
  return 0.6 * size * (1 + 0.9 * state.explode / 100) / half;
}
function look(direction, animated) {
  const from = camera.position.clone().sub(controls.target), to = direction.clone().normalize().multiplyScalar(distance());
  const target = controls.target.clone();
  const go = f => {
    const d = from.clone().normalize().lerp(to.clone().normalize(), f);
    if (d.lengthSq() < 1e-6) d.copy(to);
    camera.position.copy(centre).addScaledVector(d.normalize(), from.length() + f * (to.length() - from.length()));
    controls.target.lerpVectors(target, centre, f);
    camera.position.add(controls.target).sub(centre);
    controls.update();
  };
  if (animated && !still) animate('camera', 450, f => { go(f); draw(); });
  else go(1);
}
/// Turns the camera, if it must, so that what faces along n is seen.
function see(n, animated) {
  const view = camera.position.clone().sub(controls.target).normalize();
  if (n.dot(view) > 0.2) return;
  const level = n.clone().addScaledVector(up, -n.dot(up));
  const height = Math.max(-0.45, Math.min(0.75, n.dot(up) + 0.15));
  if (level.lengthSq() < 0.01) level.copy(view).addScaledVector(up, -view.dot(up));
  look(level.normalize().multiplyScalar(Math.sqrt(1 - height * height)).addScaledVector(up, height), animated);
}

/// The new panel is seen from outside, the first from inside.
function seeNewParts(animated) {
  const step = model.steps[state.step - 1], part = model.parts[step.parts[0]];
  const n = part.kind === 'panel' ? part.normal.clone() : vec(step.direction);
  see(state.step === 1 ? n.negate() : n, animated);
}

const animations = new Map();
function animate(name, milliseconds, f, done) {
  const token = {};
  animations.set(name, token);
  const begin = performance.now();
  (function tick(now) {
    if (animations.get(name) !== token) return;
    const x = Math.min(1, Math.max(0, (now - begin) / milliseconds));
    f(1 - Math.pow(1 - x, 3));
    if (x < 1) requestAnimationFrame(tick);
    else {
      animations.delete(name);
      if (done) done();
    }
  })(begin);
}
